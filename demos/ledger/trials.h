// Many trials of one run, each run once and kept in a folder.
#pragma once

#include "trial.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace plait {

struct LedgerOptions {
    double tolerance = 0.05;
    int jobs = 1;
    bool quiet = false;
};

class Trials {
public:
    // `verb` names them in the progress. What they are changes of outlives them.
    Trials(std::string verb, const Run& run, const LedgerOptions& options,
           const std::filesystem::path& folder);

    // As many as there are words; `make` gives the run of each. Words that this very build of
    // the program has tried before are not run again. Throws Interrupted.
    std::vector<Trial> of(const std::vector<std::string>& words,
                          const std::function<Run(int)>& make, const TrialLimit& limit) const;

private:
    std::string nameOf(const std::string& word) const;  // of the trial
    std::string keyOf(const std::string& word) const;   // and who ran it
    std::filesystem::path fileOf(const std::string& word) const;

    std::string verb_;
    const Run& run_;
    const LedgerOptions& options_;
    std::filesystem::path folder_;
};

// What a trial may take beside this one.
TrialLimit limitOf(const Trial& base);

// What of a metric's figures may change. That is the part `tolerance` of the width of its band, or,
// where it has no such, of what it goes through or comes to; nothing where the band has no width;
// and never less than twice what chance changes (nudged()).
struct MetricTolerance {
    Figures base, allowed;

    // The change of these figures, in what is allowed; infinite where nothing is.
    double changeOf(const Figures& figures) const;
};
// Of metric `column` about `base`; what chance changes is told by runs that differ by it alone.
MetricTolerance toleranceOf(const Metric& metric, std::size_t column, const Trial& base,
                            const std::vector<Trial>& twins, double tolerance);

// As printf() does; "beyond all" for what is infinite.
std::string rounded(const char* format, double value);

}  // namespace plait
