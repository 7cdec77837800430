#include "render/pictures/compare.h"

#include "commands.h"
#include "demos/tools/errors.h"
#include "render/pictures/image.h"

#include <cstdio>

namespace plait {
namespace {

Picture read(const std::string& path) {
    try {
        return readPng(path);
    } catch (const std::runtime_error& error) {
        throw FileError(error.what());
    }
}

int compare(const Arguments& arguments) {
    const Picture a = read(arguments.operands[0]), b = read(arguments.operands[1]);
    const Comparison comparison = compare(a, b);
    const bool passed = passes(comparison, arguments.has("loose") ? looseRule : tightRule);
    std::printf("%s: %s\n", passed ? "alike" : "DIFFERENT", describe(comparison).c_str());
    return passed ? exitOk : exitFailed;
}

}  // namespace

Command compareCommand() {
    return {.name = "compare",
            .operands = {"A.png", "B.png"},
            .meaning = "tells how far two pictures are apart; 1 if further than a golden may be",
            .options = {{"loose", "", "as early frames may be, simulated anew"}},
            .examples = {"compare out/flag/frames/00001.png golden/flag/00001.png"},
            .run = compare};
}

}  // namespace plait
