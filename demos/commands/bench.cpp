#include "commands.h"
#include "demos/bench/air.h"
#include "demos/bench/broadphase.h"
#include "demos/bench/ccd.h"
#include "demos/bench/contacts.h"
#include "demos/bench/core.h"
#include "demos/bench/detection.h"
#include "demos/bench/drape.h"
#include "demos/bench/pile.h"
#include "demos/bench/rods.h"
#include "demos/bench/scene.h"
#include "demos/bench/sheet.h"
#include "demos/runs/run_options.h"
#include "demos/tools/errors.h"
#include "demos/tools/words.h"

namespace plait {
namespace {

int bench(const Arguments& arguments) {
    const std::string what = arguments.operands.empty() ? "core" : arguments.operands[0];
    std::vector<std::string> names{"core",  "air",   "ccd",  "broadphase", "detection",
                                   "sheet", "drape", "rods", "pile",       "contacts"};
    for (const SceneEntry& entry : scenes())
        if (entry.name != "pile") names.push_back(entry.name);
    switch (parseChoice("bench", what, names)) {
        case 0:
            return benchCore();
        case 1:
            return benchAir();
        case 2:
            return benchCcd();
        case 3:
            return benchBroadPhase();
        case 4:
            return benchDetection();
        case 5:
            return benchSheet(requestedThreads(arguments));
        case 6:
            return benchDrape(requestedThreads(arguments));
        case 7:
            return benchRods();
        case 8:
            return benchPile(requestedThreads(arguments));
        case 9:
            return benchContacts(requestedThreads(arguments));
        default:
            return benchScene(what, requestedThreads(arguments));
    }
}

}  // namespace

Command benchCommand() {
    return {
        .name = "bench",
        .operands = {"[core|air|ccd|broadphase|detection|sheet|drape|rods|pile|contacts|SCENE]"},
        .meaning =
            "prints speeds: of a constraint, of the air, of collision queries, of the broad "
            "phase, of looking for contacts, of sheets that do not stretch, of one that falls on a "
            "ball, of rods, of a heap of shards, of what contacts cost, or of a scene from numbers "
            "to film",
        .options = {threadsOption()},
        .examples = {"bench core", "bench hanging-sheet"},
        .run = bench};
}

}  // namespace plait
