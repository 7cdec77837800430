// When two moving simplices first touch: never missed, never too late.
//
// Every vertex moves from start to end along a straight line while t goes from 0 to 1. A query
// returns a time in [0, 1] that is not after the first at which the simplices are no more than the
// thickness apart (or share a point, thin), nothing if they never are. Never a miss, never late,
// for any finite input: parallel, coplanar, resting, without length, of 1e-300 or 1e300. It may
// answer where they pass at some 1e-14 of their motion, or somewhat wider where they slide side by
// side within rounding; and too early by as little. Time and memory are bounded. Under
// FlushDenormals a coordinate below 2.3e-308 is 0. std::invalid_argument where a number is not
// finite or the thickness below 0.
//
// In the steps of S 7, each made safe: boxes; the roots of a polynomial, isolated with rounding
// counted in (roots.h); and whether the simplices overlap then (separation.h).
#pragma once

#include "moving.h"

#include <optional>

namespace plait {

using Impact = std::optional<double>;

// Thin, in one dimension, x: the sign of the distance, t = V0 / (V0 - V1) (S 7).
Impact thinPointPoint(const MovingVertex& a, const MovingVertex& b);

// Thin, in two dimensions, x and y: point p and edge a b; a quadratic (S 7, figure 17).
Impact thinPointEdge(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b);

// Thin, in three dimensions: a cubic (S 7, figure 18).
Impact thinPointTriangle(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                         const MovingVertex& c);
Impact thinEdgeEdge(const MovingVertex& a, const MovingVertex& b, const MovingVertex& c,
                    const MovingVertex& d);

// Thick, in three dimensions: the thickness is the sum of those of both (m); degrees 2, 4, 6 and 6
// (S 7, figure 19). With a thickness of 0 the last two are the thin ones.
Impact thickPointPoint(const MovingVertex& a, const MovingVertex& b, double thickness);
Impact thickPointEdge(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                      double thickness);
Impact thickPointTriangle(const MovingVertex& p, const MovingVertex& a, const MovingVertex& b,
                          const MovingVertex& c, double thickness);
Impact thickEdgeEdge(const MovingVertex& a, const MovingVertex& b, const MovingVertex& c,
                     const MovingVertex& d, double thickness);

}  // namespace plait
