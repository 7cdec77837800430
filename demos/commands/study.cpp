#include "commands.h"
#include "demos/study/pages/certificate.h"
#include "demos/study/pages/collision.h"
#include "demos/study/pages/phase_plane.h"
#include "demos/study/references/reference.h"
#include "demos/study/report.h"
#include "demos/study/tasks.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/words.h"

#include <cstdio>

namespace plait {
namespace {

// Closed forms instead of a reference, and nothing to sweep.
struct ClosedForms {
    const char *name, *title;
    void (*write)(const std::filesystem::path& folder, bool quiet);
};
constexpr ClosedForms closedForms[] = {{"phase-plane", phasePlaneTitle, writePhasePlane},
                                       {"certificate", certificateTitle, writeCertificate},
                                       {"collision", collisionTitle, writeCollision}};

int listStudies() {
    for (const Study& study : studies())
        std::printf("%-20s %s\n", study.name.c_str(), study.title.c_str());
    for (const ClosedForms& study : closedForms) std::printf("%-20s %s\n", study.name, study.title);
    return exitOk;
}

int compareToClosedForms(const ClosedForms& study, const Arguments& given) {
    const std::string name = study.name;
    for (const auto& [option, values] : given.options)
        if (option != "out" && option != "quiet")
            throw UsageError("--" + option + ": " + name + " has nothing to sweep");
    study.write(given.value("out", "out/study/" + name), given.has("quiet"));
    return exitOk;
}

int writeTasks(const Study& study, const std::vector<StudyTask>& tasks, const Arguments& given) {
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe"),
                                out = std::filesystem::absolute(
                                    given.value("out", "out/study/" + study.name));
    std::string lines;
    for (const StudyTask& task : tasks)
        lines += shellWord(program) + " study " + study.name + " --out " + shellWord(out) +
                 " --task " + shellWord(wordOf(task)) + "\n";
    writeWhole(given.value("tasks"), lines);
    std::printf("%zu tasks in %s\n", tasks.size(), given.value("tasks").c_str());
    return exitOk;
}

int runTask(const Study& study, const StudyFolder& folder, const std::string& word) {
    const StudyTask task = taskFrom(word);
    studyRun(study, task.settings);  // throws before anything else is done
    const Reference reference = keptReference(study, folder.referencePath());
    if (!folder.done(task)) executeAll(study, {task}, reference, folder, 1, true);
    std::printf("%s", readWhole(folder.rowPath(task)).c_str());
    return exitOk;
}

int sweep(const Study& study, const Arguments& given) {
    const int repeats =
        static_cast<int>(parseInteger("--repeats", given.value("repeats", "5"), 1, 1000));
    const int jobs = static_cast<int>(parseInteger("--jobs", given.value("jobs", "1"), 1, 1024));
    const std::vector<StudyTask> tasks = tasksOf(study, repeats);
    const bool runs = !given.has("tasks") && !given.has("collect");
    if (given.has("force") && !runs) throw UsageError("--force: nothing is run here");
    if (given.has("tasks")) return writeTasks(study, tasks, given);
    const StudyFolder folder(study, given.value("out", "out/study/" + study.name));
    if (given.has("force")) folder.clear(given.value("task"));
    if (given.has("task")) return runTask(study, folder, given.value("task"));
    const bool quiet = given.has("quiet");
    const Reference reference = keptReference(study, folder.referencePath(), quiet);
    if (!quiet) std::printf("%s\n\n", describe(study, reference).c_str());
    if (runs) executeAll(study, tasks, reference, folder, jobs, quiet);
    const std::string text = writeReport(study, folder.rows(), reference, folder, given.line);
    if (!quiet) std::printf("%s\n%s\n", text.c_str(), (folder.path() / "index.html").c_str());
    return exitOk;
}

int study(const Arguments& given) {
    if (given.operands.empty()) return listStudies();
    std::vector<std::string> names;
    for (const Study& study : studies()) names.push_back(study.name);
    for (const ClosedForms& study : closedForms) names.emplace_back(study.name);
    const auto chosen = static_cast<std::size_t>(parseChoice("study", given.operands[0], names));
    const std::size_t swept = studies().size();
    return chosen < swept ? sweep(studies()[chosen], given)
                          : compareToClosedForms(closedForms[chosen - swept], given);
}

}  // namespace

Command studyCommand() {
    return {.name = "study",
            .operands = {"[SCENE]"},
            .meaning = "charts speed against accuracy, of every method and setting",
            .options = {{"repeats", "N", "times that each is run, in turns; 5"},
                        {"jobs", "N", "runs at a time, each on a core of its own; 1 is fair"},
                        {"tasks", "FILE", "writes a command a line instead, for any machine"},
                        {"task", "NAME=VALUE,...", "does one of them: these settings"},
                        {"collect", "", "reports what is done and runs nothing"},
                        {"force", "", "does again what is finished, reference and all"},
                        {"out", "DIR", "where it is kept: out/study/SCENE"},
                        {"quiet", "", "no progress, no closing lines"}},
            .examples = {"study", "study pendulum", "study chain --tasks tasks.txt",
                         "study chain --collect"},
            .run = study};
}

}  // namespace plait
