// The polynomials whose roots are the times at which simplices can touch (S 7, figure 19).
#pragma once

#include "difference.h"

namespace plait {

// Thin, in one, two and three dimensions: signed distance, twice the signed area and six times the
// signed volume, where v goes from one simplex to the other and e, f along their sides (lengths,
// areas and volumes in the scale of `difference`).
template <class T>
Bernstein<1, T> distancePolynomial(const Moving<T>& v) {
    return course(v).x;
}

template <class T>
Bernstein<2, T> areaPolynomial(const Moving<T>& v, const Moving<T>& e) {
    const Course<1, T> p = course(v), q = course(e);
    return p.x * q.y - p.y * q.x;
}

template <class T>
Bernstein<3, T> volumePolynomial(const Moving<T>& v, const Moving<T>& e, const Moving<T>& f) {
    return dot(course(v), cross(course(e), course(f)));
}

// Thick: |v|² - h²; |v x e|² - h² |e|²; (v . (e x f))² - h² |e x f|². 0 where the point v, the line
// through it along e, or the plane through it along e and f is h from the origin.
inline Bernstein<2> pointPolynomial(const MovingVertex& v, double h) {
    const Course<1, double> p = course(v);
    Bernstein<2> square = dot(p, p);
    const double a = h * h;
    for (double& c : square.c) c -= a;
    square.error += roundoff<double> * (a + square.size());
    return square;
}

inline Bernstein<4> linePolynomial(const MovingVertex& v, const MovingVertex& e, double h) {
    const Course<1, double> q = course(e);
    const Course<2, double> moment = cross(course(v), q);
    const Bernstein<2> square = h * (h * dot(q, q));
    // The same polynomial with a degree of 4.
    constexpr Bernstein<2> one{{1, 1, 1}, 0};
    return dot(moment, moment) - square * one;
}

inline Bernstein<6> planePolynomial(const MovingVertex& v, const MovingVertex& e,
                                    const MovingVertex& f, double h) {
    const Course<2, double> normal = cross(course(e), course(f));
    const Bernstein<3> volume = dot(course(v), normal);
    const Bernstein<4> square = h * (h * dot(normal, normal));
    constexpr Bernstein<2> one{{1, 1, 1}, 0};
    return volume * volume - square * one;
}

}  // namespace plait
