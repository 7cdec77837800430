// Rigid sheets: how fine a curtain a number of substeps holds together, and how many sweeps BDF2
// needs so that a sheet does not crumple.
#include "map.h"
#include "watch.h"

#include <plait/forces/gravity.h>
#include <plait/measure/strain.h>
#include <plait/stencils.h>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

// 1 m x 1 m of 0.2 kg/m^2, every edge rigid.
struct Sheet {
    Sheet(int side, const Frame& frame) {
        const Range all = world.add(grid({.columns = side, .rows = side}, frame), {.density = 0.2});
        world.act<Gravity>(GravityOptions{.acceleration = gravity});
        const auto links = restRows<Stretch>(edgeStencils(world.complex, all), world.rest);
        for (std::size_t i = 0; i < links.rows.size(); ++i) {
            edges.push_back({links.ids[2 * i], links.ids[2 * i + 1]});
            rest.push_back(links.rows[i].rest);
        }
        world.constrain(links, {.name = "stretch"});
    }

    World world;
    std::vector<std::array<int, 2>> edges;
    std::vector<double> rest;
};

struct Watched {
    double seconds, allowedStrain;
    bool common = false;  // the strain that 99 % of edges keep, not the greatest
    bool atEnd = false;   // drifting is decided by the last frame
};

Outcome fall(const Sheet& sheet, const SolverOptions& options, const Watched& watched) {
    Solver<double> solver(sheet.world, options);
    Judge judge(mechanicalEnergy(sheet.world, solver), watched.atEnd ? 2 : watched.allowedStrain);
    double strain = 0;
    watch(solver, std::lround(24 * watched.seconds), judge, [&] {
        const StrainSummary s = summarizeStrain(solver.positions(), sheet.edges, sheet.rest);
        strain = watched.common ? s.percentile99 : std::max(s.maximum, -s.minimum);
        return judge.see(mechanicalEnergy(sheet.world, solver), strain);
    });
    if (strain > watched.allowedStrain) judge.seeDrift();
    return judge.outcome();
}

}  // namespace

StabilityMap resolutionMap() {
    constexpr double allowed = 0.02;
    const auto cell = [](double substeps, double links) {
        const int side = static_cast<int>(links) + 1;
        Sheet curtain(side, {.origin = {0, 3, 0}, .up = {0, -1, 0}});
        curtain.world.pin(pointStencils({0, side}));
        const SolverOptions options{
            .schedule = {.substeps = static_cast<int>(substeps), .iterations = 1}, .damping = 0.9};
        return fall(curtain, options, {.seconds = 1, .allowedStrain = allowed, .atEnd = true});
    };
    // The worst link of the colour that is swept first is too long by 2 h^2 N / m of its mass's
    // weight (A1), which is 2 g h^2 N^2 of its length.
    const auto theory = [](double substeps) {
        return 24 * substeps * std::sqrt(allowed / (2 * -gravity.y));
    };
    return {.name = "resolution",
            .title = "How fine a curtain a number of substeps holds together",
            .words =
                "A sheet of rigid edges, 1 m × 1 m, hangs from its upper edge for 1 s with "
                "damping, swept once a substep. It drifts where an edge ends more than 2 % "
                "too long or too short.",
            .note = "xpbd, one sweep a substep; drifting: an edge more than 2 % wrong at rest",
            .theoryWords =
                "a chain of as many links in two colours: 2 g h^2 N^2 of a link's "
                "length; the sheet has diagonals and more colours",
            .x = {"substeps in 1/24 s", 1, 128, true},
            .y = {"links along an edge of the sheet", 2, 64, true},
            .fails = Outcome::drifting,
            .boundaryAt = {4, 16, 64},
            .panels = {{"xpbd", cell, theory}}};
}

StabilityMap bdf2SweepsMap() {
    const auto cell = [](Sweeps sweeps) {
        return [=](double substeps, double times) {
            constexpr int side = 12;
            Sheet sheet(side, {.origin = {0, 3, 0}, .up = {0, 0, 1}});
            sheet.world.pin({0, side - 1});
            const SolverOptions options{.integrator = Integrator::bdf2,
                                        .sweeps = sweeps,
                                        .schedule = {.substeps = static_cast<int>(substeps),
                                                     .iterations = static_cast<int>(times)}};
            return fall(sheet, options, {.seconds = 1, .allowedStrain = 0.1, .common = true});
        };
    };
    return {
        .name = "bdf2-sweeps",
        .title = "How converged BDF2 wants a sheet",
        .words =
            "A sheet of 12 × 12 vertices, 1 m × 1 m with rigid edges, falls from flat into two "
            "pinned corners, for 1 s. It drifts where more than 1 % of its edges are more than "
            "10 % wrong in a frame.",
        .note = "12 × 12 rigid sheet that falls into two pins; drifting: 1 % of edges 10 % wrong",
        .theoryWords =
            "one way, one sweep a substep is linearly unstable from a curved 8 × 8 sheet "
            "up, so it takes 2 at least; palindromic sweeps have eigenvalues in [0, 1], "
            "for which BDF2 grows by no more than 2e-4 a substep",
        .x = {"substeps in 1/24 s", 4, 128, true},
        .y = {"sweeps in a substep", 1, 32, true},
        .goodAtLowY = false,
        .boundaryAt = {16, 32, 64},
        .panels = {{"one way", cell(Sweeps::oneWay), [](double) { return 2.0; }, true},
                   {"palindrome", cell(Sweeps::palindrome)}}};
}

}  // namespace plait
