// Sheets that hang from some of their vertices and fall, on any mesh, and what is looked at while
// they do.
#pragma once

#include "tests/random.h"
#include "tests/worlds.h"

#include <plait/measure/energy.h>
#include <plait/sheets/inextensible.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace plait::test {

inline constexpr Frame lying{.across = {1, 0, 0}, .up = {0, 0, 1}};

inline Shape square(int n) { return grid({.columns = n, .rows = n}, lying); }

// Dented by 1 mm, as in the study: flat, rounding alone decides which way it buckles.
inline Shape dented(int n) {
    Shape shape = square(n);
    for (Vec<double>& x : shape.positions)
        x.y -= 1e-3 * (std::sin(pi * x.x) + 0.5 * std::sin(2 * pi * x.x)) * std::sin(-pi * x.z);
    return shape;
}

// The same vertices, those inside moved by up to 0.3 of a cell, and each diagonal turned by chance.
inline Shape disordered(int n) {
    Random random(4);
    Shape shape = square(n);
    Simplices simplices;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
            const int v = r * n + c;
            const double far = 0.3 / (n - 1);
            if (r > 0 && c > 0 && r + 1 < n && c + 1 < n)
                shape.positions[v] +=
                    Vec<double>{random.uniform(-far, far), 0, random.uniform(-far, far)};
            if (r + 1 == n || c + 1 == n) continue;
            const int w = v + n;
            if (random.below(2)) {
                simplices.triangles.push_back({v, v + 1, w + 1});
                simplices.triangles.push_back({v, w + 1, w});
            } else {
                simplices.triangles.push_back({v, v + 1, w});
                simplices.triangles.push_back({v + 1, w + 1, w});
            }
        }
    shape.complex = SimplicialComplex(n * n, simplices);
    return shape;
}

struct Course {
    double worst = 0;        // strain of an edge over the last second
    double before = 0;       // over all frames before
    double energy = -1e30;   // J, the highest; the start has 0
    double swing = 0;        // m, lowest in the first 40 frames
    double atOneSecond = 0;  // m, the lowest point
    double lost = 0;         // J, in the first second
    int swingFrame = 0;
    long work = 0;  // evaluations a frame
};

struct Work {
    int substeps = 12, iterations = 1;  // of a frame of 1/60 s
    SheetOptions sheet = {};
    Motion motion = {};
    int frames = 120;
    Method method = Method::xpbd;
    double bending = 0;  // N m
};

// 0.2 kg/m^2 in gravity, held at `pins`.
inline World hung(const Shape& shape, const std::vector<int>& pins, const Work& work,
                  const Matter& matter = {.density = 0.2}) {
    World world;
    const Range sheet = world.add(shape, matter);
    world.pin(pins, work.motion);
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, sheet, work.sheet);
    if (work.bending > 0)
        world.constrain(bendRows(world.complex, sheet, world.rest, work.bending),
                        {.name = "bend", .order = 1});
    return world;
}

inline SolverOptions optionsOf(const Work& work) {
    SolverOptions options;
    options.method = work.method;
    options.schedule = {
        .substeps = work.substeps, .frameRate = {60, 1}, .iterations = work.iterations};
    return options;
}

template <class Real = float>
Course fall(const std::string& name, const Shape& shape, const std::vector<int>& pins,
            const Work& work = {}) {
    const World world = hung(shape, pins, work);
    const Rows<Stretch> edges = linksOf(world);
    Solver<Real> solver(world, optionsOf(work));
    Course course;
    const auto energy = [&] {
        return kineticEnergy(world.mass, solver.velocities()) +
               gravitationalEnergy(world.mass, solver.positions(), {0, -9.81, 0});
    };
    const double start = energy();
    for (int frame = 1; frame <= work.frames; ++frame) {
        solver.frame();
        const Points x = solver.positions();
        double strain = 0, lowest = 0;
        for (const double e : strainsOf(edges, x)) strain = std::max(strain, e);
        for (const Vec<double>& p : x) lowest = std::min(lowest, p.y);
        (frame > 60 ? course.worst : course.before) =
            std::max(frame > 60 ? course.worst : course.before, strain);
        course.energy = std::max(course.energy, energy() - start);
        if (frame <= 40 && lowest < course.swing) course.swing = lowest, course.swingFrame = frame;
        if (frame == 60) course.atOneSecond = lowest, course.lost = start - energy();
    }
    course.work = solver.evaluations() / work.frames;
    std::printf(
        "    %-22s %2d x %d: strain %.2f %%, before %.2f %%; swings to %.3f m (%d), %.3f m and "
        "-%.3f J at 1 s; E %.1e J; %.2f M\n",
        name.c_str(), work.substeps, work.iterations, 100 * course.worst, 100 * course.before,
        course.swing, course.swingFrame, course.atOneSecond, course.lost, course.energy,
        1e-6 * static_cast<double>(course.work));
    return course;
}

}  // namespace plait::test
