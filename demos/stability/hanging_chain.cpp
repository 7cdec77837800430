#include "hanging_chain.h"

#include "watch.h"

#include <plait/forces/gravity.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plait {
namespace {

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
    // The springs' energy is left out: links that are not solved hold some that they never give
    // back.
    Judge judge(mechanicalEnergy(world, solver), 2);
    double end = 0;
    watch(solver, std::lround(60 * seconds), judge, [&] {
        const std::vector<Vec<double>> x = solver.positions();
        double strain = 0;
        for (std::size_t i = 0; i < links.rows.size(); ++i)
            strain = std::max(strain,
                              std::fabs(plait::length(x[i + 1] - x[i]) / links.rows[i].rest - 1));
        end = top.y - x.back().y;
        return judge.see(mechanicalEnergy(world, solver), strain);
    });
    if (std::fabs(end - length) > allowed) judge.seeDrift();
    return judge.outcome();
}

}  // namespace plait
