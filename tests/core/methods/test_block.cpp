// Vertex block descent: what it converges to, for soft, rigid and one-sided constraints, and what
// it keeps before it has converged.
#include "spring.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/sheet.h"

#include <plait/measure/momentum.h>
#include <plait/methods/block/vertex_colors.h>

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double h = 0.02;

SolverOptions descent(int sweeps) {
    SolverOptions options = steppingBy(h, Method::block);
    options.schedule.iterations = sweeps;
    return options;
}

// A crooked chain in gravity, thrown.
World crookedChain(int links, double compliance) {
    Random random(21);
    Points at{{0, 0, 0}};
    for (int i = 0; i < links; ++i) {
        const Vec<double> d = random.point(1);
        at.push_back(at.back() + (0.1 / length(d)) * d);
    }
    World world = loosePoints({});
    world.add({chain({.links = links}).complex, at});
    world.mass.clear();
    for (const auto& x : at) world.mass.push_back(0.05 + 0.05 * std::fabs(x.x));
    for (auto& v : world.velocity) v = random.point(2);
    world.pin({0});
    world.act<Gravity>(GravityOptions{});
    world.constrain(linksOf(world, compliance), {.name = "links"});
    return world;
}

// From the tip up: what a vertex lacks of its inertial motion, and its lower link pulls, must be
// pulled along the upper link. The largest part of a force that is not, over that force; and the
// tension along each link.
double unbalanced(const World& world, const Points& x, std::vector<double>& tension) {
    const Vec<double> g{0, -9.81, 0};
    Vec<double> force{0, 0, 0};
    double worst = 0;
    tension.assign(x.size(), 0);
    for (std::size_t i = x.size() - 1; i > 0; --i) {
        const Vec<double> y = world.start[i] + h * (world.velocity[i] + h * g);
        force += (world.mass[i] / (h * h)) * (y - x[i]);
        const Vec<double> d = x[i] - x[i - 1];
        worst = std::max(worst, length(cross(force, d)) / (length(force) * length(d)));
        tension[i] = dot(force, d) / length(d);
    }
    return worst;
}

}  // namespace

TEST_CASE("block: vertices of a colour share no constraint", "[block][MS6]") {
    const World world = bentSheet(6, 0.1);
    const SetStencils links{2, linksOf(world).ids};
    const SetStencils hinges{4, hingeStencils(world.complex, {0, 36})};
    const std::vector<SetStencils> sets{links, hinges};
    const auto colors = vertexColors(sets, world.pinned);
    std::vector<int> colored(world.mass.size(), 0);
    std::size_t corners = 0;
    for (const VertexColor& color : colors) {
        for (const int v : color.vertices) ++colored[v];
        for (std::size_t k = 0; k < sets.size(); ++k) {
            const auto& [constraints, corner] = color.sets[k];
            std::vector<int> seen(sets[k].ids.size(), 0);
            for (std::size_t i = 0; i < constraints.size(); ++i) {
                const int v = sets[k].ids[sets[k].arity * constraints[i] + corner[i]];
                CHECK(std::binary_search(color.vertices.begin(), color.vertices.end(), v));
                CHECK(++seen[constraints[i]] == 1);
            }
            corners += constraints.size();
        }
    }
    std::size_t moving = 0;
    for (const SetStencils& set : sets)
        for (const int v : set.ids) moving += world.pinned[v] ? 0 : 1;
    CHECK(corners == moving);
    for (std::size_t v = 0; v < colored.size(); ++v) CHECK(colored[v] == (world.pinned[v] ? 0 : 1));
    CHECK(colors.size() <= 9);
}

TEST_CASE("block: soft constraints converge to implicit Euler", "[block][IN1]") {
    constexpr double compliance = 1e-4;
    const World world = crookedChain(10, compliance);
    Solver<double> solver(world, descent(3000));
    solver.frame();
    const Points x = solver.positions();
    std::vector<double> tension;
    CHECK(report("force across a link, relative", unbalanced(world, x, tension), 1e-9));
    double worst = 0, most = 0;
    for (std::size_t i = 1; i < x.size(); ++i) {
        const double c = length(x[i] - x[i - 1]) - length(world.rest[i] - world.rest[i - 1]);
        most = std::max(most, std::fabs(tension[i]));
        worst = std::max(worst, std::fabs(c / compliance - tension[i]));
    }
    CHECK(report("tension, from C / alpha", worst / most, 1e-9));
}

TEST_CASE("block: rigid constraints converge to implicit Euler with multipliers", "[block]") {
    const World world = crookedChain(6, 0);
    Solver<double> solver(world, descent(3000));
    solver.frame();
    const Points x = solver.positions();
    std::vector<double> tension;
    CHECK(report("force across a rigid link, relative", unbalanced(world, x, tension), 1e-9));
    double worst = 0;
    for (const double s : strainsOf(linksOf(world), x)) worst = std::max(worst, std::fabs(s));
    CHECK(report("strain of rigid links", worst, 1e-9));
}

TEST_CASE("block: one rigid link is the nearest point on the circle", "[block]") {
    World world = linkedPoints({{0, 0, 0}, {0.6, -0.8, 0}}, {1, 1});
    world.velocity[1] = {3, 4, 5};
    Solver<double> solver(world, descent(60));
    solver.frame();
    const Vec<double> y = world.start[1] + h * world.velocity[1];
    CHECK(report("distance from the nearest point",
                 length(solver.positions()[1] - (1 / length(y)) * y), 1e-13));
}

TEST_CASE("block: momentum is kept by what has converged", "[block][conservation]") {
    World world = crookedChain(8, 0);
    world.pinned.assign(world.pinned.size(), 0);
    world.forces.clear();
    const Vec<double> before = momentum(world.mass, world.velocity);
    double size = 0;
    for (std::size_t i = 0; i < world.mass.size(); ++i)
        size += world.mass[i] * length(world.velocity[i]);
    for (const int sweeps : {1, 4, 16, 4000}) {
        Solver<double> solver(world, descent(sweeps));
        solver.frame();
        const double lost = length(momentum(world.mass, solver.velocities()) - before) / size;
        if (sweeps < 4000)
            note("momentum lost after sweeps: " + std::to_string(sweeps), lost);
        else
            CHECK(report("momentum lost after 4000 sweeps", lost, 1e-9));
    }
}

TEST_CASE("block: what is one-sided pushes and does not pull", "[block]") {
    World world = loosePoints({{0, 0.05, 0}, {1, 2, 0}, {2, 0.9, 0}, {3, 0.5, 0}});
    world.velocity.assign(4, {0, -4, 0});
    world.velocity[2] = {0, 11, 0};
    auto floor = restRows<PlaneContact>({0, 1, 2, 3}, world.rest);
    for (auto& row : floor.rows) row = {{0, 0, 0}, {0, 1, 0}, 0};
    world.constrain(floor, {.name = "floor"});
    world.constrain(Rows<Tether>{{2, 3}, {{{2, 0, 0}, 1}, {{3, 0, 0}, 1}}, {}, {}},
                    {.name = "tethers"});
    Solver<double> solver(world, descent(60));
    solver.frame();
    const Points x = solver.positions();
    CHECK(x[0].y == Approx(0).margin(1e-12));
    CHECK(x[1].y == Approx(2 - 4 * h));
    CHECK(x[2].y == Approx(1).margin(1e-12));
    CHECK(x[3].y == Approx(0.5 - 4 * h));
}

TEST_CASE("block: from any start it settles, whatever the sweeps", "[block]") {
    World world = bentSheet(4, 0);
    world.sets.clear();
    world.constrain(sheetLinks(world, 4, 4), {.name = "stretch"});
    world.constrain(bendRows(world.complex, {0, 16}, world.rest, 0.1), {.name = "bend"});
    Random random(23);
    for (auto& x : world.start) x = random.point(0.5);
    for (const int sweeps : {1, 4}) {
        SolverOptions options = descent(sweeps);
        options.damping = 0.5;
        Solver<float> solver(world, options);
        for (int n = 0; n < 150; ++n) {
            solver.frame();
            REQUIRE(topSpeed(solver) < 50);  // a metre in a substep
        }
        note("speed 3 s after a random start, sweeps: " + std::to_string(sweeps), topSpeed(solver));
        CHECK(topSpeed(solver) < 0.5);
    }
}
