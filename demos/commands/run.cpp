#include "commands.h"
#include "demos/output/export.h"
#include "demos/runs/run_job.h"
#include "demos/runs/run_options.h"
#include "demos/tools/errors.h"
#include "demos/tools/words.h"

#include <cstdio>

namespace plait {
namespace {

int run(const Arguments& arguments) {
    const Run run = makeRun(requestedSettings(arguments));
    RunJobOptions options;
    options.threads = requestedThreads(arguments);
    options.quiet = arguments.has("quiet");
    options.exports = arguments.values("export");
    for (const std::string& format : options.exports)
        parseChoice("--export", format, exportFormats());
    if (const PictureOptions pictures = requestedPictures(arguments, run);
        !arguments.has("no-render")) {
        options.pictures = pictures;
        options.pictures->keep = arguments.has("resume");
    }
    for (const std::string& warning : run.scene.world.warnings)
        std::fprintf(stderr, "plait: warning: %s\n", warning.c_str());

    RunJob job(run, options);
    const std::filesystem::path out = arguments.value("out", "out/" + run.entry->name);
    job.execute({out,
                 settingsOf(run),
                 {.resume = arguments.has("resume"), .replace = arguments.has("force")}});
    if (!options.quiet)
        std::printf("%s\n", (out / (options.pictures ? "clip.mp4" : "run.json")).c_str());
    return exitOk;
}

}  // namespace

Command runCommand() {
    std::vector<Option> options = stateOptions();
    const std::vector<Option> pictures = pictureOptions();
    options.insert(options.end(), pictures.begin(), pictures.end());
    options.push_back(threadsOption());
    options.push_back({"no-render", "", "no pictures"});
    options.push_back(
        {"export", "obj|ply|pc2", "meshes or points for other programs; repeatable", 0, true});
    options.push_back({"out", "DIR", "where it goes: out/SCENE otherwise"});
    options.push_back({"resume", "", "goes on where a run of these settings was stopped"});
    options.push_back({"force", "", "replaces a run of other settings"});
    options.push_back(quietOption());
    return {.name = "run",
            .operands = {"SCENE"},
            .meaning = "simulates a scene and films it",
            .options = options,
            .examples = {"run pendulum", "run pendulum -q draft --no-render --export obj",
                         "run strip-in-wind --substeps 40 --method nucleus --out out/weak",
                         "run hanging-sheet --resume"},
            .run = run};
}

}  // namespace plait
