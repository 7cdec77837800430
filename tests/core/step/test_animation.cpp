// Vertices that move as told: by a function of one vertex or of all, asked at the ends of base
// steps, straight in between.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/complex/shapes.h>
#include <plait/numbers/elementary.h>
#include <plait/sheets/inextensible.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>

using namespace plait;
using namespace plait::test;

namespace {

// Notes where a vertex is in every substep.
template <class Real>
struct Probe : Constraint<Real> {
    Probe(int v, Points& seen) : vertex(v), path(seen) {}
    void project(const Sweep<Real>& sweep, Direction direction, Workers&) override {
        if (direction == Direction::backward) return;
        const Real* p = sweep.particles + 8 * vertex;  // x, y, z, w, d
        path.push_back({double(p[0]) + double(p[4]), double(p[1]) + double(p[5]),
                        double(p[2]) + double(p[6])});
    }
    long size() const override { return 1; }

    int vertex;
    Points& path;
};

void probe(World& world, int v, Points& path) {
    world.constrain(
        {[v, &path](const World&, KernelChoice) { return std::make_unique<Probe<float>>(v, path); },
         [v, &path](const World&, KernelChoice) {
             return std::make_unique<Probe<double>>(v, path);
         }},
        {.name = "probe"});
}

// A turn about z in a second.
Vec<double> turned(const Vec<double>& x, double t) {
    const double c = cosine(2 * pi * t), s = sine(2 * pi * t);
    return {c * x.x - s * x.y, s * x.x + c * x.y, x.z};
}

void turnAll(double t, std::span<Vec<double>> positions) {
    for (Vec<double>& x : positions) x = turned(x, t);
}

constexpr int frameRate = 8;  // an eighth of a turn each

SolverOptions coarse(int substeps, int baseSteps) {
    SolverOptions options{
        .schedule = {.substeps = substeps, .frameRate = {frameRate, 1}, .iterations = 1}};
    options.baseSteps = baseSteps;
    return options;
}

// A sheet on two corners that are carried about, by an animation or each by itself.
World carriedSheet(bool animated) {
    World world;
    const Range sheet = world.add(grid({.columns = 9, .rows = 9}), {.density = 0.2});
    if (animated)
        world.pin({8, 0}, turnAll);
    else
        world.pin({8, 0}, turned);
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, sheet);
    return world;
}

}  // namespace

TEMPLATE_TEST_CASE("animation: straight and steady within a base step", "[solver][IN27][AT2]",
                   float, double) {
    // Half a unit in the last place of what a substep moves, in two coordinates: at most 0.06 m.
    const double bound = std::is_same_v<TestType, float> ? 3e-9 : 1e-15;
    for (const int baseSteps : {1, 3}) {
        Points path;
        World world = loosePoints({{5, 5, 5}, {1, 0, 0}, {0, 0.5, 2}});
        probe(world, 2, path);
        world.pin({1, 2}, turnAll);
        constexpr int substeps = 7;  // base steps of 2, 2 and 3 substeps
        const std::vector<int> ends = baseSteps == 1 ? std::vector{0, 7} : std::vector{0, 2, 4, 7};
        Solver<TestType> solver(world, coarse(substeps, baseSteps));
        double worst = 0, worstRate = 0;
        for (int frame = 0; frame < 16; ++frame) {
            solver.frame();
            const auto place = [&](int substep) {
                return turned(world.start[2],
                              (frame * substeps + substep) * solver.substepLength());
            };
            for (std::size_t part = 0; part + 1 < ends.size(); ++part)
                for (int i = ends[part] + 1; i <= ends[part + 1]; ++i) {
                    const Vec<double> a = place(ends[part]), b = place(ends[part + 1]);
                    const double f = double(i - ends[part]) / (ends[part + 1] - ends[part]);
                    const Vec<double> seen =
                        path[static_cast<std::size_t>(frame * substeps + i - 1)];
                    worst = std::max(worst, length(seen - (a + f * (b - a))));
                }
            const int last = ends[ends.size() - 2];
            const Vec<double> rate = (1 / ((substeps - last) * solver.substepLength())) *
                                     (place(substeps) - place(last));
            worstRate = std::max(worstRate, length(solver.velocities()[2] - rate) / length(rate));
        }
        const std::string what = std::to_string(baseSteps) + " base steps: ";
        CHECK(report(what + "off the way, m", worst, bound));
        CHECK(report(what + "velocity, relative", worstRate,
                     std::is_same_v<TestType, float> ? 2e-7 : 1e-13));
    }
}

// The bar cuts the corner by 1 - cos(angle / 2) of its length.
TEST_CASE("animation: base steps bring a turning bar to what it must hit", "[solver][IN28]") {
    for (const int baseSteps : {1, 2, 4, 8}) {
        Points path;
        World world = loosePoints({{1, 0, 0}});
        probe(world, 0, path);
        world.pin({0}, turnAll);
        Solver<double> solver(world, coarse(32, baseSteps));
        advance(solver, frameRate);
        double miss = 0;
        for (const Vec<double>& x : path) miss = std::max(miss, 1 - length(x));
        const double theory = 1 - std::cos(pi / frameRate / baseSteps);
        CHECK(report(std::to_string(baseSteps) + " base steps: missed by " + std::to_string(miss) +
                         " of its length, off theory",
                     std::fabs(miss - theory), 1e-13));
    }
    // More than there are substeps are of no use and do no harm.
    Solver<double> most(carriedSheet(true), coarse(4, 4)), more(carriedSheet(true), coarse(4, 99));
    advance(most, 2);
    advance(more, 2);
    CHECK(most.hash() == more.hash());
    CHECK_THROWS_AS(Solver<float>(World(), coarse(4, 0)), std::invalid_argument);
}

TEMPLATE_TEST_CASE("animation: all at once or one by one, the same bits, resumed and rewound",
                   "[solver][determinism]", float, double) {
    for (const int baseSteps : {1, 3}) {
        const SolverOptions options = coarse(20, baseSteps);
        Solver<TestType> solver(carriedSheet(true), options), single(carriedSheet(false), options);
        advance(solver, 5);
        const State<TestType> middle = solver.state();
        const long work = solver.evaluations();
        advance(solver, 5);
        advance(single, 10);
        const auto hash = solver.hash();
        CHECK(single.hash() == hash);
        Solver<TestType> resumed(carriedSheet(true), options);
        resumed.restore(middle, work);
        advance(resumed, 5);
        CHECK(resumed.hash() == hash);
        solver.rewind();
        advance(solver, 10);
        CHECK(solver.hash() == hash);
    }
}

// Bounds from where the pins were would drag the sheet back.
TEST_CASE("animation: tethers go with the pins", "[solver]") {
    World world;
    const Range sheet = world.add(grid({.columns = 9, .rows = 9}), {.density = 0.2});
    world.pin({8, 0}, [](double t, std::span<Vec<double>> positions) {
        for (Vec<double>& x : positions) x.z += 2 * t * t;
    });
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, sheet);
    Solver<double> solver(world, {});
    advance(solver, 24);
    const std::vector<double> strains = strainsOf(linksOf(world), solver.positions());
    CHECK(report("carried 2 m in 1 s, largest strain",
                 *std::max_element(strains.begin(), strains.end()), 0.02));
}

TEST_CASE("animation: one that throws leaves everything as it was", "[solver]") {
    World world = loosePoints({{1, 0, 0}});
    bool broken = false;
    world.pin({0}, [&](double t, std::span<Vec<double>> x) {
        if (broken && t > 0.2) throw std::runtime_error("no such frame");
        turnAll(t, x);
    });
    Solver<double> solver(world, coarse(4, 2));
    solver.frame();
    const auto hash = solver.hash();
    broken = true;
    CHECK_THROWS_WITH(solver.frame(), "no such frame");
    CHECK(solver.hash() == hash);
}
