#include "noise.h"

namespace plait {
namespace {

// The finaliser of SplitMix64 (Steele, Lea & Flood 2014).
std::uint64_t mix(std::uint64_t a) {
    a = (a ^ (a >> 30)) * 0xbf58476d1ce4e5b9;
    a = (a ^ (a >> 27)) * 0x94d049bb133111eb;
    return a ^ (a >> 31);
}

// One axis: for the lattice points below and above, distance, weight and hash.
struct Axis {
    double distance[2], weight[2];
    std::uint64_t hash[2];
};

Axis axisOf(double x, std::uint64_t seed) {
    auto cell = static_cast<std::int64_t>(x);
    if (x < static_cast<double>(cell)) --cell;
    const double f = x - static_cast<double>(cell);
    const double s = f * f * f * (10 + f * (6 * f - 15));
    const auto at = static_cast<std::uint64_t>(cell);
    return {{f, f - 1}, {1 - s, s}, {mix(seed ^ mix(at)), mix(seed ^ mix(at + 1))}};
}

// Two axes together: for their four corners, weight, hash, and distance along the gradients
// (+-1, +-1), by the two bits that choose the signs.
struct Plane {
    double weight[4], along[4][4];
    std::uint64_t hash[4];
};

Plane planeOf(const Axis& a, const Axis& b) {
    Plane plane;
    for (int corner = 0; corner < 4; ++corner) {
        const int i = corner & 1, j = corner >> 1;
        const double x = a.distance[i], y = b.distance[j];
        plane.weight[corner] = a.weight[i] * b.weight[j];
        plane.hash[corner] = a.hash[i] + b.hash[j];
        double* along = plane.along[corner];
        along[0] = x + y, along[1] = y - x, along[2] = x - y, along[3] = -x - y;
    }
    return plane;
}

}  // namespace

Vec<double> coherentNoise(const Vec<double>& x, double t, std::uint64_t seed) {
    const double point[4] = {x.x, x.y, x.z, t};
    Axis axis[4];
    for (int a = 0; a < 4; ++a) {
        if (!(point[a] > -1e15 && point[a] < 1e15)) return {0, 0, 0};
        axis[a] = axisOf(point[a], mix(mix(seed) + static_cast<std::uint64_t>(a)));
    }
    const Plane xy = planeOf(axis[0], axis[1]), zt = planeOf(axis[2], axis[3]);
    double sum[3] = {};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            // A gradient is one of the 16 diagonals (+-1, +-1, +-1, +-1): four bits a component.
            std::uint64_t bits = mix(xy.hash[i] + zt.hash[j]);
            for (double& component : sum) {
                component += xy.weight[i] * zt.weight[j] *
                             (xy.along[i][bits & 3] + zt.along[j][bits >> 2 & 3]);
                bits >>= 4;
            }
        }
    // The mean square is 64 I2 I0^3 with I0 = 181/462 and I2 = 535/18018, the integrals of s^2 and
    // (1 - f)^2 s^2 over a cell.
    constexpr double rms = 0.33804030562349907;
    return {sum[0] / rms, sum[1] / rms, sum[2] / rms};
}

}  // namespace plait
