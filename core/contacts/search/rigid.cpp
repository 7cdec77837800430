#include "rigid.h"

#include "../../numbers/elementary.h"

#include <cmath>

namespace plait {
namespace {

using Matrix = std::array<Vec<double>, 3>;  // rows

Vec<double> column(const Matrix& m, int i) {
    const auto at = [i](const Vec<double>& a) { return i == 0 ? a.x : i == 1 ? a.y : a.z; };
    return {at(m[0]), at(m[1]), at(m[2])};
}

// By the angle |w| about w, after m; again orthogonal to rounding.
Matrix turned(const Vec<double>& w, const Matrix& m) {
    const double angle = length(w);
    const Vec<double> axis = (1 / angle) * w;
    const double c = cosine(angle), s = sine(angle);
    const auto turn = [&](const Vec<double>& a) {
        return c * a + s * cross(axis, a) + (1 - c) * dot(axis, a) * axis;
    };
    const Vec<double> x = turn(column(m, 0)), y = turn(column(m, 1)), z = turn(column(m, 2));
    return {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
}

}  // namespace

Rigid rigidMotion(std::span<const Vec<double>> before, std::span<const Vec<double>> now,
                  std::span<const int> vertices) {
    Rigid motion;
    if (vertices.empty()) return motion;
    motion.isNone = false;
    const double share = 1 / static_cast<double>(vertices.size());
    for (const int v : vertices) motion.from += share * before[v], motion.to += share * now[v];
    Matrix sums{};  // of now times before, by columns of before
    for (const int v : vertices) {
        const Vec<double> a = before[v] - motion.from, b = now[v] - motion.to;
        sums[0] += a.x * b, sums[1] += a.y * b, sums[2] += a.z * b;
    }
    constexpr int rounds = 20;
    for (int round = 0; round < rounds; ++round) {
        Vec<double> turn{};
        double along = 0;
        for (int i = 0; i < 3; ++i) {
            const Vec<double> axis = column(motion.rows, i);
            turn += cross(axis, sums[i]);
            along += dot(axis, sums[i]);
        }
        const Vec<double> w = (1 / (std::fabs(along) + 1e-30)) * turn;
        if (!(dot(w, w) > 1e-24)) break;
        motion.rows = turned(w, motion.rows);
    }
    return motion;
}

}  // namespace plait
