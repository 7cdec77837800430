#include "stability/hanging_chain.h"

#include "forces/gravity.h"
#include "measure/energy.h"
#include "stencils.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plait {
namespace {

constexpr Vec<double> gravity{0, -9.81, 0};
constexpr Vec<double> top{0, 3, 0};  // strained by 200 %, the chain ends at height 0

World worldOf(const HangingChain& chain, const Rows<Stretch>& links) {
    World world;
    world.add(plait::chain({.links = chain.links(), .from = top, .to = {0, top.y - 1, 0}}));
    std::copy(chain.mass.begin(), chain.mass.end(), world.mass.begin() + 1);
    world.pin({0});
    world.act<Gravity>(GravityOptions{.acceleration = gravity});
    world.constrain(links, {.name = "links"});
    return world;
}

Rows<Stretch> linksOf(const HangingChain& chain) {
    Rows<Stretch> links{{}, {}, {}, {}};
    for (int i = 0; i < chain.links(); ++i) {
        const double compliance = chain.compliance[i];
        links.ids.insert(links.ids.end(), {i, i + 1});
        links.rows.push_back({1.0 / chain.links(), compliance, compliance});
        links.colors.push_back(i % 2);
    }
    return links;
}

// The springs' energy is left out: links that are not solved hold some that they never give back.
struct View {
    double energy, strain, length;  // J, the greatest, m
};

View look(const Solver<double>& solver, const World& world, const Rows<Stretch>& links) {
    const std::vector<Vec<double>> x = solver.positions();
    View view{kineticEnergy(world.mass, solver.velocities()) +
                  gravitationalEnergy(world.mass, x, gravity),
              0, top.y - x.back().y};
    for (std::size_t i = 0; i < links.rows.size(); ++i) {
        const double c = length(x[i + 1] - x[i]) - links.rows[i].rest;
        view.strain = std::max(view.strain, std::fabs(c) / links.rows[i].rest);
    }
    return view;
}

}  // namespace

std::vector<double> HangingChain::exact() const {
    std::vector<double> longer(mass.size());
    double tension = 0;
    for (std::size_t i = mass.size(); i-- > 0;) {
        tension -= gravity.y * mass[i];
        longer[i] = compliance[i] * tension;
    }
    return longer;
}

Outcome settle(const HangingChain& chain, const ChainSolve& solve, double allowed, double seconds) {
    const Rows<Stretch> links = linksOf(chain);
    const World world = worldOf(chain, links);
    Solver<double> solver(
        world,
        {.method = solve.method,
         .schedule = {.substeps = solve.substeps, .frameRate = {60, 1}, .iterations = solve.sweeps},
         .damping = solve.damping});
    const std::vector<double> exact = chain.exact();
    const double length = std::accumulate(exact.begin(), exact.end(), 1.0);
    View view = look(solver, world, links);
    Judge judge(view.energy, 2);
    try {
        for (int frame = 0; frame < std::lround(60 * seconds); ++frame) {
            solver.frame();
            view = look(solver, world, links);
            if (!judge.see(view.energy, view.strain)) return judge.outcome();
        }
    } catch (const Diverged&) {
        judge.seeNotFinite();
    }
    if (std::fabs(view.length - length) > allowed) judge.seeDrift();
    return judge.outcome();
}

}  // namespace plait
