// A rod that droops under its weight (validation A2): how finely it may be divided, swept joint by
// joint or solved at once.
#include "demos/study/references/heavy_rod.h"
#include "map.h"
#include "watch.h"

#include <plait/forces/gravity.h>
#include <plait/rods/bend_vector.h>
#include <plait/rods/chain_set.h>
#include <plait/stencils.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

// 1 m, 1 kg/m, clamped in the middle of its first link.
constexpr double gamma = 1, bending = -gravity.y / gamma;  // w L^3 / B; N m^2
constexpr double droopAllowed = 0.01;                      // of the droop
constexpr double height = 3;                               // m
constexpr double trembling = 1e-3;                         // m/s

double linkOf(int links) { return 1 / (links - 0.5); }

World worldOf(int links, bool atOnce) {
    World world;
    const double l = linkOf(links);
    const Range rod = world.add(
        chain({.links = links, .from = {-l / 2, height, 0}, .to = {1, height, 0}}), {.density = 1});
    world.pin({0, 1});
    world.act<Gravity>(GravityOptions{.acceleration = gravity});
    const auto stretch = restRows<Stretch>(edgeStencils(world.complex, rod), world.rest);
    if (!atOnce) {
        world.constrain(stretch, {.name = "stretch"});
        world.constrain(curveBendRows(world.complex, rod, world.rest, bending),
                        {.name = "bend", .order = 1});
        return world;
    }
    Rows<BendVector> bends;
    for (int v = 0; v + 2 <= links; ++v) {
        bends.ids.insert(bends.ids.end(), {v, v + 1, v + 2});
        bends.rows.push_back({l / bending});
    }
    Chains chains;
    chains.addCurve(pointStencils(rod));
    chains.add(stretch);
    chains.add(bends);
    chains.constrain(world, {.name = "rod"});
    return world;
}

Outcome droop(int links, int substeps, bool atOnce) {
    const World world = worldOf(links, atOnce);
    SolverOptions options{
        .schedule = {.substeps = substeps, .frameRate = {60, 1}, .iterations = 1}};
    // Critical, of the slowest swing: at rest within 1e-5 after a second.
    options.damping = 0.6;
    Solver<double> solver(world, options);
    Judge judge(mechanicalEnergy(world, solver), 2);
    double drop = 0, speed = 0;
    watch(solver, 90, judge, [&] {
        drop = height - solver.positions().back().y;
        speed = length(solver.velocities().back());
        return judge.see(mechanicalEnergy(world, solver), 0);
    });
    const double exact = heavyRodTip(gamma, links).drop;
    if (!(std::fabs(drop - exact) <= droopAllowed * exact) || speed > trembling) judge.seeDrift();
    return judge.outcome();
}

// Place of joint i in the order of three colours.
int jointPlace(int i, int n) {
    const int whole = n / 3, more = n % 3;
    return i / 3 + (i % 3) * whole + std::min(i % 3, more);
}

// m, by which the tip droops too far once it has settled, if little is bent: as of chains that hang
// (hanging_chain.h), of the angles of joints.
double excessOf(int links, int substeps) {
    const int n = links - 1;
    const double l = linkOf(links), h = 1.0 / (60 * substeps);
    Eigen::MatrixXd gradients = Eigen::MatrixXd::Zero(n, n);  // by joint, by vertex from 2 on
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(n), arms(n);
    for (int i = 0; i < n; ++i) {
        const int p = jointPlace(i, n);
        arms(p) = l * (n - i);
        for (int v = i + 2; v <= links; ++v)
            lambda(p) += h * h * -gravity.y * (v == links ? 0.5 : 1) * l * l * (v - i - 1);
        for (const auto& [v, part] : {std::pair{i, 1}, {i + 1, -2}, {i + 2, 1}})
            if (v > 1) gradients(p, v - 2) = part / l / std::sqrt((v == links ? 0.5 : 1) * l);
    }
    Eigen::MatrixXd a = gradients * gradients.transpose();
    a.diagonal().array() += l / bending / (h * h);
    const Eigen::MatrixXd lower = a.triangularView<Eigen::Lower>();
    const Eigen::MatrixXd m = lower * a.diagonal().cwiseInverse().asDiagonal() * lower.transpose();
    // One sweep leaves 1 - m^-1 a of it, so that the inverse of what is gained is a^-1 m.
    return arms.dot(m * lambda - a * lambda);
}

double linksOfSweeps(double substeps) {
    int good = 2, bad = 256;
    while (bad - good > 1) {
        const int links = (good + bad) / 2;
        const bool holds = std::fabs(excessOf(links, static_cast<int>(substeps))) <=
                           droopAllowed * heavyRodTip(gamma, links).drop;
        (holds ? good : bad) = links;
    }
    return good;
}

}  // namespace

StabilityMap rodSegmentsMap() {
    const auto cell = [](bool atOnce) {
        return [=](double substeps, double links) {
            return droop(static_cast<int>(links), static_cast<int>(substeps), atOnce);
        };
    };
    return {.name = "rod-segments",
            .title = "How finely a rod may be divided",
            .words =
                "A rod of 1 m that droops by an eighth of its length, clamped at one end, falls "
                "from straight for 1.5 s with damping, with one evaluation a substep. It drifts "
                "where its tip ends more than 1 % of its droop off that of the exact chain of the "
                "same links, or still moves at more than 1 mm/s.",
            .note = "w L^3 / B = 1; drifting: the tip's droop more than 1 % wrong at rest",
            .theoryWords =
                "swept: what one sweep of a substep, forward and back, leaves of the moments, in "
                "the stationary state; its error grows as N^4 h^2. Solved at once there is none",
            .x = {"substeps in 1/60 s", 1, 128, true},
            .y = {"links", 3, 512, true},
            .fails = Outcome::drifting,
            .boundaryAt = {2, 8, 32, 128},
            .panels = {{"swept", cell(false), linksOfSweeps, true}, {"at once", cell(true)}}};
}

}  // namespace plait
