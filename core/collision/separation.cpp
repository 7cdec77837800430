#include "separation.h"

namespace plait {
namespace {

using detail::larger;
using detail::magnitude;
using detail::tiny;

// A time that is not worth dividing.
template <class T>
constexpr double instant = 0x1p10 * roundoff<T>;

// The point of the edge from a along e that is nearest to the origin.
template <class T>
Vec<T> nearestOnEdge(const Vec<T>& a, const Vec<T>& e) {
    const T s = -dot(a, e), square = dot(e, e);
    if (!(s > 0)) return a;
    return s < square ? a + (s / square) * e : a + e;
}

// From the origin to the nearest point of the polygon, or across the plane of the polygon where it
// faces the origin: which is as good and stays a direction when the two meet. No rounding here
// matters but to how well the direction parts them.
template <int k, class T>
Vec<T> direction(const Difference<k, T>& d, const T& t) {
    Vec<T> v[k];
    for (int i = 0; i < k; ++i) v[i] = at(d.corner[i], t);
    if constexpr (k == 1) return v[0];
    Vec<T> e[k];
    for (int i = 0; i < k; ++i) e[i] = at(d.side[i], t);
    if constexpr (k == 2) return nearestOnEdge(v[0], e[0]);
    if constexpr (k > 2) {
        const Vec<T> n = cross(e[0], e[1]);
        bool inside = dot(n, n) > 0;
        for (int i = 0; i < k; ++i) inside = inside && dot(n, cross(v[i], e[i])) > 0;
        if (inside) return dot(n, v[0]) > 0 ? n : -n;
    }
    Vec<T> nearest = nearestOnEdge(v[0], e[0]);
    for (int i = 1; i < k; ++i) {
        const Vec<T> w = nearestOnEdge(v[i], e[i]);
        if (dot(w, w) < dot(nearest, nearest)) nearest = w;
    }
    return nearest;
}

template <class T>
Vec<double> rounded(const Vec<T>& a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}

// The greatest that the products of a . n can add up to.
template <class T>
double along(const Vec<T>& a, const Vec<double>& n) {
    const Vec<double> b = rounded(a);
    return magnitude(b.x * n.x) + magnitude(b.y * n.y) + magnitude(b.z * n.z);
}

// How long from `from` on, at most to `to`, the direction halfway surely keeps the simplices more
// than the thickness apart; -1 if it does not even then. Along it every corner moves evenly, so
// that two ends prove all between them.
template <int k, class T>
T apartUntil(const Difference<k, T>& d, T from, T to) {
    Vec<T> n = direction(d, 0.5 * (from + to));
    const T size = larger(larger(magnitude(n.x), magnitude(n.y)), magnitude(n.z));
    if (!(size > tiny)) return -1;
    n = (1 / size) * n;

    const Vec<double> m = rounded(n);
    const double least = d.thickness * length(m) * (1 + 8 * roundoff<double>);
    T until = to;
    for (const Moving<T>& corner : d.corner) {
        const Vec<T> u = at(corner, from), v = at(corner, to);
        // What rounding may have added to the distances along n: half of 8 roundoff a term, for the
        // difference, its place and the sum, as much again for what follows.
        const double error = 8 * roundoff<T> * (along(corner.start, m) + along(corner.end, m));
        const double bound = least + error + tiny;
        const T first = dot(n, u), last = dot(n, v);
        if (!(first > bound)) return -1;
        if (!(last > bound)) {
            const T part = (first - bound) / (first - last) * (1 - 0x1p-20);
            const T t = from + part * (to - from);
            if (t < until) until = t;
        }
    }
    return until;
}

}  // namespace

template <int k>
bool apartAlongAxis(const Difference<k>& d) {
    const double bound = d.thickness * (1 + 4 * roundoff<double>)+tiny;
    const auto along = [&](double Vec<double>::* axis) {
        bool above = true, below = true;
        for (const MovingVertex& c : d.corner) {
            const double a = c.start.*axis, b = c.end.*axis;
            above = above && a > bound && b > bound;
            below = below && a < -bound && b < -bound;
        }
        return above || below;
    };
    return along(&Vec<double>::x) || along(&Vec<double>::y) || along(&Vec<double>::z);
}

template <int k, class T>
T march(const Difference<k, T>& d, T from, T to, int& budget) {
    T stride = to - from;
    while (budget-- > 0) {
        const T end = to - from > stride ? from + stride : to;
        const T until = apartUntil(d, from, end);
        if (until >= to) return beyond;
        if (until >= end) {
            stride = 2 * stride;
        } else {
            if (!(end - from > instant<T>)) return larger(from, until);
            const T gained = 4 * (until - from);
            stride = (until > from ? 0.25 : 0.125) * (end - from);
            if (until > from && gained < stride) stride = gained;
        }
        from = larger(from, until);
    }
    return from;
}

template double march(const Difference<1>&, double, double, int&);
template double march(const Difference<2>&, double, double, int&);
template double march(const Difference<3>&, double, double, int&);
template double march(const Difference<4>&, double, double, int&);
template DoubleDouble march(const Difference<2, DoubleDouble>&, DoubleDouble, DoubleDouble, int&);
template DoubleDouble march(const Difference<3, DoubleDouble>&, DoubleDouble, DoubleDouble, int&);
template DoubleDouble march(const Difference<4, DoubleDouble>&, DoubleDouble, DoubleDouble, int&);
template bool apartAlongAxis(const Difference<1>&);
template bool apartAlongAxis(const Difference<2>&);
template bool apartAlongAxis(const Difference<3>&);
template bool apartAlongAxis(const Difference<4>&);

}  // namespace plait
