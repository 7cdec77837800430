// Studies of rigid pieces. How a heap comes to lie is chaotic: what is compared is how still it
// lies, and what overlaps.
#include "definitions.h"

#include <algorithm>
#include <limits>
#include <string>

namespace plait {
namespace {

constexpr std::size_t overlapsMetric = 0, speedMetric = 1;  // of the scene

std::vector<double> measureHeap(const Study& study, const Run&, const Recording& recording,
                                const Reference&) {
    if (recording.ending != "complete")
        return std::vector<double>(study.errors.size(), std::numeric_limits<double>::infinity());
    double overlaps = 0;
    for (const std::vector<double>& frame : recording.metrics)
        overlaps = std::max(overlaps, frame[overlapsMetric]);
    return {recording.metrics.back()[speedMetric], overlaps};
}

StudyCurve passes(const std::string& name, const std::string& count,
                  const std::vector<int>& substeps) {
    return curve(name, {{"precision", "float"}, {"integrator", "bdf2"}, {"passes", count}},
                 substeps);
}

}  // namespace

Study pileStudy() {
    Study study{.name = "pile",
                .title = "160 shards of glass, 4 mm thick, 2 s after they were let go",
                .model = {{"scene", "pile"}, {"quality", "draft"}, {"seconds", "2"}},
                .gravity = down,
                .errors = {{"speed", "speed at rest, root of the mean square [m/s]"},
                           {"overlaps", "edges that go through faces, in any frame"}},
                .measure = measureHeap};
    study.reference.words = "none: what rests has speed 0, and nothing overlaps";
    const std::vector<int> steps{5, 10, 20, 40};
    study.curves = {passes("n x 1 pass", "1", steps), passes("n x 4 passes", "4", steps),
                    passes("n x 16 passes", "16", steps)};
    study.omissions = {
        "Box3D and Jolt: they were measured with 2,000 shards, at 1e-4 and 4e-3 m/s at rest, and "
        "overlap by 1.9 and 3.1 mm in the mean; `bench pile` prints them beside as many of ours"};
    return study;
}

}  // namespace plait
