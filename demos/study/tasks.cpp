#include "tasks.h"

#include "demos/runs/run_all.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/progress.h"
#include "demos/tools/words.h"
#include "solve.h"

#include <plait/measure/hash.h>

#include <algorithm>
#include <set>

namespace plait {

std::vector<StudyTask> tasksOf(const Study& study, int repeats) {
    std::vector<Settings> once{{}};
    std::set<std::string> seen{textOf(studySettings(study, {}))};
    for (const StudyCurve& curve : study.curves)
        for (const Settings& task : curve.tasks)
            if (seen.insert(textOf(studySettings(study, task))).second) once.push_back(task);
    std::vector<StudyTask> tasks;
    for (int repeat = 1; repeat <= repeats; ++repeat)
        for (const Settings& settings : once) tasks.push_back({settings, repeat});
    return tasks;
}

namespace {

std::vector<std::string> taskNames() {
    std::vector<std::string> names{"repeat"};
    for (const SettingOption& option : settingOptions()) names.push_back(option.name);
    return names;
}

}  // namespace

std::string wordOf(const StudyTask& task) {
    std::string word;
    for (const auto& [name, value] : task.settings) word += name + "=" + value + ",";
    return word + "repeat=" + std::to_string(task.repeat);
}

StudyTask taskFrom(const std::string& word) {
    StudyTask task;
    for (std::size_t begin = 0; begin < word.size();) {
        const std::size_t end = std::min(word.find(',', begin), word.size());
        const std::string part = word.substr(begin, end - begin);
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos)
            throw UsageError("--task: '" + part + "' is not NAME=VALUE, as substeps=16,repeat=2");
        const std::string name = part.substr(0, equals), value = part.substr(equals + 1);
        if (!name.starts_with("knob.")) parseChoice("--task", name, taskNames());
        if (name == "repeat")
            task.repeat = static_cast<int>(parseInteger("--task repeat", value, 1, 1000000));
        else
            task.settings.emplace_back(name, value);
        begin = end + 1;
    }
    return task;
}

StudyFolder::StudyFolder(const Study& study, std::filesystem::path path)
    : study_(study), path_(std::move(path)) {
    makeFolder(path_ / "rows");
}

std::filesystem::path StudyFolder::rowPath(const StudyTask& task) const {
    const std::string key =
        textOf(studySettings(study_, task.settings)) + std::to_string(task.repeat);
    char name[32];
    std::snprintf(name, sizeof name, "%016llx.csv",
                  static_cast<unsigned long long>(hashOf(std::span<const char>(key), hashSeed)));
    return path_ / "rows" / name;
}

bool StudyFolder::done(const StudyTask& task) const {
    const std::filesystem::path path = rowPath(task);
    if (!std::filesystem::exists(path)) return false;
    try {
        const std::vector<StudyRow> rows = rowsFrom(study_, readWhole(path), path.string());
        return rows.size() == 1 && rows[0].repeat == task.repeat &&
               rows[0].settings == studySettings(study_, task.settings);
    } catch (const FileError&) {  // of a study that was measured otherwise
        return false;
    }
}

void StudyFolder::clear(const std::string& word) const {
    if (!word.empty()) {
        std::filesystem::remove(rowPath(taskFrom(word)));
        return;
    }
    for (const auto& entry : std::filesystem::directory_iterator(path_ / "rows"))
        if (entry.path().extension() == ".csv") std::filesystem::remove(entry.path());
    std::filesystem::remove(referencePath());
}

std::vector<StudyRow> StudyFolder::rows() const {
    std::set<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(path_ / "rows"))
        if (entry.path().extension() == ".csv") paths.insert(entry.path());
    std::vector<StudyRow> rows;
    for (const std::filesystem::path& path : paths)
        for (const StudyRow& row : rowsFrom(study_, readWhole(path), path.string()))
            rows.push_back(row);
    return rows;
}

StudyRow execute(const Study& study, const StudyTask& task, const Reference& reference,
                 const StudyFolder& folder) {
    const Run run = studyRun(study, task.settings);
    const Recording recording = solve(study, run);
    const StudyRow row{.settings = settingsOf(run),
                       .repeat = task.repeat,
                       .ending = recording.ending,
                       .evaluations = recording.evaluations,
                       .seconds = recording.seconds,
                       .cpu = recording.cpu,
                       .errors = study.measure(study, run, recording, reference),
                       .hash = recording.hash};
    writeWhole(folder.rowPath(task), csvOf(study, {row}));
    return row;
}

int executeAll(const Study& study, const std::vector<StudyTask>& tasks, const Reference& reference,
               const StudyFolder& folder, int jobs, bool quiet) {
    std::vector<StudyTask> left;
    for (const StudyTask& task : tasks)
        if (!folder.done(task)) left.push_back(task);
    const int total = static_cast<int>(tasks.size()), count = static_cast<int>(left.size());
    Progress progress("study " + study.name, total - count, total, quiet, "runs");
    runAll(count, jobs, total - count, progress, [&](int i, int job) {
        pinThread(job);
        execute(study, left[static_cast<std::size_t>(i)], reference, folder);
    });
    return count;
}

}  // namespace plait
