// What measures ask of their input, in one place. Each throws std::invalid_argument with one line.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

namespace plait {

inline void checkSameSize(std::size_t a, std::size_t b, const char* what) {
    if (a != b) {
        throw std::invalid_argument(std::string(what) + ": " + std::to_string(a) + " and " +
                                    std::to_string(b) + " of them");
    }
}

// Every index of every tuple names one of `count` points.
template <class Tuple>
void checkIndices(std::span<const Tuple> tuples, std::size_t count) {
    for (const Tuple& tuple : tuples) {
        for (const int i : tuple) {
            if (i < 0 || static_cast<std::size_t>(i) >= count) {
                throw std::invalid_argument("vertex " + std::to_string(i) + " is not one of " +
                                            std::to_string(count));
            }
        }
    }
}

}  // namespace plait
