#include "commands.h"
#include "demos/runs/run_options.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/progress.h"

#include <algorithm>
#include <cstdio>

namespace plait {
namespace {

int render(const Arguments& arguments) {
    const RunFolder folder(arguments.operands[0]);
    const Run run = folder.run();
    PictureOptions options = requestedPictures(arguments, run);
    options.keep = arguments.has("resume");
    const int last = folder.lastFrame();
    if (last < options.first)
        throw FileError(folder.path().string() + ": no frame " + std::to_string(options.first) +
                        " in the cache; plait run --resume goes on");
    options.last = std::min(options.last, last);

    Pictures pictures(run, folder, options);
    Progress progress(run.entry->name, options.first - 1, options.last, arguments.has("quiet"));
    for (int i = 0; i <= options.last; ++i) {
        stopIfInterrupted();
        pictures.add(folder.frame(i));
        progress.show(pictures.done());
    }
    while (!pictures.finish(0.1)) {
        stopIfInterrupted();
        progress.show(std::min(pictures.done(), options.last - 1));
    }
    progress.show(options.last);
    if (!arguments.has("quiet")) std::printf("%s\n", (folder.path() / "clip.mp4").c_str());
    return exitOk;
}

}  // namespace

Command renderCommand() {
    std::vector<Option> options = pictureOptions();
    options.push_back({"resume", "", "keeps pictures that are there, of the same options"});
    options.push_back(quietOption());
    return {.name = "render",
            .operands = {"RUN_DIR"},
            .meaning = "films a run again, from its cache",
            .options = options,
            .examples = {"render out/pendulum --overlay strain --size 640x360"},
            .run = render};
}

}  // namespace plait
