#include "commands.h"
#include "demos/runs/settings.h"
#include "demos/tools/errors.h"

#include <cstdio>

namespace plait {
namespace {

int list(const Arguments& arguments) {
    const bool demosOnly = arguments.has("demos");
    for (const SceneEntry& entry : scenes()) {
        if (demosOnly && !entry.demo) continue;
        if (demosOnly)
            std::printf("%s\n", entry.name.c_str());
        else
            std::printf("%-16s %s%s\n", entry.name.c_str(), entry.demo ? "demo: " : "",
                        entry.lesson.c_str());
    }
    return exitOk;
}

}  // namespace

Command listCommand() {
    return {.name = "list",
            .operands = {},
            .meaning = "every scene and its lesson",
            .options = {{.name = "demos", .argument = "", .meaning = "names of the demos alone"}},
            .examples = {"list"},
            .run = list};
}

}  // namespace plait
