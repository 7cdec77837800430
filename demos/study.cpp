#include "commands.h"
#include "errors.h"
#include "files.h"
#include "study/certificate.h"
#include "study/phase_plane.h"
#include "study/reference.h"
#include "study/report.h"
#include "study/tasks.h"
#include "words.h"

#include <cstdio>

namespace plait {
namespace {

int listStudies() {
    for (const Study& study : studies())
        std::printf("%-20s %s\n", study.name.c_str(), study.title.c_str());
    std::printf("%-20s %s\n", "phase-plane", phasePlaneFigure().title.c_str());
    std::printf("%-20s %s\n", "certificate", certificateTitle);
    return exitOk;
}

// Closed forms instead of a reference, and nothing to sweep.
int phasePlane(const Arguments& given) {
    for (const auto& [option, values] : given.options)
        if (option != "out" && option != "quiet")
            throw UsageError("--" + option + ": phase-plane has nothing to sweep");
    const std::filesystem::path folder = given.value("out", "out/study/phase-plane");
    writePhasePlane(folder);
    if (!given.has("quiet")) std::printf("%s\n", (folder / "index.html").c_str());
    return exitOk;
}

int certificate(const Arguments& given) {
    for (const auto& [option, values] : given.options)
        if (option != "out" && option != "quiet")
            throw UsageError("--" + option + ": certificate has nothing to sweep");
    writeCertificate(given.value("out", "out/study/certificate"), given.has("quiet"));
    return exitOk;
}

int writeTasks(const Study& study, const std::vector<StudyTask>& tasks, const Arguments& given) {
    std::string lines;
    for (const StudyTask& task : tasks)
        lines += "build/plait study " + study.name + " --out " +
                 given.value("out", "out/study/" + study.name) + " --task " + wordOf(task) + "\n";
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

int study(const Arguments& given) {
    if (given.operands.empty()) return listStudies();
    if (given.operands[0] == "phase-plane") return phasePlane(given);
    if (given.operands[0] == "certificate") return certificate(given);
    const Study& study = studyNamed(given.operands[0]);
    const int repeats =
        static_cast<int>(parseInteger("--repeats", given.value("repeats", "5"), 1, 1000));
    const int jobs = static_cast<int>(parseInteger("--jobs", given.value("jobs", "1"), 1, 1024));
    const std::vector<StudyTask> tasks = tasksOf(study, repeats);
    if (given.has("tasks")) return writeTasks(study, tasks, given);
    const StudyFolder folder(study, given.value("out", "out/study/" + study.name));
    if (given.has("task")) return runTask(study, folder, given.value("task"));
    const bool quiet = given.has("quiet");
    const Reference reference = keptReference(study, folder.referencePath());
    if (!quiet) std::printf("%s\n\n", describe(study, reference).c_str());
    if (!given.has("collect")) executeAll(study, tasks, reference, folder, jobs, quiet);
    std::string command = "build/plait study " + study.name;
    for (const auto& [option, values] : given.options)
        command += " --" + option + (values[0].empty() ? "" : " " + values[0]);
    const std::string text = writeReport(study, folder.rows(), reference, folder, command);
    if (!quiet) std::printf("%s\n%s\n", text.c_str(), (folder.path() / "index.html").c_str());
    return exitOk;
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
                        {"out", "DIR", "where it is kept: out/study/SCENE"},
                        {"quiet", "", "no progress, no closing lines"}},
            .examples = {"study", "study pendulum", "study chain --tasks tasks.txt",
                         "study chain --collect"},
            .run = study};
}

}  // namespace plait
