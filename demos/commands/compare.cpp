#include "render/pictures/compare.h"

#include "commands.h"
#include "demos/tools/errors.h"
#include "render/pictures/image.h"

#include <cstdio>

namespace plait {
namespace {

std::string formOf(const PngFile& file) {
    return std::to_string(file.channels) + " x " + std::to_string(file.bits) + " bits";
}

int compare(const Arguments& arguments) {
    const PngFile a = readPngFile(arguments.operands[0]), b = readPngFile(arguments.operands[1]);
    const Comparison colors = compare(a.picture, b.picture);
    bool passed = passes(colors, arguments.has("loose") ? looseRule : tightRule);
    std::string words = describe(colors);
    if (colors.sameSize && a.alpha != b.alpha) {  // nothing that we draw has any
        passed = false;
        words += "; alpha: " + describe(compare(a.alpha, b.alpha));
    }
    if (formOf(a) != formOf(b)) words += "; channels: " + formOf(a) + " against " + formOf(b);
    std::printf("%s: %s\n", passed ? "alike" : "DIFFERENT", words.c_str());
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
