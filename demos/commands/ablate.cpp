#include "commands.h"
#include "demos/ledger/ledger.h"
#include "demos/runs/run_options.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/words.h"

#include <cstdio>
#include <filesystem>

namespace plait {
namespace {

// "5%" or "0.05".
double parseTolerance(std::string word) {
    const bool percent = word.ends_with('%');
    if (percent) word.pop_back();
    return parseNumber("--tolerance", word, 0, percent ? 100 : 1) / (percent ? 100 : 1);
}

int ablate(const Arguments& given) {
    const Run run = makeRun(requestedSettings(given));
    const std::filesystem::path folder = given.value("out", "out/ledger/" + run.entry->name);
    makeFolder(folder);
    const FolderLock lock(folder);
    if (given.has("force")) std::filesystem::remove_all(folder / "trials");
    const LedgerOptions options{
        .tolerance = parseTolerance(given.value("tolerance", "5%")),
        .jobs = static_cast<int>(parseInteger("--jobs", given.value("jobs", "1"), 1, 1024)),
        .quiet = given.has("quiet")};
    const Ledger ledger = ledgerOf(run, options, folder);
    const std::string text = writeLedger(ledger, folder, given.line);
    if (!options.quiet) std::printf("%s%s\n", text.c_str(), (folder / "index.html").c_str());
    return ledger.complaints().empty() ? exitOk : exitFailed;
}

}  // namespace

Command ablateCommand() {
    std::vector<Option> options = stateOptions();
    options.push_back({"tolerance", "5%", "of a metric's band that an ingredient may move; 5%"});
    options.push_back({"jobs", "N", "runs at a time; 1"});
    options.push_back(
        {"force", "", "does again what is finished, as after a change of the program"});
    options.push_back({"out", "DIR", "where it is kept: out/ledger/SCENE"});
    options.push_back(quietOption());
    return {.name = "ablate",
            .operands = {"SCENE"},
            .meaning = "leaves out each ingredient of a scene, and says which it needs",
            .options = options,
            .examples = {"ablate flag -q draft", "ablate pendulum --tolerance 1% --jobs 2"},
            .run = ablate};
}

}  // namespace plait
