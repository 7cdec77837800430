// Small worlds that tests start from, and what it takes to run them step by step.
#pragma once

#include <plait/forces/gravity.h>
#include <plait/measure/strain.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace plait::test {

using Points = std::vector<Vec<double>>;

// Points without links, 1 kg each.
inline World loosePoints(const Points& at) {
    World world;
    world.add({SimplicialComplex(static_cast<int>(at.size())), at});
    return world;
}

// A chain of rigid links through these points (m), the first one pinned, of these masses (kg).
inline World linkedPoints(const Points& at, const std::vector<double>& mass, bool direct = false) {
    World world;
    const Range all = world.add({chain({.links = static_cast<int>(at.size()) - 1}).complex, at});
    world.mass = mass;
    world.pin({all.first});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, all), world.rest),
                    {.name = "links", .direct = direct});
    return world;
}

// A chain that hangs straight down from a pinned top, a mass at the lower end of each link, in
// gravity of 9.81 m/s^2 and without links yet. Lengths in m, masses in kg.
struct PlumbLine {
    int links = 1;
    double length = 1;  // of a link
    double mass = 1;
    Vec<double> top{0, 0, 0};
    Vec<double> down{0, -1, 0};  // unit
};

inline World plumbLine(const PlumbLine& p) {
    World world;
    const Vec<double> bottom = p.top + p.links * p.length * p.down;
    world.add(chain({.links = p.links, .from = p.top, .to = bottom}));
    world.mass.assign(world.mass.size(), p.mass);
    world.pin({0});
    world.act<Gravity>(GravityOptions{.acceleration = 9.81 * p.down});
    return world;
}

// Every edge of the world as a link of its rest length.
inline Rows<Stretch> linksOf(const World& world, double compliance = 0) {
    const Range all{0, static_cast<int>(world.start.size())};
    return restRows<Stretch>(edgeStencils(world.complex, all), world.rest, compliance);
}

// How far each link is from its rest length, over that length.
inline std::vector<double> strainsOf(const Rows<Stretch>& links, const Points& x) {
    std::vector<std::array<int, 2>> edges;
    std::vector<double> rest;
    for (std::size_t i = 0; i < links.rows.size(); ++i) {
        edges.push_back({links.ids[2 * i], links.ids[2 * i + 1]});
        rest.push_back(links.rows[i].rest);
    }
    return strains(x, edges, rest);
}

// A substep is a frame.
inline SolverOptions stepping(int stepsPerSecond, Integrator integrator = Integrator::first) {
    return {.integrator = integrator,
            .schedule = {.substeps = 1, .frameRate = {stepsPerSecond, 1}, .iterations = 1}};
}

template <class Real>
void advance(Solver<Real>& solver, int frames) {
    for (int i = 0; i < frames; ++i) solver.frame();
}

// The largest speed of any vertex, in m/s.
template <class Real>
double topSpeed(const Solver<Real>& solver) {
    double most = 0;
    for (const Vec<double>& v : solver.velocities()) most = std::max(most, length(v));
    return most;
}

}  // namespace plait::test
