#include "difference.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>

namespace plait {
namespace {

using detail::magnitude;

template <class T>
Vec<T> difference(const Vec<double>& a, const Vec<double>& b) {
    return {T(a.x) - T(b.x), T(a.y) - T(b.y), T(a.z) - T(b.z)};
}

// From vertex i to vertex j.
template <class T, int k>
Moving<T> path(const MovingVertex (&v)[k], int i, int j) {
    return {difference<T>(v[j].start, v[i].start), difference<T>(v[j].end, v[i].end)};
}

// The power of two that brings `size` to [0.5, 1), or near it where that is not a double.
double scaleFor(double size) {
    const auto exponent = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(size) >> 52);
    return std::bit_cast<double>(
        static_cast<std::uint64_t>(std::clamp<std::int64_t>(2045 - exponent, 1, 2045)) << 52);
}

// The vertices and the thickness, scaled.
template <int k>
void bring(MovingVertex (&vertex)[k], double& thickness) {
    double size = thickness, wrong = thickness * 0;
    const auto each = [&](auto action) {
        for (MovingVertex& m : vertex) {
            for (double* c : {&m.start.x, &m.start.y, &m.start.z, &m.end.x, &m.end.y, &m.end.z})
                action(*c);
        }
    };
    each([&](double c) {
        size = std::max(size, magnitude(c));
        wrong += c * 0;  // not a number unless c is finite
    });
    if (wrong != 0 || thickness < 0)
        throw std::invalid_argument(
            "collision query: coordinates and thickness must be finite, thickness not below 0");
    const double scale = scaleFor(size);
    each([&](double& c) { c *= scale; });
    thickness *= scale;
}

}  // namespace

template <class T>
Difference<1, T> pointPoint(const MovingVertex& a, const MovingVertex& b, double thickness) {
    MovingVertex v[]{a, b};
    bring(v, thickness);
    return {{path<T>(v, 0, 1)}, {}, thickness};
}

template <class T>
Difference<2, T> pointEdge(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                           double thickness) {
    MovingVertex v[]{p, a, b};
    bring(v, thickness);
    return {{path<T>(v, 0, 1), path<T>(v, 0, 2)}, {path<T>(v, 1, 2)}, thickness};
}

template <class T>
Difference<3, T> pointTriangle(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                               const MovingVertex& c, double thickness) {
    MovingVertex v[]{p, a, b, c};
    bring(v, thickness);
    return {{path<T>(v, 0, 1), path<T>(v, 0, 2), path<T>(v, 0, 3)},
            {path<T>(v, 1, 2), path<T>(v, 2, 3), path<T>(v, 3, 1)},
            thickness};
}

template <class T>
Difference<4, T> edgeEdge(const MovingVertex& a, const MovingVertex& b, const MovingVertex& c,
                          const MovingVertex& d, double thickness) {
    MovingVertex v[]{a, b, c, d};
    bring(v, thickness);
    return {{path<T>(v, 0, 2), path<T>(v, 0, 3), path<T>(v, 1, 3), path<T>(v, 1, 2)},
            {path<T>(v, 2, 3), path<T>(v, 1, 0), path<T>(v, 3, 2), path<T>(v, 0, 1)},
            thickness};
}

#define PLAIT_DIFFERENCES(T)                                                                   \
    template Difference<1, T> pointPoint(const MovingVertex&, const MovingVertex&, double);    \
    template Difference<2, T> pointEdge(const MovingVertex&, const MovingVertex&,              \
                                        const MovingVertex&, double);                          \
    template Difference<3, T> pointTriangle(const MovingVertex&, const MovingVertex&,          \
                                            const MovingVertex&, const MovingVertex&, double); \
    template Difference<4, T> edgeEdge(const MovingVertex&, const MovingVertex&,               \
                                       const MovingVertex&, const MovingVertex&, double);
PLAIT_DIFFERENCES(double)
PLAIT_DIFFERENCES(DoubleDouble)

}  // namespace plait
