#include "commands.h"
#include "demos/catalogue/site.h"
#include "demos/runs/run_options.h"
#include "demos/tools/errors.h"
#include "demos/tools/words.h"

#include <cstdio>

namespace plait {
namespace {

int catalogue(const Arguments& given) {
    SiteOptions options;
    options.out = given.value("out", options.out.string());
    options.runs = given.value("runs", options.runs.string());
    options.sources = given.value("sources", options.sources.string());
    options.quality = given.value("quality", options.quality);
    parseChoice("--quality", options.quality, qualityNames());
    options.only = given.value("only");
    options.film = given.has("film");
    options.threads = requestedThreads(given);
    options.quiet = given.has("quiet");
    const std::filesystem::path page = makeSite(options);
    std::printf("%s\n", page.c_str());
    return exitOk;
}

}  // namespace

Command catalogueCommand() {
    return {
        .name = "catalogue",
        .operands = {},
        .meaning = "a site that teaches every effect, made from what runs and studies left",
        .options =
            {{.name = "only", .argument = "SCENE", .meaning = "the page of this scene"},
             {.name = "quality",
              .argument = "draft|preview|final",
              .meaning = "whose schedules, bands and sizes are shown; draft",
              .letter = 'q'},
             {.name = "film",
              .argument = "",
              .meaning = "films first what is not there yet: scenes, and knobs at three values; "
                         "goes on where it was stopped"},
             threadsOption(),
             {.name = "out", .argument = "DIR", .meaning = "where it goes: out/catalogue"},
             {.name = "runs", .argument = "DIR", .meaning = "where runs and studies are: out"},
             {.name = "sources",
              .argument = "DIR",
              .meaning = "where core, scenes, tests and golden are: here"},
             quietOption()},
        .examples = {"catalogue", "catalogue --only flag", "catalogue --film --only pendulum"},
        .run = catalogue};
}

}  // namespace plait
