#include "commands.h"
#include "demos/ledger/ledger.h"
#include "demos/ledger/tune.h"
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

// A run, what is asked about it, and the folder where the answer goes.
struct Question {
    Run run;
    LedgerOptions options;
    std::filesystem::path folder;
};

Question questionOf(const Arguments& given, const std::string& where,
                    const std::string& tolerance) {
    Question question{makeRun(requestedSettings(given)), {}, {}};
    question.folder = given.value("out", where + question.run.entry->name);
    question.options = {
        .tolerance = parseTolerance(given.value("tolerance", tolerance)),
        .jobs = static_cast<int>(parseInteger("--jobs", given.value("jobs", "1"), 1, 1024)),
        .quiet = given.has("quiet")};
    makeFolder(question.folder);
    return question;
}

void say(const Question& question, const std::string& text) {
    if (!question.options.quiet)
        std::printf("%s%s\n", text.c_str(), (question.folder / "index.html").c_str());
}

void checkBless(const Arguments& given, const std::string& folder) {
    if (given.has("bless") && !std::filesystem::is_directory(folder))
        throw FileError(folder + ": no such folder here; bless from the root of the sources");
}

void bless(const Arguments& given, const std::string& folder, const std::string& scene,
           const std::string& csv) {
    if (given.has("bless")) writeWhole(folder + "/" + scene + ".csv", csv);
}

int ablate(const Arguments& given) {
    const Question asked = questionOf(given, "out/ledger/", "5%");
    checkBless(given, "golden/ledger");
    const FolderLock lock(asked.folder);
    const Ledger ledger = ledgerOf(asked.run, asked.options, asked.folder);
    say(asked, writeLedger(ledger, asked.folder, given.line));
    bless(given, "golden/ledger", asked.run.entry->name, csvOf(ledger));
    return ledger.complaints().empty() ? exitOk : exitFailed;
}

int tuneScene(const Arguments& given) {
    const Question asked = questionOf(given, "out/tune/", "1%");
    checkBless(given, "golden/tune");
    const FolderLock lock(asked.folder);
    const Tuning tuning = tune(asked.run, asked.options, asked.folder);
    say(asked, writeTuning(tuning, asked.folder, given.line));
    bless(given, "golden/tune", asked.run.entry->name, csvOf(tuning));
    return exitOk;
}

std::vector<Option> optionsOf(const std::string& tolerance, const std::string& where,
                              const std::string& stored) {
    std::vector<Option> options = stateOptions();
    options.push_back(
        {"tolerance", tolerance, "of a metric's band, that it may move; " + tolerance});
    options.push_back({"jobs", "N", "runs at a time; 1"});
    options.push_back({"out", "DIR", "where it is kept: " + where});
    options.push_back({"bless", "", "stores what came of it in " + stored});
    options.push_back(quietOption());
    return options;
}

}  // namespace

Command ablateCommand() {
    return {.name = "ablate",
            .operands = {"SCENE"},
            .meaning = "leaves out each ingredient of a scene, and says which it needs",
            .options = optionsOf("5%", "out/ledger/SCENE", "golden/ledger"),
            .examples = {"ablate flag -q draft", "ablate pendulum --tolerance 1% --jobs 2"},
            .run = ablate};
}

Command tuneCommand() {
    return {.name = "tune",
            .operands = {"SCENE"},
            .meaning = "finds the cheapest settings that keep the metrics of a scene",
            .options = optionsOf("1%", "out/tune/SCENE", "golden/tune"),
            .examples = {"tune flag -q draft", "tune pendulum --tolerance 0.1% --jobs 2"},
            .run = tuneScene};
}

}  // namespace plait
