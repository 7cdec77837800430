// What comes and goes: when, where, which, and with the same bits again.
#include "tests/catch.h"
#include "tests/core/particles/pools.h"
#include "tests/report.h"

#include <plait/sources/expression.h>
#include <plait/sources/sink.h>
#include <plait/sources/source.h>
#include <plait/stencils.h>

#include <algorithm>
#include <set>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double second = 1;

Shape points(std::vector<Vec<double>> at) {
    const auto n = static_cast<int>(at.size());
    return {SimplicialComplex(n), std::move(at)};
}

struct Fountain {
    World world;
    SourceOptions source;

    explicit Fountain(int spare, SourceOptions options = {}) : source(std::move(options)) {
        source.spare = world.add(points({}), {.density = 0.002, .spare = spare});
        if (source.nozzle.empty()) source.nozzle = {{0, 0, 0}};
    }
    void act() { world.act<Source>(source); }
};

SolverOptions substeps(int count, int threads = 1) {
    SolverOptions options;
    options.schedule = {.substeps = count, .frameRate = {10, 1}, .iterations = 1};
    options.threads = threads;
    return options;
}

template <class Real>
const Drawer<Real>& drawerOf(const Solver<Real>& solver, const World& world, std::size_t force) {
    return solver.state().kept[world.sets.size() + force];
}

template <class Real>
int present(const State<Real>& state) {
    return static_cast<int>(
        std::ranges::count_if(state.born, [](std::int32_t born) { return born >= 0; }));
}

}  // namespace

TEST_CASE("a source brings volleys evenly, whatever the substep", "[sources][PA1]") {
    for (const int count : {1, 7, 40}) {
        Fountain fountain(400, {.nozzle = {{0, 0, 0}, {0, 1, 0}},
                                .velocity = {2, 0, 0},
                                .every = 0.0113,
                                .from = 0.05,
                                .until = 0.75});
        fountain.act();
        Solver<double> solver(fountain.world, substeps(count));
        for (int frame = 0; frame < 10; ++frame) solver.frame();
        const auto& state = solver.state();
        const int volleys = 62;  // at 0.05 + 0.0113 k < 0.75
        // What is born in the last substep comes as the next begins.
        CHECK(present(state) == 2 * volleys);
        CHECK(Source<double>::brought(drawerOf(solver, fountain.world, 0)) == 2 * volleys);
        double off = 0;
        for (int v = 0; v < state.count(); ++v) {
            if (state.born[v] < 0) continue;
            const double when = 0.05 + 0.0113 * (state.id[v] / 2);
            const Vec<double> place{2 * (second - when), state.id[v] % 2 ? 1.0 : 0.0, 0};
            off = std::max(off, length(state.position(v) - place));
        }
        CHECK(report("place of all that a source brought, m", off, 1e-13));
    }
}

TEST_CASE("what is old goes, and its place is taken again", "[sources][PA2][FX18]") {
    Fountain fountain(60, {.every = 0.01, .lifespan = 0.5});
    fountain.act();
    Solver<float> solver(fountain.world, substeps(20));
    std::set<int> ids;
    for (int frame = 0; frame < 20; ++frame) {
        solver.frame();
        for (const std::int32_t id : solver.state().id)
            if (id >= 0) ids.insert(id);
    }
    const auto& state = solver.state();
    CHECK(present(state) == 50);
    CHECK(Source<float>::missed(drawerOf(solver, fountain.world, 0)) == 0);
    // All that ever came have been there at the end of a frame; slots are the lowest.
    CHECK(ids.size() == 200);
    CHECK(*ids.rbegin() == 199);
    CHECK(std::all_of(state.born.begin() + 51, state.born.end(),
                      [](std::int32_t born) { return born < 0; }));
    double sum = 0;
    for (const std::int32_t born : state.born)
        if (born >= 0) sum += static_cast<double>(state.substep - born) * solver.substepLength();
    CHECK(report("mean age against half a lifespan, s", std::fabs(sum / 50 - 0.25), 0.01));
}

TEST_CASE("births without a spare vertex are counted", "[sources][PA1]") {
    Fountain fountain(30, {.every = 0.01});
    fountain.act();
    Solver<float> solver(fountain.world, substeps(4));
    for (int frame = 0; frame < 10; ++frame) solver.frame();
    CHECK(present(solver.state()) == 30);
    CHECK(Source<float>::brought(drawerOf(solver, fountain.world, 0)) == 30);
    CHECK(Source<float>::missed(drawerOf(solver, fountain.world, 0)) == 68);
}

TEST_CASE("lifespans are spread by seed, as chance has them", "[sources][PA2][PA4]") {
    const SourceOptions options{.every = 1, .lifespan = 2, .lifespanSpread = 0.5, .seed = 3};
    double sum = 0, squares = 0, together = 0, before = 0;
    constexpr int n = 20000;
    for (int id = 0; id < n; ++id) {
        const double u = (lifespanOf(options, id) - 2) / 0.5;
        REQUIRE(std::fabs(u) <= 1);
        sum += u, squares += u * u, together += u * before, before = u;
    }
    // Of even numbers in (-1, 1): mean 0, variance 1/3, neighbours unrelated; five deviations.
    CHECK(report("mean", std::fabs(sum / n), 5 * std::sqrt(1 / 3.0 / n)));
    CHECK(report("variance", std::fabs(squares / n - 1 / 3.0), 5 * std::sqrt(4 / 45.0 / n)));
    CHECK(report("neighbours", std::fabs(together / n), 5 * std::sqrt(1 / 9.0 / n)));
    CHECK(numberOf(5, 1, 0) != numberOf(5, 2, 0));
    CHECK(numberOf(5, 1, 0) != numberOf(5, 1, 1));
}

TEMPLATE_TEST_CASE("a source goes on as it would have, and begins again as it did",
                   "[sources][determinism][PA4]", float, double) {
    const auto make = [] {
        Fountain fountain(200, {.velocity = {0, 3, 0},
                                .every = 0.01,
                                .scatter = 0.02,
                                .scatterVelocity = 0.7,
                                .lifespan = 0.6,
                                .lifespanSpread = 0.3});
        fountain.world.act<Gravity>(GravityOptions{});
        fountain.act();
        fountain.world.act<Sink>(
            SinkOptions{.spare = fountain.source.spare, .point = {0, -0.2, 0}});
        return fountain;
    };
    Solver<TestType> through(make().world, substeps(8)), other(make().world, substeps(8, 3));
    for (int frame = 0; frame < 7; ++frame) through.frame();
    const State<TestType> state = through.state();
    const long evaluations = through.evaluations();
    for (int frame = 0; frame < 9; ++frame) through.frame();
    const std::uint64_t hash = through.hash();
    Solver<TestType> resumed(make().world, substeps(8));
    resumed.restore(state, evaluations);
    for (int frame = 0; frame < 9; ++frame) resumed.frame();
    CHECK(resumed.hash() == hash);
    for (int frame = 0; frame < 16; ++frame) other.frame();
    CHECK(other.hash() == hash);
    through.rewind();
    CHECK(present(through.state()) == 0);
    for (int frame = 0; frame < 16; ++frame) through.frame();
    CHECK(through.hash() == hash);
    for (int v = 0; v < through.state().count(); ++v)
        if (through.state().born[v] >= 0) CHECK(through.state().position(v).y > -0.25);
}

TEST_CASE("what comes falls as it should in either order", "[sources][IN16]") {
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2}) {
        Fountain fountain(1, {.velocity = {1, 4, 0}, .from = 0.1});
        fountain.world.act<Gravity>(GravityOptions{.acceleration = {0, -10, 0}});
        fountain.act();
        SolverOptions options = substeps(100);
        options.integrator = integrator;
        Solver<double> solver(fountain.world, options);
        for (int frame = 0; frame < 6; ++frame) solver.frame();
        const double t = 0.5, h = solver.substepLength();
        const Vec<double> at = solver.state().position(0);
        CHECK(report("along", std::fabs(at.x - t), 1e-12));
        // Of first order g t h / 2 too low; of second, whose first substep knows no acceleration
        // yet, no more.
        const double low = 4 * t - 5 * t * t - at.y, first = 5 * t * h;
        if (integrator == Integrator::first)
            CHECK(report("height, m", std::fabs(low - first), 1e-12));
        else
            CHECK(report("height, m", std::fabs(low), first));
    }
}

TEST_CASE("what is not there does nothing", "[sources][AT21][PA5]") {
    World world;
    const Range chain = world.add(plait::chain({.links = 3}), {.density = 0.1, .spare = 5});
    CHECK(chain.size() == 9);
    CHECK_FALSE(world.isSpare(3));
    CHECK(world.isSpare(4));
    world.pin({0});
    world.act<Gravity>(GravityOptions{});
    World linked = world;
    linked.constrain(restRows<Stretch>(edgeStencils(world.complex, chain), world.rest),
                     {.name = "links"});
    Solver<double> solver(linked, substeps(10));
    for (int frame = 0; frame < 5; ++frame) solver.frame();
    CHECK(present(solver.state()) == 4);
    for (int v = 4; v < 9; ++v) {
        CHECK(length(solver.state().position(v) - world.start[0]) == 0);
        CHECK(length(solver.velocities()[v]) == 0);
    }
    // Links are for what is there from the start.
    world.constrain(restRows<Stretch>({2, 6}, world.rest), {.name = "no links"});
    CHECK_THROWS_WITH(Solver<double>(world, substeps(1)),
                      "no links: vertex 6 is not there from the start");
}

TEST_CASE("a liquid is the same with spare particles behind it", "[sources][liquid]") {
    const double spacing = 0.05;
    const auto positions = blockOf(8, 8, 8, spacing, 0.1);
    const auto tank = openTank(0.8, 0.4);
    Pool plain(positions, spacing, tank), spared({}, spacing, tank);
    spared.liquid.particles =
        spared.world.add({SimplicialComplex(static_cast<int>(positions.size())), positions},
                         {.density = 1000 * spacing * spacing * spacing, .spare = 100});
    plain.fall(), spared.fall();
    Solver<float> one(plain.world, perSecond(500)), other(spared.world, perSecond(500));
    for (int frame = 0; frame < 10; ++frame) one.frame(), other.frame();
    bool same = true;
    for (std::size_t i = 0; i < positions.size(); ++i)
        same = same && length(one.positions()[i] - other.positions()[i]) == 0;
    CHECK(same);
}

TEST_CASE("an expression sees what was solved, in double", "[sources][PA3]") {
    World world;
    const Range rope = world.add(chain({.links = 1}), {.density = 1});
    world.pin({rope.first});
    world.act<Gravity>(GravityOptions{});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, rope), world.rest),
                    {.name = "link"});
    double longest = 0, last = 0;
    int calls = 0;
    express(world, rope, [&](Point& point, double t) {
        CHECK(point.vertex == 1);
        longest = std::max(longest, std::fabs(length(point.x - world.start[0]) - 1));
        CHECK(point.age == Approx(t));
        last = t;
        ++calls;
        point.v.z = 0.1;  // swings aside, whatever was solved
    });
    Solver<float> solver(world, substeps(20));
    for (int frame = 0; frame < 3; ++frame) solver.frame();
    CHECK(calls == 60);
    CHECK(last == Approx(0.3));
    // Predicted it would be g h^2 = 2.5e-4 off.
    CHECK(report("length that it sees, m", longest, 1e-6));
    CHECK(solver.velocities()[1].z == Approx(0.1));
    CHECK(solver.positions()[1].z == Approx(0.1 * 0.3).epsilon(0.05));
}

TEST_CASE("sources, sinks and expressions refuse what makes no sense", "[sources]") {
    const auto refuses = [](const SourceOptions& options, const std::string& why) {
        Fountain fountain(4, options);
        fountain.act();
        CHECK_THROWS_WITH(Solver<float>(fountain.world, substeps(1)),
                          Catch::Contains("source: ") && Catch::Contains(why));
    };
    refuses({.every = 0}, "time between volleys");
    refuses({.from = infinity}, "at no time");
    refuses({.lifespan = 0}, "lifespan");
    refuses({.lifespan = 1, .lifespanSpread = 1}, "lifespan");
    refuses({.scatter = std::nan("")}, "finite");
    World world;
    const Range there = world.add(points({{0, 0, 0}}), {.spare = 1});
    world.act<Source>(SourceOptions{.spare = there, .nozzle = {{0, 0, 0}}});
    CHECK_THROWS_WITH(Solver<float>(world, substeps(1)), Catch::Contains("spare vertices only"));
    World sunk;
    const Range some = sunk.add(points({}), {.spare = 1});
    sunk.act<Sink>(SinkOptions{.spare = some, .normal = {0, 0, 0}});
    CHECK_THROWS_WITH(Solver<float>(sunk, substeps(1)), Catch::Contains("no direction"));
    CHECK_THROWS_WITH(express(sunk, {0, 7}, [](Point&, double) {}),
                      Catch::Contains("not in the world"));
    CHECK_THROWS(sunk.add(points({}), {.spare = -1}));
}
