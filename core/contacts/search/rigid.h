// The rigid motion that best takes points to where they are by now: what a search for pairs found
// holds as long as nothing has moved far against it, however fast a dancer turns.
#pragma once

#include "../../numbers/math.h"

#include <array>
#include <span>

namespace plait {

struct Rigid {
    std::array<Vec<double>, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // of a rotation
    Vec<double> from{}, to{};                                            // m
    bool isNone = true;                                                  // nothing moves

    Vec<double> operator()(const Vec<double>& x) const {
        const Vec<double> a = x - from;
        return to + Vec<double>{dot(rows[0], a), dot(rows[1], a), dot(rows[2], a)};
    }
    // Where it takes here from.
    Vec<double> back(const Vec<double>& x) const {
        const Vec<double> a = x - to;
        return from + a.x * rows[0] + a.y * rows[1] + a.z * rows[2];
    }
};

// Near the best in the sense of least squares from `before` to `now`, for these vertices, and
// always rigid. Rotations that differ by less than half a turn (Müller et al., A robust method to
// extract the rotational part of deformations, 2016).
Rigid rigidMotion(std::span<const Vec<double>> before, std::span<const Vec<double>> now,
                  std::span<const int> vertices);

}  // namespace plait
