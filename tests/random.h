// Reproducible numbers for tests: the same on every compiler, unlike the library's distributions.
#pragma once

#include <plait/numbers/math.h>

#include <cstdint>

namespace plait::test {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    // splitmix64 (Steele, Lea, Flood 2014).
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }
    int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
    Vec<double> point(double size) {
        return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
    }

private:
    std::uint64_t state_;
};

}  // namespace plait::test
