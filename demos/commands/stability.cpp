#include "commands.h"
#include "demos/stability/atlas.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/words.h"

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
void bless(const StabilityMap& map, const std::vector<Boundary>& boundaries,
           const std::filesystem::path& path) {
    if (std::filesystem::exists(path))
        for (const std::string& line :
             complaints(map, boundariesFrom(readWhole(path), path.string()), boundaries))
            std::printf("%s\n", line.c_str());
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
    const std::filesystem::path stored = "golden/stability/" + map.name + ".csv";
    if (given.has("bless") && map.boundaryAt.empty())
        throw UsageError(map.name + " has no boundaries to bless");
    if (given.has("bless") && !std::filesystem::is_directory(stored.parent_path()))
        throw FileError(
            "golden/stability: no such folder here; bless from the root of the sources");
    const std::filesystem::path folder = given.value("out", "out/stability/" + map.name);
    makeFolder(folder);
    const Atlas atlas = workOut(map, cells, jobs, given.has("quiet"), folder / "done.csv");
    writeAtlas(map, atlas, folder, given.line);
    if (!given.has("quiet")) {
        if (!atlas.boundaries.empty())
            std::printf("%s\n", boundaryText(map, atlas.boundaries).c_str());
        std::printf("%s\n", (folder / "index.html").c_str());
    }
    if (given.has("bless")) bless(map, atlas.boundaries, stored);
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
