#include "reference.h"

#include "demos/study/solve.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/progress.h"
#include "demos/tools/words.h"

#include <charconv>
#include <cmath>

namespace plait {
namespace {

// What a kept reference is of.
std::string headerOf(const Study& study) {
    return "# " + study.reference.words + "\n# " + study.reference.confirmingWords + "\n" +
           textOf(studySettings(study, {}));
}

}  // namespace

Reference findReference(const Study& study, bool quiet) {
    Reference reference;
    if (!study.reference.solve) return reference;
    const Run run = studyRun(study, {});
    const int prelude = study.prelude.empty() ? 0 : studyRun(study, study.prelude).frames();
    const int solutions = study.reference.confirm ? 3 : 1;
    Progress progress("reference of " + study.name, 0, prelude + solutions * run.frames(), quiet);
    progress.follow();
    if (!study.reference.confirm) {
        reference.trajectory = study.reference.solve(run, 0);
        reference.frames = run.frames();
        return reference;
    }
    const Trajectory coarse = study.reference.solve(run, 0);
    reference.trajectory = study.reference.solve(run, 1);
    const Trajectory other = study.reference.confirm(run);
    const int moving = movingVertices(run.scene.world);
    const auto converged = [&](int frame) {
        const double trust = study.reference.trust * study.size;
        return rmsDistanceAt(coarse, reference.trajectory, frame, moving) < trust &&
               rmsDistanceAt(other, reference.trajectory, frame, moving) < trust;
    };
    while (reference.frames < run.frames() && converged(reference.frames)) ++reference.frames;
    if (reference.frames == 0) return reference;
    reference.selfDifference = rmsDistance(coarse, reference.trajectory, reference.frames, moving);
    reference.confirmation = rmsDistance(other, reference.trajectory, reference.frames, moving);
    return reference;
}

Reference keptReference(const Study& study, const std::filesystem::path& file, bool quiet) {
    if (!study.reference.solve) return {};
    const std::string header = headerOf(study), mark = "differences=";
    if (std::filesystem::exists(file)) {
        const std::string whole = readWhole(file);
        const std::size_t end = whole.find('\n', header.size());
        if (whole.starts_with(header + mark) && end != std::string::npos) {
            const std::string line = whole.substr(0, end).substr(header.size() + mark.size());
            const std::size_t comma = line.find(','), second = line.find(',', comma + 1);
            Reference reference;
            reference.frames =
                static_cast<int>(parseInteger("frames", line.substr(0, comma), 0, 1000000));
            reference.selfDifference =
                parseNumber("difference", line.substr(comma + 1, second - comma - 1), 0, 1e9);
            reference.confirmation = parseNumber("difference", line.substr(second + 1), 0, 1e9);
            reference.trajectory = trajectoryFrom(whole.substr(end + 1), file.string());
            return reference;
        }
    }
    const Reference reference = findReference(study, quiet);
    writeWhole(file, header + mark + std::to_string(reference.frames) + "," +
                         text(reference.selfDifference) + "," + text(reference.confirmation) +
                         "\n" + csvOf(reference.trajectory));
    return reference;
}

std::string describe(const Study& study, const Reference& reference) {
    if (!study.reference.solve)
        return study.reference.words.empty() ? "none: statistics only" : study.reference.words;
    if (!study.reference.confirm) return study.reference.words;
    const Run run = studyRun(study, {});
    char line[200];
    std::snprintf(line, sizeof line,
                  "halving its step moves it by %.1e m, the other integrator by %.1e m (rms)",
                  reference.selfDifference, reference.confirmation);
    std::string words =
        study.reference.words + ", confirmed by " + study.reference.confirmingWords + "; " + line;
    if (reference.frames < run.frames())
        words += "; NOT converged after " + text(reference.frames / run.frameRate()) + " of " +
                 text(run.frames() / run.frameRate()) + " s, where the comparison ends";
    return words;
}

}  // namespace plait
