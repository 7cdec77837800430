// Studies of cloth in contact. Its motion is chaotic, so that what is compared are statistics: the
// greatest strain, and how the cloth lies at the end.
#include "definitions.h"

#include <plait/contacts/search/nearest.h>
#include <plait/measure/surfaces/box_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace plait {
namespace {

using Points = std::vector<Vec<double>>;

constexpr double thickness = 0.0015;  // m, that of both scenes at draft

// m, of the mean of what moves.
double heightOf(const World& world, const Points& x) {
    double mass = 0, moment = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
        if (world.pinned[v]) continue;
        mass += world.mass[v];
        moment += world.mass[v] * x[v].y;
    }
    return moment / mass;
}

// Of the vertices that move, the part that lies on what is held: nearer to it than both thicknesses
// and half of one.
double lying(const World& world, const Points& x) {
    constexpr double touching = 2.5 * thickness;
    std::vector<std::array<int, 3>> body;
    std::vector<Box> boxes;
    for (int t = 0; t < world.complex.count(2); ++t) {
        const auto [a, b, c] = world.complex.triangle(t);
        if (!world.pinned[a] || !world.pinned[b] || !world.pinned[c]) continue;
        body.push_back({a, b, c});
        boxes.push_back(boxOf(std::array{x[a], x[b], x[c]}));
    }
    const BoxTree tree(boxes);
    const Vec<double> reached{touching, touching, touching};
    int moving = 0, touched = 0;
    for (int v = 0; v < static_cast<int>(x.size()); ++v) {
        if (world.pinned[v]) continue;
        bool near = false;
        tree.overlaps({x[v] - reached, x[v] + reached}, [&](int t) {
            const auto [a, b, c] = body[t];
            near |=
                length(nearest({{v, a, b, c}, 1, 3}, {x[v], x[a], x[b], x[c]}).apart) < touching;
        });
        ++moving;
        touched += near;
    }
    return static_cast<double>(touched) / moving;
}

std::vector<ErrorKind> lyingErrors() {
    return {{"worst", "greatest extension of a link in any frame / rest length"},
            {"height", "height of the middle of the cloth at the end, off the reference [m]"},
            {"lying", "part of the cloth that lies on the body at the end, off the reference"}};
}

// What has passed through anything is worthless.
std::vector<double> measureLying(const Study& study, const Run& run, const Recording& recording,
                                 const Reference& reference) {
    bool worthless = recording.ending != "complete";
    double worst = 0;
    for (const std::vector<double>& frame : recording.metrics) {
        worst = std::max(worst, frame[0] / 100);  // the scene's first metric, in %
        for (std::size_t m = 0; m < frame.size(); ++m)
            if (const std::string& name = run.scene.metrics[m].name;
                name == "crossings" || name == "inside")
                worthless |= frame[m] > 0;
    }
    if (worthless)
        return std::vector<double>(study.errors.size(), std::numeric_limits<double>::infinity());
    const World& world = run.scene.world;
    const Points &end = recording.positions.back(), &right = reference.trajectory.back();
    return {worst, std::fabs(heightOf(world, end) - heightOf(world, right)),
            std::fabs(lying(world, end) - lying(world, right))};
}

// Each of these values of a setting that `settings` leaves open.
StudyCurve over(const std::string& name, const Settings& settings, const std::string& setting,
                const std::vector<std::string>& values) {
    StudyCurve curve{name, {}};
    for (const std::string& value : values) curve.tasks.push_back(with(settings, setting, value));
    return curve;
}

Settings sweeping(const Settings& settings) { return with(settings, "precision", "float"); }

Study lyingStudy(const std::string& name, const std::string& title, const Settings& model) {
    Study study{.name = name,
                .title = title,
                .model = model,
                .gravity = down,
                .errors = lyingErrors(),
                .measure = measureLying};
    study.omissions = {
        "positions: where cloth folds is chaotic; of two runs that have converged height and part "
        "that lies differ too, which is the floor of their charts",
        "BDF2: it wants a converged solve"};
    return study;
}

}  // namespace

Study sphereStudy() {
    Study study =
        lyingStudy("sphere", "Sheet of 32 x 32 vertices that falls on a ball, 2 s",
                   {{"scene", "sheet-on-sphere"}, {"quality", "draft"}, {"seconds", "2"}});
    study.reference.words =
        "256 substeps a frame of 4 sweeps and 8 passes, mended to 0.1 %, in double";
    study.reference.solve = [=](const Run&, int) {
        return fine(study,
                    {{"precision", "double"},
                     {"iterations", "4"},
                     {"passes", "8"},
                     {"knob.mending", "0.1"}},
                    256);
    };
    const Settings own = sweeping({{"substeps", "16"}, {"iterations", "2"}});
    study.curves = {over("n x 2, 2 passes", sweeping({{"iterations", "2"}, {"passes", "2"}}),
                         "substeps", {"8", "16", "32", "64", "128"}),
                    over("n x 4, 4 passes", sweeping({{"iterations", "4"}, {"passes", "4"}}),
                         "substeps", {"8", "16", "32", "64"}),
                    over("n x 2, 2 passes, the ball a mesh",
                         sweeping({{"iterations", "2"}, {"passes", "2"}, {"knob.ball", "mesh"}}),
                         "substeps", {"8", "16", "32", "64"}),
                    over("16 x 2, 1 to 16 passes", own, "passes", {"1", "4", "8", "16"}),
                    over("16 x 2, mended to 0.1 to 5 %, or not", own, "knob.mending",
                         {"0.1", "0.2", "0.5", "2", "5", "0"})};
    return study;
}

Study dressStudy() {
    Study study = lyingStudy("dress", "The ballerina's dress at draft, as it falls on her: 0.5 s",
                             {{"scene", "dress"}, {"quality", "draft"}, {"seconds", "0.5"}});
    study.reference.words =
        "96 substeps a frame of 24 sweeps and passes, mended to 0.2 %, in double";
    study.reference.solve = [=](const Run&, int) {
        return fine(study,
                    {{"precision", "double"},
                     {"iterations", "24"},
                     {"passes", "24"},
                     {"knob.mending", "0.2"}},
                    96);
    };
    const Settings own = sweeping({{"substeps", "24"}, {"iterations", "24"}});
    study.curves = {over("n x 24, 24 passes", sweeping({{"iterations", "24"}, {"passes", "24"}}),
                         "substeps", {"12", "24", "48"}),
                    over("24 x 24, 4 to 48 passes", own, "passes", {"4", "12", "48"}),
                    over("24 x 24, mended to 0.2 to 5 %, or not", own, "knob.mending",
                         {"0.2", "0.5", "5", "0"})};
    return study;
}

}  // namespace plait
