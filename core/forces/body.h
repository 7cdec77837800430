// What forces that act on mass share: whom they act on, and how acceleration becomes velocity.
#pragma once

#include "../complex/complex.h"
#include "../state.h"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace plait {

// 1 for each of `count` vertices that lies in one of `objects`. Throws std::invalid_argument,
// naming `what`, for a range that is not within 0 .. count.
inline std::vector<std::uint8_t> markObjects(int count, std::span<const Range> objects,
                                             const std::string& what) {
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(count), 0);
    for (const Range& range : objects) {
        if (range.first < 0 || range.last < range.first || range.last > count)
            throw std::invalid_argument(what +
                                        ": no such vertices: " + std::to_string(range.first) +
                                        " to " + std::to_string(range.last));
        for (int i = range.first; i < range.last; ++i) marks[static_cast<std::size_t>(i)] = 1;
    }
    return marks;
}

// v <- v + dv for a force that is proportional to mass: no mass enters [AW9].
template <class Real>
void accelerate(State<Real>& state, std::size_t i, const Vec<Real>& dv) {
    if (state.particles[i].w > Real(0)) state.velocity[i].v += dv;
}

}  // namespace plait
