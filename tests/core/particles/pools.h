// Liquids in tanks, for tests.
#pragma once

#include <plait/complex/shapes.h>
#include <plait/contacts/solids/collider.h>
#include <plait/forces/gravity.h>
#include <plait/particles/liquid.h>
#include <plait/solver.h>

#include <random>
#include <vector>

namespace plait::test {

inline Collider wallAt(const Vec<double>& at, const Vec<double>& up, const Vec<double>& across) {
    Collider wall{.solid = Solid::plane(), .frame = {at, across, up}};
    wall.staticFriction = wall.dynamicFriction = 0;
    return wall;
}

// Open above, from 0 to width along x and to depth along z.
inline std::vector<Collider> openTank(double width, double depth) {
    return {wallAt({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), wallAt({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
            wallAt({width, 0, 0}, {-1, 0, 0}, {0, 1, 0}), wallAt({0, 0, 0}, {0, 0, 1}, {1, 0, 0}),
            wallAt({0, 0, depth}, {0, 0, -1}, {1, 0, 0})};
}

// A block of water from the origin on, as a lattice, shaken by `jitter` spacings to either side.
inline std::vector<Vec<double>> blockOf(int nx, int ny, int nz, double spacing, double jitter = 0) {
    std::mt19937 random(7);
    const auto shaken = [&](int i) {
        const double u = static_cast<double>(random()) / 4294967296.0;
        return (i + 0.5 + jitter * (2 * u - 1)) * spacing;
    };
    std::vector<Vec<double>> positions;
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                const double x = shaken(i), y = shaken(j), z = shaken(k);
                positions.push_back({x, y, z});
            }
    return positions;
}

struct Pool {
    World world;
    Liquid liquid;

    Pool(std::vector<Vec<double>> positions, double spacing, std::vector<Collider> walls = {}) {
        const auto n = static_cast<int>(positions.size());
        liquid.particles = world.add({SimplicialComplex(n), std::move(positions)},
                                     {.density = 1000 * spacing * spacing * spacing});
        liquid.spacing = spacing;
        liquid.walls = std::move(walls);
    }
    // Gravity, densities, and contacts with the walls.
    void fall(double gravity = 9.81) {
        world.act<Gravity>(GravityOptions{.acceleration = {0, -gravity, 0}});
        holdDensity(world, liquid, {.name = "density"});
        collide(world, liquid.walls, {surfaceOf(liquid)}, {.name = "tank", .order = 1});
    }
};

// Fifty frames a second.
inline SolverOptions perSecond(int substeps, int threads = 1) {
    SolverOptions options;
    options.schedule = {
        .substeps = substeps / 50, .frameRate = {50, 1}, .iterations = 1, .collisionPasses = 1};
    options.threads = threads;
    return options;
}

}  // namespace plait::test
