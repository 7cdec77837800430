// Pseudo-random numbers from a seed: splitmix64 (Steele, Lea and Flood 2014), the same everywhere.
#pragma once

#include <cstdint>

namespace plait {

class Splitmix {
public:
    explicit Splitmix(std::uint64_t seed) : state_(seed) {}

    // 0 to 1, without 1.
    double next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    // -1 to 1.
    double both() { return 2 * next() - 1; }

private:
    std::uint64_t state_;
};

}  // namespace plait
