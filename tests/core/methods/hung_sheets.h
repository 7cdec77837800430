// Sheets that hang from two corners, and what the tests of the method global look at.
#pragma once

#include "newton_options.h"
#include "tests/shells.h"
#include "tests/worlds.h"

#include <plait/measure/energy.h>

#include <algorithm>
#include <cmath>

namespace plait::test {

inline constexpr int framesPerSecond = 60;

inline SolverOptions global(int iterations, Integrator integrator = Integrator::bdf2,
                            int threads = 1) {
    SolverOptions options = stepping(framesPerSecond, integrator);
    options.method = Method::global;
    options.schedule.iterations = iterations;
    options.threads = threads;
    return options;
}

// Flat, of 1 m and 0.2 kg/m^2, at rest.
inline World flatSheet(int n, double compliance = 0) {
    World world;
    world.add(grid({.columns = n, .rows = n}, {.across = {1, 0, 0}, .up = {0, 0, 1}}),
              {.density = 0.2});
    world.constrain(linksOf(world, compliance), {.name = "stretch"});
    return world;
}

inline World hungSheet(int n, double compliance = 0) {
    World world = flatSheet(n, compliance);
    world.pin({0, n - 1});
    world.act<Gravity>(GravityOptions{});
    return world;
}

// The same of disorderly triangles.
inline World hungShell(int n) {
    const Shell shell = shellOf(n, n, 7);
    World world;
    world.add({SimplicialComplex(n * n), shell.rest});
    for (Vec<double>& x : world.start) x = {x.x, 0, x.y};
    world.rest = world.start;
    world.mass.assign(world.mass.size(), 0.2 / (n * n));
    world.pin({0, n - 1});
    world.constrain(restRows<Stretch>(shell.links, world.rest), {.name = "stretch"});
    world.act<Gravity>(GravityOptions{});
    return world;
}

inline double greatestStrain(const Rows<Stretch>& links, const Points& x) {
    double most = 0;
    for (const double e : strainsOf(links, x)) most = std::max(most, e);
    return most;
}

inline double lowest(const Points& x) {
    double y = x[0].y;
    for (const Vec<double>& p : x) y = std::min(y, p.y);
    return y;
}

// Two seconds of a hung sheet.
struct Swing {
    double mean = 0, worst = 0;  // largest strain of a frame, over the last second
    double bottom = 0;           // m, of the first 0.6 s
    double second = 0;           // m, lowest point at 1 s
    double energy = -1;          // J, most that it had
    long evaluations = 0;        // in a frame
};

inline Swing swingOf(const World& world, const Rows<Stretch>& links, const SolverOptions& options) {
    Solver<float> solver(world, options);
    Swing swing;
    for (int frame = 1; frame <= 2 * framesPerSecond; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        swing.energy =
            std::max(swing.energy, kineticEnergy(world.mass, solver.velocities()) +
                                       gravitationalEnergy(world.mass, x, {0, -9.81, 0}));
        if (frame <= 36) swing.bottom = std::min(swing.bottom, lowest(x));
        if (frame == framesPerSecond) swing.second = lowest(x);
        if (frame <= framesPerSecond) continue;
        const double strain = greatestStrain(links, x);
        swing.worst = std::max(swing.worst, strain);
        swing.mean += strain / framesPerSecond;
    }
    swing.evaluations = solver.evaluations() / (2 * framesPerSecond);
    return swing;
}

}  // namespace plait::test
