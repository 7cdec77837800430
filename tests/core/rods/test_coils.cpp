// A coil that hangs is let go: its turns land on each other, and its end waits for them.
#include "tests/catch.h"
#include "tests/core/contacts/contact_worlds.h"
#include "tests/report.h"

#include <plait/rods/rod.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr int turns = 20, links = 24;
constexpr double g = 9.81, radius = 0.034;
constexpr Wire wire{.poisson = 0.27, .along = 2.5e-3, .across = 0.62e-3};

struct Coil {
    World world;
    Rod rod;
};

Coil makeCoil() {
    Coil coil;
    const Shape shape =
        helix({.links = turns * links, .radius = radius, .turns = turns, .pitch = wire.across});
    std::vector<Vec<double>> outward;
    for (int e = 0; e < turns * links; ++e) {
        const Vec<double> middle = 0.5 * (shape.positions[e] + shape.positions[e + 1]);
        outward.push_back({middle.x, 0, middle.z});
    }
    coil.rod = addRod(coil.world, shape, {.wire = wire, .toward = outward}, {.name = "coil"});
    coil.world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    return coil;
}

SolverOptions stepping(int substeps, double damping) {
    SolverOptions options{
        .sweeps = Sweeps::oneWay,
        .schedule = {.substeps = substeps, .iterations = 1, .collisionPasses = 2}};
    options.damping = 1 - std::exp(-damping / 24);
    return options;
}

}  // namespace

// What contacts move takes the directors of its edges along; else the first turns that meet are
// thrown aside, three radii far.
TEST_CASE("coils: turns that fall on each other stay a coil", "[rods][figures][contacts]") {
    Coil held = makeCoil(), free = held;
    const Rod& rod = held.rod;
    std::vector<int> top;
    for (int i = 0; i <= links; ++i) top.push_back(rod.points.last - 1 - i);
    for (int i = 0; i < links; ++i) top.push_back(rod.directors.last - 1 - i);
    held.world.pin(top);
    Solver<float> hang(held.world, stepping(24, 4));
    for (int frame = 0; frame < 24 * 4; ++frame) hang.frame();

    free.world.start = hang.positions();
    meet(free.world, {{.vertices = rod.points, .thickness = 0.499 * wire.across}});
    Solver<float> fall(free.world, stepping(24, 0));
    double mass = 0, widest = 0, first = 0;
    const auto& masses = free.world.mass;
    for (const double m : masses) mass += m;
    const auto middle = [&] {
        double sum = 0;
        const auto x = fall.positions();
        for (std::size_t v = 0; v < x.size(); ++v) sum += masses[v] * x[v].y;
        return sum / mass;
    };
    const double start = middle(), low = fall.positions()[rod.points.first].y;
    constexpr int frames = 8;
    for (int frame = 1; frame <= frames; ++frame) {
        fall.frame();
        CHECK(fall.failures() == 0);
        const auto x = fall.positions();
        if (frame == 1) first = std::fabs(low - x[rod.points.first].y);
        for (int v = rod.points.first; v < rod.points.last; ++v)
            widest = std::max(widest, std::hypot(x[v].x, x[v].z));
    }
    CHECK(report("how far its end came in 1/24 s, m", first, 1e-3));
    CHECK(report("widest, radii", widest / radius, 1.15));
    // First order takes h / 2 more of the fall.
    const double h = 1.0 / 24 / 24, t = frames / 24.0;
    CHECK(report("middle of its mass off the fall, m",
                 std::fabs(start - middle() - g * t * (t + h) / 2), 1e-5));
}
