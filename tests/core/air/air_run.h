// A plate, or a crumpled sheet, in air and gravity alone: positions stay.
#pragma once

#include "tests/hand_state.h"
#include "tests/random.h"

#include <plait/air/air.h>
#include <plait/forces/gravity.h>

#include <cmath>
#include <numbers>

namespace plait::test {

inline constexpr double sigma = 0.2, g = 9.81;  // kg/m^2, m/s^2
inline constexpr AirForm legacy = AirForm::legacy, physical = AirForm::physical;

// A plate whose normal is at the angle `tilt` to the vertical.
inline World plate(double tilt, double density = sigma) {
    World world;
    world.add(grid({.columns = 6, .rows = 5},
                   {.across = {std::cos(tilt), std::sin(tilt), 0}, .up = {0, 0, -1}}),
              {.density = density});
    return world;
}

inline constexpr double edgeOn = std::numbers::pi / 2;

inline std::function<Vec<double>(double)> steady(const Vec<double>& velocity) {
    return [velocity](double) { return velocity; };
}

template <class Real = double>
struct Run {
    World world;
    Gravity<Real> gravity;
    Air<Real> air;
    State<Real> state;
    Workers workers;

    Run(const World& of, const AirOptions& options, int threads = 1)
        : world(of),
          gravity(world, {.acceleration = {0, -g, 0}}),
          air(world, options),
          state(stateOf<Real>(world)),
          workers(threads) {}

    void fall(int substeps, double h) {
        for (int s = 0; s < substeps; ++s) act<Real>(state, {&gravity, &air}, h, workers);
    }
    void blow(double h) { act<Real>(state, {&air}, h, workers); }
    Vec<double> velocity() const { return widened(state.velocity[0].v); }

    // Of what is free.
    double energy() const {
        double sum = 0;
        for (std::size_t i = 0; i < world.mass.size(); ++i) {
            if (world.pinned[i]) continue;
            const Vec<double> v = widened(state.velocity[i].v);
            sum += world.mass[i] * dot(v, v) / 2;
        }
        return sum;
    }
};

// A crumpled sheet of uneven mass, some of it pinned, in disorder.
inline World crumpled() {
    World world;
    Random random(11);
    Shape shape = grid({.columns = 12, .rows = 9});
    std::vector<Vec<double>> start, velocity;
    for (const Vec<double>& x : shape.positions) {
        start.push_back(x + 0.2 * random.point(1));
        velocity.push_back(20.0 * random.point(1));
    }
    world.add(shape, {.density = sigma, .start = start, .velocity = velocity});
    for (double& mass : world.mass) mass *= random.uniform(0.02, 1);
    world.pin({3, 50, 77});
    for (const int i : {3, 50, 77}) world.velocity[static_cast<std::size_t>(i)] = {0, 0, 0};
    return world;
}

}  // namespace plait::test
