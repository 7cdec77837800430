// The runs of a study as tasks: each one self-contained, so that anything can run them, in any
// order and on any machine that sees the folder. A finished task leaves a row and is not done
// again.
#pragma once

#include "points.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plait {

struct StudyTask {
    Settings settings;  // on top of the model
    int repeat = 1;
};

// All curves and the scene's own settings, `repeats` times over, every task once in each round:
// methods take turns, so that a change of the machine's mood meets all of them.
std::vector<StudyTask> tasksOf(const Study& study, int repeats);

// "integrator=bdf2,substeps=16,repeat=2", and back. Throws UsageError.
std::string wordOf(const StudyTask& task);
StudyTask taskFrom(const std::string& word);

// out/study/NAME: rows/ with a file for each finished task, reference.csv, and the report.
class StudyFolder {
public:
    StudyFolder(const Study& study, std::filesystem::path path);

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path rowPath(const StudyTask& task) const;
    std::filesystem::path referencePath() const { return path_ / "reference.csv"; }
    // True if it was done with just these settings.
    bool done(const StudyTask& task) const;
    // Removes what is finished of the task of that word, or all of it and the reference for "".
    void clear(const std::string& word) const;
    // Every row there is, in the order of their names. Throws FileError.
    std::vector<StudyRow> rows() const;

private:
    const Study& study_;
    std::filesystem::path path_;
};

// Runs it and writes its row.
StudyRow execute(const Study& study, const StudyTask& task, const Reference& reference,
                 const StudyFolder& folder);

// Runs those that are not done on `jobs` threads, each on a core of its own; returns how many ran.
// Throws Interrupted with all finished rows in place.
int executeAll(const Study& study, const std::vector<StudyTask>& tasks, const Reference& reference,
               const StudyFolder& folder, int jobs, bool quiet);

}  // namespace plait
