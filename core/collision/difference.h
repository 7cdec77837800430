// Two moving simplices as one moving polygon: their Minkowski difference.
#pragma once

#include "bernstein.h"
#include "moving.h"

namespace plait {

// Every b - a of a point b of one simplex and a point a of the other: a point (k = 1), an edge (2),
// a triangle (3: point and triangle) or a parallelogram (4: edge and edge, which have no other
// difference). The simplices are as far apart as this is from the origin, so that one text serves
// every pair. In order round the polygon; side i goes from corner i to the next, and is subtracted
// on its own, since that of two distant corners would have lost digits.
template <int k, class T = double>
struct Difference {
    Moving<T> corner[k];
    Moving<T> side[k];  // of a point none, of an edge the first

    // The bound on distance: simplices closer than this touch.
    double thickness;
};

// Brought to a common scale by a power of two, so that nothing below overflows, and what underflows
// is below 2^-960 of the greatest coordinate or thickness. Throws std::invalid_argument for a
// coordinate that is not finite and a thickness that is not finite or below 0.
template <class T>
Difference<1, T> pointPoint(const MovingVertex& a, const MovingVertex& b, double thickness);
// Point p, edge a b.
template <class T>
Difference<2, T> pointEdge(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                           double thickness);
// Point p, triangle a b c.
template <class T>
Difference<3, T> pointTriangle(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                               const MovingVertex& c, double thickness);
// Edges a b and c d.
template <class T>
Difference<4, T> edgeEdge(const MovingVertex& a, const MovingVertex& b, const MovingVertex& c,
                          const MovingVertex& d, double thickness);

// A difference of two coordinates, each exact, over the step.
template <class T>
Course<1, T> course(const Moving<T>& m) {
    const auto line = [](const T& start, const T& end) {
        Bernstein<1, T> b{{start, end}, 0};
        b.error = roundoff<T> * b.size();
        return b;
    };
    return {line(m.start.x, m.end.x), line(m.start.y, m.end.y), line(m.start.z, m.end.z)};
}

}  // namespace plait
