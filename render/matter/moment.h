// What a picture is of.
#pragma once

#include <plait/numbers/math.h>

#include <cstdint>
#include <span>

namespace plait {

// Where all vertices of the world are (m) at a time (s).
struct Moment {
    std::span<const Vec<double>> positions;
    double time = 0;
    // By vertex: which of its source it is, and its age, s; below 0: not there. Empty: all are.
    std::span<const std::int32_t> ids = {};
    std::span<const double> ages = {};
    std::span<const Vec<double>> velocities = {};  // m/s; empty: nothing moves
    std::span<const std::int32_t> cuts = {};       // edges that have come apart (State::cuts)
};

}  // namespace plait
