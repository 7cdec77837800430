// Tears as events of a run: the same bits however it is taken, when they are asked for, what stays.
#include "tests/catch.h"
#include "tests/core/tearing/torn_sheets.h"
#include "tests/report.h"

#include <plait/contacts/surface.h>
#include <plait/measure/surfaces/intersections.h>

#include <algorithm>
#include <set>

using namespace plait;
using namespace plait::test;

namespace {

// A small strip with bending that meets itself, torn right across within 12 frames of 1 ms.
Strip torn(Tearing tearing = {}, double jitter = 0.15, int spare = 60) {
    Strip strip({17, 7, 0.1, 0.03}, 0.03, jitter, spare);
    strip.draw(1.5, 1.5, 1);
    const double toughness = strip.driveAt(1.2) / strip.thickness;
    if (!(tearing.strength < infinity)) tearing.toughness = toughness;
    strip.holdTearing(tearing);
    const Range all = strip.cloth;
    strip.world.constrain(bendRows(strip.world.complex, all, strip.world.rest, 1e-4),
                          {.name = "bend"});
    meet(strip.world, {{.vertices = all}});
    return strip;
}

SolverOptions quick(int threads = 1, Integrator integrator = Integrator::bdf2) {
    SolverOptions options;
    options.schedule = {.substeps = 10, .frameRate = {1000, 1}, .iterations = 1};
    options.integrator = integrator;
    options.threads = threads;
    return options;
}

template <class Real>
std::vector<std::uint64_t> hashes(const World& world, const SolverOptions& options, int frames) {
    Solver<Real> solver(world, options);
    std::vector<std::uint64_t> all;
    for (int f = 0; f < frames; ++f) {
        solver.frame();
        all.push_back(solver.hash());
    }
    return all;
}

template <class Real>
std::size_t edgesOf(const State<Real>& state) {
    return static_cast<std::size_t>(
        std::ranges::count_if(state.cuts, [](std::int32_t entry) { return entry >= 0; }));
}

Vec<double> momentumOf(const State<double>& state) {
    Vec<double> sum{0, 0, 0};
    for (int v = 0; v < state.count(); ++v)
        if (const double w = state.particles[v].w; w > 0) sum += 1 / w * state.velocity[v].v;
    return sum;
}

}  // namespace

TEMPLATE_TEST_CASE("tears: same bits with any threads, fresh each frame and rewound",
                   "[tearing][determinism][threads]", float, double) {
    const World world = torn().world;
    constexpr int frames = 10;
    const auto once = hashes<TestType>(world, quick(), frames);
    CHECK(hashes<TestType>(world, quick(3), frames) == once);
    Solver<TestType> solver(world, quick());
    for (int f = 0; f < frames; ++f) solver.frame();
    CHECK(edgesOf(solver.state()) > 8);
    solver.rewind();
    CHECK(solver.state().cuts.empty());
    // What structure the state has is made anew from its cuts: on a solver of its own each frame.
    State<TestType> state = solver.state();
    long evaluations = 0;
    for (int f = 0; f < frames; ++f) {
        Solver<TestType> fresh(world, quick());
        fresh.restore(state, evaluations);
        fresh.frame();
        CHECK(fresh.hash() == once[f]);
        state = fresh.state(), evaluations = fresh.evaluations();
    }
    // And back to before anything tore, on a solver that has it all.
    Solver<TestType> back(world, quick());
    const State<TestType> start = back.state();
    for (int f = 0; f < frames; ++f) back.frame();
    back.restore(start, 0);
    for (int f = 0; f < frames; ++f) back.frame();
    CHECK(back.hash() == once.back());
}

TEST_CASE("tears: copies begin where their vertices are, and as fast", "[tearing]") {
    const World world = torn().world;
    SolverOptions options = quick();
    options.schedule = {.substeps = 1, .frameRate = {10000, 1}, .iterations = 1};
    Solver<double> solver(world, options);
    std::size_t seen = 0;
    double mass = 0;
    for (int v = 0; v < solver.state().count(); ++v)
        if (solver.state().id[v] >= 0) mass += world.mass[v];
    for (int f = 0; f < 100; ++f) {
        solver.frame();
        const State<double>& state = solver.state();
        const World now = world.tornBy(state.cuts);
        if (!now.torn) continue;
        for (const VertexSplit& split : now.torn->splits().subspan(seen)) {
            CHECK(length(state.position(split.copy) - state.position(split.vertex)) == 0);
            CHECK(length(state.velocity[split.copy].v - state.velocity[split.vertex].v) == 0);
            CHECK(state.id[split.copy] >= 0);
        }
        seen = now.torn->splits().size();
        double sum = 0;
        for (int v = 0; v < state.count(); ++v)
            if (state.id[v] >= 0) sum += now.mass[v];
        CHECK(std::fabs(sum - mass) < 1e-12 * mass);
    }
    CHECK(seen > 8);
}

TEST_CASE("tears: what is not near a tear does not notice that something tore", "[tearing][BR8]") {
    const World tears = torn().world, never = torn({.asked = Tears::never}).world;
    SolverOptions options = quick();
    options.schedule = {.substeps = 1, .frameRate = {10000, 1}, .iterations = 1};
    Solver<double> solver(tears, options);
    State<double> before = solver.state();
    long evaluations = 0;
    while (solver.state().cuts.empty()) {
        before = solver.state(), evaluations = solver.evaluations();
        solver.frame();
    }
    // The same two substeps without the tear.
    Solver<double> whole(never, options);
    whole.restore(before, evaluations);
    for (int f = 0; f < 2; ++f) whole.frame();
    solver.frame();
    const auto ends = tears.complex.vertices(1, solver.state().cuts[0]);
    double sum = 0, near = 0;
    int count = 0;
    for (int v = 0; v < solver.state().count(); ++v) {
        if (solver.state().id[v] < 0 || tears.isSpare(v)) continue;
        const double off = length(solver.state().position(v) - whole.state().position(v));
        const double away = std::min(length(tears.rest[v] - tears.rest[ends[0]]),
                                     length(tears.rest[v] - tears.rest[ends[1]]));
        if (away < 0.006)
            near = std::max(near, off);
        else if (away > 0.02)
            sum += off * off, ++count;
    }
    CHECK(near > 1e-9);
    CHECK(report("jitter beyond three edges, part of an edge, RMS",
                 std::sqrt(sum / count) / 0.00625, 1e-6));
    note("moved at the tear, part of an edge", near / 0.00625);
}

TEST_CASE("tears: what is free keeps its momentum through all of them", "[tearing][BR1]") {
    Strip strip({17, 7, 0.1, 0.03}, 0.03, 0.15, 60);
    for (int v = 0; v < static_cast<int>(strip.world.rest.size()); ++v) {
        strip.world.start[v].y *= 1.6;
        strip.world.velocity[v] = {1, 2, 3};
    }
    strip.holdTearing({.toughness = 0.5 * strip.driveAt(1.2) / strip.thickness});
    Solver<double> solver(strip.world, quick(1, Integrator::first));
    const Vec<double> before = momentumOf(solver.state());
    for (int f = 0; f < 6; ++f) solver.frame();
    CHECK(edgesOf(solver.state()) > 2);
    CHECK(report("momentum after " + std::to_string(edgesOf(solver.state())) + " edges",
                 length(momentumOf(solver.state()) - before) / length(before), 1e-6));
}

TEST_CASE("tears: never, per frame, per substep", "[tearing][BR5]") {
    const auto cutsBy = [](Tears asked) {
        const World world = torn({.asked = asked}).world;
        Solver<double> solver(world, quick());
        std::vector<std::size_t> counts;
        for (int f = 0; f < 5; ++f) {
            solver.frame();
            counts.push_back(edgesOf(solver.state()));
        }
        return counts;
    };
    const auto never = cutsBy(Tears::never), frame = cutsBy(Tears::perFrame),
               substep = cutsBy(Tears::perSubstep);
    CHECK(never.back() == 0);
    CHECK(frame.back() > 0);
    for (std::size_t f = 0; f < 5; ++f) CHECK(frame[f] <= f + 1);  // one end, one edge each
    CHECK(substep.back() > frame.back());
}

TEST_CASE("tears: spare vertices used up, nothing more tears, and it is counted", "[tearing]") {
    const Strip strip = torn({}, 0.15, 4);
    Solver<double> solver(strip.world, quick());
    for (int f = 0; f < 10; ++f) solver.frame();
    const State<double>& state = solver.state();
    CHECK(edgesOf(state) == 4);
    const auto& kept = state.kept[state.kept.size() - 2].integers;  // of the one force
    CHECK(kept[0] > 0);
}

TEST_CASE("tears: strength by map, scattered by a seed", "[tearing][AT17]") {
    // No notch: a strip under even load, half of it weaker by a tenth.
    const auto firstBy = [](std::uint64_t seed, double scatter, bool weak) {
        Strip strip({25, 9, 0.12, 0.04}, -1, 0, 200);
        strip.draw(1.3, 1.3, 1);
        const double strength = strip.law.at(1.3, 1).a * (weak ? 1.05 : 0.97 + scatter);
        Tearing tearing{.strength = strength, .scatter = scatter, .seed = seed};
        if (weak) tearing.map = [](const Vec<double>& x) { return x.x > 0.08 ? 0.9 : 1.0; };
        strip.holdTearing(tearing);
        Solver<double> solver(strip.world, quick());
        while (solver.state().cuts.empty() && solver.time() < 0.02) solver.frame();
        std::set<int> cuts;
        if (!solver.state().cuts.empty()) {
            const auto ends = strip.world.complex.vertices(1, solver.state().cuts[0]);
            return strip.world.rest[ends[0]];
        }
        return Vec<double>{-1, -1, -1};
    };
    CHECK(firstBy(1, 0, true).x > 0.079);
    const Vec<double> one = firstBy(1, 0.05, false), again = firstBy(1, 0.05, false),
                      other = firstBy(2, 0.05, false);
    CHECK(one.x >= 0);
    CHECK(length(one - again) == 0);
    CHECK(length(one - other) > 0);
}

TEST_CASE("tears: what a needle pierces, and only from when it does", "[tearing]") {
    Strip strip({17, 7, 0.1, 0.03}, -1, 0.1, 60);
    strip.draw(1.5, 1.5, 1);
    strip.holdTearing({.toughness = strip.driveAt(1.2) / strip.thickness,
                       .needle = [](double t) { return Vec<double>{0.05, 0.015, 0.003 - t}; }});
    Solver<double> solver(strip.world, quick());
    for (int f = 0; f < 3; ++f) solver.frame();  // it is there at 3 ms
    CHECK(solver.state().cuts.empty());
    for (int f = 0; f < 5; ++f) solver.frame();
    CHECK(edgesOf(solver.state()) > 2);
    const auto ends = strip.world.complex.vertices(1, solver.state().cuts[0]);
    CHECK(length(strip.world.rest[ends[0]] - Vec<double>{0.05, 0.015, 0}) < 0.012);
}

TEST_CASE("tears: lips begin in one place and do not fly apart", "[tearing][CC10]") {
    // With contact or without, the same tear opens in the same time: nothing that shared a vertex
    // once pushes.
    const auto gapBy = [](bool contact) {
        Strip strip({17, 7, 0.1, 0.03}, 0.03, 0, 60);
        strip.draw(1.5, 1.5, 1);
        strip.holdTearing({.toughness = strip.driveAt(1.2) / strip.thickness});
        if (contact) meet(strip.world, {{.vertices = strip.cloth}});
        Solver<double> solver(strip.world, quick());
        for (int f = 0; f < 3; ++f) solver.frame();
        const World now = strip.world.tornBy(solver.state().cuts);
        double gap = 0;
        for (const VertexSplit& split : now.torn->splits())
            gap = std::max(gap, length(solver.state().position(split.copy) -
                                       solver.state().position(split.vertex)));
        return gap;
    };
    CHECK(report("opening with contact against without", std::fabs(gapBy(true) / gapBy(false) - 1),
                 0.02));
}

TEST_CASE("tears: lips that have parted do not come back through each other",
          "[tearing][CC10][SF1]") {
    // Pulled apart until it is torn across, then thrown together.
    const auto crossingsBy = [](bool contact) {
        Strip strip({17, 9, 0.1, 0.04}, 0.03, 0.1, 80);
        strip.draw(1.4, 1.4, 1);
        strip.holdTearing({.toughness = strip.driveAt(1.15) / strip.thickness});
        if (contact) meet(strip.world, {{.vertices = strip.cloth, .thickness = 0.4e-3}});
        Solver<double> solver(strip.world, quick(1, Integrator::first));
        for (int f = 0; f < 25; ++f) solver.frame();
        // Both halves at each other, one of them aslant.
        State<double> state = solver.state();
        for (int v = 0; v < state.count(); ++v) {
            const Vec<double> x = state.position(v);
            state.velocity[v].v = {0, x.y > 0.02 ? -2.0 : 2.0,
                                   x.y > 0.02 ? 60 * (x.x - 0.05) : 0.0};
        }
        Solver<double> on(strip.world, quick(1, Integrator::first));
        on.restore(state, 0);
        long most = 0;
        for (int f = 0; f < 25; ++f) {
            on.frame();
            const World now = strip.world.tornBy(on.state().cuts);
            std::vector<std::array<int, 2>> edges;
            std::vector<std::array<int, 3>> triangles;
            for (int e = 0; e < now.complex.count(1); ++e) edges.push_back(now.complex.edge(e));
            for (int t = 0; t < now.complex.count(2); ++t)
                triangles.push_back(now.complex.triangle(t));
            most = std::max(
                most, static_cast<long>(countIntersections(on.positions(), edges, triangles)));
        }
        return most;
    };
    CHECK(crossingsBy(true) == 0);
    CHECK(crossingsBy(false) > 0);
}

TEST_CASE("tears: bad numbers are refused by name", "[tearing]") {
    const auto refused = [](Tearing tearing, int spare = 10) {
        Strip strip({9, 5, 0.1, 0.03}, -1, 0, spare);
        try {
            strip.holdTearing(tearing);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refused({.toughness = 1}).empty());
    CHECK(refused({.strength = 0}) == "tearing: strength must be above 0");
    CHECK(refused({.toughness = -1}) == "tearing: toughness must be finite and not negative");
    CHECK(refused({.scatter = 1}) == "tearing: scatter must be in [0, 1)");
    CHECK(refused({.branching = 1}) == "tearing: branching must be 2 or more");
    CHECK(refused({.toughness = 1}, 0) == "tearing: the cloth has no spare vertices");
    // Sets that cannot follow say so.
    Strip strip({9, 5, 0.1, 0.03}, -1, 0, 10);
    strip.holdTearing({.toughness = 1});
    strip.world.constrain(
        restRows<Stretch>(edgeStencils(strip.world.complex, {0, 2}), strip.world.rest),
        {.name = "chain", .direct = true});
    CHECK_THROWS_WITH((Solver<double>(strip.world, quick())),
                      Catch::Matchers::Contains("chain: vertex 0 may come apart"));
}
