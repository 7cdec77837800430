// What the tests of Newton's method share.
#pragma once

#include "tests/worlds.h"

#include <string>

namespace plait::test {

using Point = Vec<double>;

inline constexpr double g = 9.81;
inline constexpr Integrator all[] = {Integrator::first, Integrator::bdf2, Integrator::midpoint};

inline std::string nameOf(Integrator integrator) {
    constexpr const char* names[] = {"backward Euler", "BDF2", "midpoint"};
    return names[static_cast<int>(integrator)];
}

inline SolverOptions newton(int stepsPerSecond, Integrator integrator) {
    SolverOptions options = stepping(stepsPerSecond, integrator);
    options.method = Method::newton;
    return options;
}

}  // namespace plait::test
