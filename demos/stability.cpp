#include "commands.h"
#include "errors.h"
#include "files.h"
#include "stability/atlas.h"
#include "words.h"

#include <cstdio>
#include <filesystem>

namespace plait {
namespace {

int listMaps() {
    for (const StabilityMap& map : stabilityMaps())
        std::printf("%-16s %s\n", map.name.c_str(), map.title.c_str());
    return exitOk;
}

// Stores the boundaries, and says which have moved.
void bless(const StabilityMap& map, const std::vector<Boundary>& boundaries) {
    const std::filesystem::path folder = "golden/stability", path = folder / (map.name + ".csv");
    if (!std::filesystem::is_directory("golden"))
        throw FileError("golden: no such folder here; bless from the root of the sources");
    if (std::filesystem::exists(path))
        for (const std::string& line :
             complaints(map, boundariesFrom(readWhole(path), path.string()), boundaries))
            std::printf("%s\n", line.c_str());
    makeFolder(folder);
    writeWhole(path, csvOf(boundaries));
    std::printf("%s\n", path.c_str());
}

int stability(const Arguments& given) {
    if (given.operands.empty()) return listMaps();
    const StabilityMap& map = stabilityMapNamed(given.operands[0]);
    const int quality =
        parseChoice("--quality", given.value("quality", "draft"), {"draft", "preview", "final"});
    const int cells = quality == 0 ? 9 : quality == 1 ? 19 : 37;
    const int jobs = static_cast<int>(parseInteger("--jobs", given.value("jobs", "1"), 1, 1024));
    const std::string folder = given.value("out", "out/stability/" + map.name);
    std::string command = "build/plait stability " + map.name;
    for (const auto& [option, values] : given.options)
        command += " --" + option + (values[0].empty() ? "" : " " + values[0]);
    const Atlas atlas = workOut(map, cells, jobs, given.has("quiet"));
    writeAtlas(map, atlas, folder, command);
    if (!given.has("quiet"))
        std::printf("%s\n%s/index.html\n", boundaryText(map, atlas.boundaries).c_str(),
                    folder.c_str());
    if (given.has("bless")) bless(map, atlas.boundaries);
    return exitOk;
}

}  // namespace

Command stabilityCommand() {
    return {.name = "stability",
            .operands = {"[MAP]"},
            .meaning = "maps where methods drift and explode, and where theory says so",
            .options = {{"quality", "draft|preview|final", "9, 19 or 37 cells along an axis", 'q'},
                        {"jobs", "N", "cells at a time; 1"},
                        {"bless", "", "stores the boundaries in golden/stability"},
                        {"out", "DIR", "where it is kept: out/stability/MAP"},
                        {"quiet", "", "no progress, no closing lines"}},
            .examples = {"stability", "stability step-stiffness",
                         "stability chain-length -q preview --jobs 2"},
            .run = stability};
}

}  // namespace plait
