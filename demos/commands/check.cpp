#include "commands.h"
#include "demos/output/metric_table.h"
#include "demos/runs/run_options.h"
#include "demos/runs/simulation.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/progress.h"

#include <cstdio>

namespace plait {
namespace {

std::vector<MetricRow> simulate(const Run& run, const Arguments& arguments) {
    const auto simulation = makeSimulation(run, requestedThreads(arguments));
    settle(*simulation, run, arguments.has("quiet"));
    std::vector<MetricRow> rows{rowOf(simulation->frame())};
    Progress progress(run.entry->name, 0, run.frames(), arguments.has("quiet"));
    for (int i = 1; i <= run.frames(); ++i) {
        stopIfInterrupted();
        simulation->advance();
        rows.push_back(rowOf(simulation->frame()));
        progress.show(i);
    }
    return rows;
}

int judge(const Run& run, const std::vector<MetricRow>& rows) {
    std::printf("%s", verdictTable(run.scene.metrics, rows).c_str());
    const int last = rows.empty() ? -1 : rows.back().frame;
    const bool whole = last == run.frames();
    if (!whole) std::printf("stopped at frame %d of %d\n", last, run.frames());
    return whole && allWithinBands(run.scene.metrics, rows) ? exitOk : exitFailed;
}

bool isScene(const std::string& name) {
    for (const SceneEntry& entry : scenes())
        if (entry.name == name) return true;
    return false;
}

int check(const Arguments& arguments) {
    const std::string& name = arguments.operands[0];
    if (isScene(name) || !RunFolder::holdsRun(name)) {
        const Run run = makeRun(requestedSettings(arguments));
        return judge(run, simulate(run, arguments));
    }
    for (const auto& [option, values] : arguments.options)
        if (option != "quiet")
            throw UsageError("--" + option + " is for a scene; " + name + " is a run");
    const RunFolder folder(name);
    const Run run = folder.run();
    const std::string path = folder.metricsPath().string();
    return judge(run, rowsFrom(readWhole(path), run.scene.metrics, path));
}

}  // namespace

Command checkCommand() {
    std::vector<Option> options = stateOptions();
    options.push_back(threadsOption());
    options.push_back(quietOption());
    return {.name = "check",
            .operands = {"SCENE|RUN_DIR"},
            .meaning = "holds a run to the bands of its metrics",
            .options = options,
            .examples = {"check pendulum", "check out/pendulum"},
            .run = check};
}

}  // namespace plait
