// Small scenes in which matter meets matter, against mechanics.
#include "bands.h"
#include "tests/core/contacts/contact_worlds.h"
#include "tests/report.h"

#include <plait/contacts/search/nearest.h>
#include <plait/measure/energy.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81;

Scene sceneWith(const std::string& name, const std::string& knob, double value) {
    return draftOf(name, {{knob, value}});
}

int framesOf(const Scene& scene) { return static_cast<int>(24 * scene.seconds); }

}  // namespace

// While the cloth slides away below it, for T, a tin gains mu g T; then it slides on the table as
// far again before it stops.
TEST_CASE("tablecloth: friction alone moves what stands on it",
          "[contacts][friction][scenes][figures]") {
    struct Course {
        Range tin;
        double on = 0, off = 0, speed = 0;  // s, s, m/s
    };
    for (const double mu : {0.3, 0.15}) {
        const Scene scene = sceneWith("tablecloth", "friction", mu);
        // The flat ones: tall ones rock.
        std::array<Course, 2> courses{{{scene.view.looks[2].object}, {scene.view.looks[4].object}}};
        Solver<float> solver(scene.world, scene.options);
        for (int frame = 1; frame <= framesOf(scene); ++frame) {
            solver.frame();
            const Points x = solver.positions(), v = solver.velocities();
            for (Course& course : courses) {
                course.speed = std::max(course.speed, meanOf(v, course.tin).z);
                // Vertex 0 is at the cloth's rear hem.
                if (course.on == 0 && v[0].z > 0.05) course.on = solver.time();
                if (course.off == 0 && x[0].z > meanOf(x, course.tin).z) course.off = solver.time();
            }
        }
        for (const auto& [tin, on, off, speed] : courses) {
            const double moved =
                meanOf(solver.positions(), tin).z - meanOf(scene.world.start, tin).z;
            note("moved by, m", moved);
            CHECK(report("speed / mu g T", std::fabs(speed / (mu * g * (off - on)) - 1), 0.1));
            CHECK(
                report("way / (v^2 / mu g)", std::fabs(moved * mu * g / (speed * speed) - 1), 0.1));
        }
    }
}

TEST_CASE("tablecloth: nothing goes through the table at 8 m/s", "[contacts][scenes]") {
    const Scene scene = sceneWith("tablecloth", "speed", 8);
    holdToBands(scene, framesOf(scene));
}

TEST_CASE("tablecloth: nothing goes through the table at any speed", "[contacts][scenes][long]") {
    for (const double speed : {0.5, 1.0, 2.0, 3.0, 5.0, 6.0, 7.0}) {
        const Scene scene = sceneWith("tablecloth", "speed", speed);
        holdToBands(scene, framesOf(scene));
    }
}

// Nothing has restitution: what bounces has moved the sheet, and the sheet what lies on it.
TEST_CASE("trampoline: it throws back, and never more than fell on it", "[contacts][scenes]") {
    const Scene scene = sceneWith("trampoline", "drop", 0.5);
    const World& world = scene.world;
    const Range sheet = scene.view.looks[0].object, light = scene.view.looks[2].object,
                heavy = scene.view.looks[3].object;
    std::vector<std::array<int, 2>> edges;
    std::vector<double> rest;
    const std::vector<int> ids = edgeStencils(world.complex, sheet);
    for (std::size_t i = 0; i < ids.size(); i += 2) {
        edges.push_back({ids[i], ids[i + 1]});
        rest.push_back(length(world.rest[ids[i + 1]] - world.rest[ids[i]]));
    }
    const std::vector<double> soft(edges.size(), 1 / 250.0);
    std::vector<double> mass = world.mass;
    for (std::size_t v = 0; v < mass.size(); ++v)
        if (world.pinned[v]) mass[v] = 0;
    Solver<float> solver(world, scene.options);
    const auto energy = [&] {
        const Points x = solver.positions();
        return kineticEnergy(mass, solver.velocities()) + gravitationalEnergy(mass, x, {0, -g, 0}) +
               stretchEnergy(x, edges, rest, soft);
    };
    const double fall = 0.5, weight = 0.4 * g;  // m, N
    double start = 0, gained = 0, thrown = 0, back = 0;
    for (int frame = 1; frame <= 24; ++frame) {
        solver.frame();
        if (frame == 4) start = energy();  // once the threads have shared their tension
        if (frame > 4) gained = std::max(gained, energy() - start);
        const Points x = solver.positions();
        if (frame > 10) back = std::max(back, meanOf(x, heavy).y - 0.08);
        thrown = std::max(thrown, meanOf(x, light).y - meanOf(world.start, light).y);
    }
    CHECK(report("energy gained, of what the heavy ball fell", gained / (weight * fall), 0.01));
    note("part of its fall that the heavy ball comes back", back / fall);
    CHECK(back > 0.5 * fall);
    note("the light one is thrown, m", thrown);
    CHECK(thrown > 0.1);
}

TEST_CASE("layered sheets: each lies its thickness above the one below",
          "[contacts][scenes][figures][CC8][FX29]") {
    const Scene scene = sceneWith("layered-sheets", "shock", 4);
    const Points x = holdToBands(scene, 24);
    // Of the middle, on the ball's top.
    const auto height = [&](int sheet) {
        const Range range = scene.view.looks[sheet].object;
        return x[range.first + range.size() / 2].y;
    };
    for (const int sheet : {1, 2})
        CHECK(
            report("apart, mm", 1000 * std::fabs(height(sheet) - height(sheet - 1) - 0.004), 0.5));
}

// Of 4 mm; with it they keep to their band.
TEST_CASE("layered sheets: without a shock of layers they are squeezed as they land",
          "[contacts][scenes]") {
    const Scene scene = sceneWith("layered-sheets", "shock", 1);
    const auto gap = std::ranges::find(scene.metrics, "gap", &Metric::name);
    REQUIRE(gap != scene.metrics.end());
    Solver<float> solver(scene.world, scene.options);
    double least = 4;
    for (int frame = 1; frame <= 9; ++frame) {
        solver.frame();
        const Points x = solver.positions(), v = solver.velocities();
        least = std::min(least, gap->measure({x, v, solver.time(), frame}));
    }
    note("least gap, mm", least);
    CHECK(least < gap->low);
}

// Beads with beads, and ropes with beads and ropes.
TEST_CASE("medley: nothing comes nearer than its thickness", "[contacts][scenes]") {
    const Scene scene = sceneWith("medley", "beads", 40);
    const Points x = holdToBands(scene, 36);
    const auto& looks = scene.view.looks;
    const Range beads = looks[4].object;
    const double bead = looks[4].radius, rope = looks[1].radius;
    const auto apart = [&](const Pairing& pair) {
        const auto& v = pair.vertices;
        return length(nearest(pair, {x[v[0]], x[v[1]], x[v[2]], x[v[3]]}).apart);
    };
    double balls = 1, mixed = 1, ropes = 1;
    for (int b = beads.first; b < beads.last; ++b) {
        for (int c = b + 1; c < beads.last; ++c)
            balls = std::min(balls, length(x[c] - x[b]) / (2 * bead));
        for (int r = looks[1].object.first; r < looks[3].object.last; ++r)
            mixed = std::min(mixed, length(x[r] - x[b]) / (bead + rope));
    }
    for (int i = 1; i <= 3; ++i)
        for (int j = i + 1; j <= 3; ++j)
            for (int a = looks[i].object.first; a + 1 < looks[i].object.last; ++a)
                for (int b = looks[j].object.first; b + 1 < looks[j].object.last; ++b)
                    ropes = std::min(ropes, apart({{a, a + 1, b, b + 1}, 2, 2}) / (2 * rope));
    CHECK(report("beads, nearer by", 1 - balls, 0.05));
    CHECK(report("beads and ropes, nearer by", 1 - mixed, 0.05));
    CHECK(report("ropes, nearer by", 1 - ropes, 0.05));
}

namespace {

// The hems whip round the ball and crumple below it: in few substeps, lengths, folds and the ball
// leave each other the least room. All bands hold, but that of what is pressed for a moment.
void holdAsItLands(const std::string& ball, Quality quality) {
    const SceneEntry& entry = findScene("sheet-on-sphere");
    Knobs knobs = Knobs::defaults(entry.knobs, quality);
    knobs.numbers.at("thickness") = 5e-4;
    knobs.texts.at("ball") = ball;
    Scene scene = entry.build(knobs);
    scene.options.schedule.substeps = 10;
    std::erase_if(scene.metrics, [](const Metric& m) { return m.name == "strain99"; });
    const Points x = holdToBands(scene, 13);
    const Range cloth = scene.view.looks[0].object;
    double nearest = 1;
    for (int v = cloth.first; v < cloth.last; ++v)
        nearest = std::min(nearest, length(x[v] - Vec<double>{0, -0.25, 0}) - 0.25);
    note("from the ball at least, m", nearest);
    if (ball == "solid") CHECK(nearest > 5e-4);
}

}  // namespace

TEST_CASE("sheet on a sphere: in few substeps lengths, folds and the ball all hold",
          "[contacts][colliders][scenes][figures]") {
    holdAsItLands(GENERATE("solid", "mesh"), Quality::preview);
}

TEST_CASE("sheet on a sphere: 128 x 128 in few substeps", "[contacts][colliders][scenes][long]") {
    holdAsItLands(GENERATE("solid", "mesh"), Quality::final);
}

// Tins and balls of particles that move as one, knocked about: how far two of a body get from as
// far apart as they were.
TEST_CASE("bodies of particles keep their shape as they are thrown and slide",
          "[contacts][pieces][scenes][FX22]") {
    for (const char* const name : {"tablecloth", "trampoline"}) {
        const Scene scene = build(findScene(name), Quality::draft);
        REQUIRE(!scene.world.pieces.empty());
        Solver<float> solver(scene.world, scene.options);
        double worst = 0, way = 0;
        for (int frame = 0; frame < 30; ++frame) {
            solver.frame();
            const Points x = solver.positions();
            for (const Range body : scene.world.pieces)
                for (int a = body.first; a < body.last; ++a) {
                    way = std::max(way, length(x[a] - scene.world.start[a]));
                    for (int b = body.first; b < a; ++b) {
                        const double rest = length(scene.world.rest[a] - scene.world.rest[b]);
                        worst = std::max(worst, std::fabs(length(x[a] - x[b]) - rest) / rest);
                    }
                }
        }
        note(std::string(name) + ", how far bodies got, m", way);
        CHECK(way > 0.03);
        CHECK(report(std::string(name) + ", distances in a body, off", worst, 1e-4));
    }
}

TEST_CASE("stacks: a wall and a pyramid of balls stand while nothing rolls into them",
          "[contacts][figures][pieces][scenes][FX24]") {
    constexpr double side = 0.06;  // m, of a brick
    const Scene scene = sceneWith("stacks", "speed", 0);
    Solver<float> solver(scene.world, scene.options);
    for (int frame = 0; frame < 12; ++frame) solver.frame();  // balls come to lie on their faces
    const Points began = solver.positions();
    for (int frame = 0; frame < 36; ++frame) solver.frame();
    const Points ended = solver.positions();
    for (int look = 0; look < 2; ++look) {
        double most = 0;
        const Range object = scene.view.looks[look].object;
        for (int v = object.first; v < object.last; ++v)
            most = std::max(most, length(ended[v] - began[v]));
        CHECK(report(look == 0 ? "a wall, drift in 1.5 s, in sides"
                               : "a pyramid of balls, drift in 1.5 s, in sides",
                     most / side, 0.02));
    }
}
