#include "query.h"

#include "polynomials.h"
#include "roots.h"
#include "separation.h"

#include <algorithm>

namespace plait {
namespace {

// How many directions a query tries: each takes some 50 ns, and 1 us in twice the digits.
constexpr int fewDirections = 48, directions = 2000, fineDirections = 200;

// Times at which something can begin.
template <class T>
class Times {
public:
    template <int n>
    void add(const Bernstein<n, T>& p) {
        for (const Bracket<T>& b : isolateRoots(p)) item_[count_++] = b;
    }
    void add(const T& time) { item_[count_++] = {time, time, false}; }

    // The first time from `from` on in any of the brackets from which the simplices cannot be shown
    // to be apart.
    template <int k>
    std::optional<T> first(const Difference<k, T>& d, T from, int budget) {
        std::sort(item_, item_ + count_,
                  [](const Bracket<T>& a, const Bracket<T>& b) { return a.low < b.low; });
        for (int i = 0; i < count_; ++i) {
            if (item_[i].high < from) continue;
            const T t = march(d, std::max(item_[i].low, from), item_[i].high, budget);
            if (t != beyond) {
                crossing = item_[i].simple;
                return t;
            }
            from = item_[i].high;
        }
        return {};
    }

    // Whether the polynomial changes its sign at the time found, once.
    bool crossing = false;

private:
    // A face, four sides, four corners and a time.
    Bracket<T> item_[9 * Brackets<T>::capacity + 1];
    int count_ = 0;
};

// When a thick polygon first comes near: its distance is then that of the point, line or plane of
// one of its corners, its sides or itself, so at least one of the polynomials is 0.
template <int k>
Impact thick(const Difference<k>& d) {
    if (apartAlongAxis(d)) return {};
    // Few directions decide most; the rest turn while they are near.
    int few = fewDirections;
    const double reached = march(d, 0.0, 1.0, few);
    if (reached == beyond) return {};
    if (few >= 0) return reached;

    Times<double> times;
    times.add(reached);
    for (const MovingVertex& corner : d.corner) times.add(pointPolynomial(corner, d.thickness));
    const int sides = k > 2 ? k : k - 1;
    for (int i = 0; i < sides; ++i) times.add(linePolynomial(d.corner[i], d.side[i], d.thickness));
    if constexpr (k > 2) times.add(planePolynomial(d.corner[0], d.side[0], d.side[1], d.thickness));
    return times.first(d, reached, directions);
}

// The area of an edge and a point, the volume of the others: 0 whenever they touch.
template <class T>
auto thinPolynomial(const Difference<2, T>& d) {
    return areaPolynomial(d.corner[0], d.side[0]);
}
template <int k, class T>
auto thinPolynomial(const Difference<k, T>& d) {
    return volumePolynomial(d.corner[0], d.side[0], d.side[1]);
}

// True if the origin faces the polygon well inside.
template <int k>
bool faces(const Difference<k>& d, double t) {
    const Vec<double> e = at(d.side[0], t), f = at(d.side[1], t), n = cross(e, f);
    const double square = dot(n, n);
    bool inside = square > 0x1p-40 * dot(e, e) * dot(f, f);
    for (int i = 0; i < k; ++i) {
        const Vec<double> moment = cross(at(d.corner[i], t), at(d.side[i], t));
        inside = inside && dot(n, moment) > 0x1p-20 * square;
    }
    return inside;
}

// Where double cannot tell whether they touch, twice the digits usually can. `fine` makes the
// difference again in those.
template <int k, class Fine>
Impact thin(const Difference<k>& d, const Fine& fine) {
    if (apartAlongAxis(d)) return {};
    Times<double> times;
    times.add(thinPolynomial(d));
    const Impact coarse = times.first(d, 0, directions);
    if (!coarse) return {};
    if constexpr (k > 2) {
        if (times.crossing && faces(d, *coarse)) return coarse;
    }

    const auto twice = fine();
    Times<DoubleDouble> fineTimes;
    fineTimes.add(thinPolynomial(twice));
    const auto t = fineTimes.first(twice, *coarse, fineDirections);
    if (!t) return {};
    return t->low < 0 ? t->high * (1 - roundoff<double>) : t->high;
}

MovingVertex plane(const MovingVertex& m) {
    return {{m.start.x, m.start.y, 0}, {m.end.x, m.end.y, 0}};
}
MovingVertex line(const MovingVertex& m) { return {{m.start.x, 0, 0}, {m.end.x, 0, 0}}; }

}  // namespace

Impact thinPointPoint(const MovingVertex& a, const MovingVertex& b) {
    const Difference<1> d = pointPoint<double>(line(a), line(b), 0);
    const double start = d.corner[0].start.x, end = d.corner[0].end.x;
    const auto side = [](double from, double to) { return (to > from) - (to < from); };
    if (side(a.start.x, b.start.x) * side(a.end.x, b.end.x) > 0) return {};
    if (start == 0) return 0;
    return std::max(0.0, start / (start - end) * (1 - 4 * roundoff<double>)-detail::tiny);
}

Impact thinPointEdge(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b) {
    const auto make = [&]<class T>(T) { return pointEdge<T>(plane(p), plane(a), plane(b), 0); };
    return thin(make(0.0), [&] { return make(DoubleDouble(0)); });
}

Impact thinPointTriangle(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                         const MovingVertex& c) {
    return thin(pointTriangle<double>(p, a, b, c, 0),
                [&] { return pointTriangle<DoubleDouble>(p, a, b, c, 0); });
}

Impact thinEdgeEdge(const MovingVertex& a, const MovingVertex& b, const MovingVertex& c,
                    const MovingVertex& d) {
    return thin(edgeEdge<double>(a, b, c, d, 0),
                [&] { return edgeEdge<DoubleDouble>(a, b, c, d, 0); });
}

Impact thickPointPoint(const MovingVertex& a, const MovingVertex& b, double thickness) {
    return thick(pointPoint<double>(a, b, thickness));
}

Impact thickPointEdge(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                      double thickness) {
    return thick(pointEdge<double>(p, a, b, thickness));
}

Impact thickPointTriangle(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                          const MovingVertex& c, double thickness) {
    if (thickness == 0) return thinPointTriangle(p, a, b, c);
    return thick(pointTriangle<double>(p, a, b, c, thickness));
}

Impact thickEdgeEdge(const MovingVertex& a, const MovingVertex& b, const MovingVertex& c,
                     const MovingVertex& d, double thickness) {
    if (thickness == 0) return thinEdgeEdge(a, b, c, d);
    return thick(edgeEdge<double>(a, b, c, d, thickness));
}

}  // namespace plait
