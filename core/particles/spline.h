// The cubic spline (Monaghan, Lattanzio, A refined particle method for astrophysical problems,
// 1985), with which particles see each other, and the part of it that walls take.
//
// A liquid of constraints needs a kernel that pushes what is near. (1 - q^2)^3, half as dear for
// want of a square root, does not: pairs of particles close up and a column sinks by 13 % while its
// own sum says that nothing is wrong.
#pragma once

#include "../numbers/math.h"

namespace plait {

// q: distance over the kernel's radius, at least 0. 1 in the middle, 0 from q = 1 on; its integral
// is pi / 8 radius^3.
struct CubicSpline {
    static double value(double q) {
        const double t = q < 1 ? 1 - q : 0, u = q < 0.5 ? 0.5 - q : 0;
        return 2 * t * t * t - 8 * u * u * u;
    }
    static double slope(double q) {  // d value / dq
        const double t = q < 1 ? 1 - q : 0, u = q < 0.5 ? 0.5 - q : 0;
        return 24 * u * u - 6 * t * t;
    }

    // The part of its integral over a cone that lies beyond q of its tip.
    static double beyondInCone(double q) {
        const double t = q < 1 ? 1 - q : 0, u = q < 0.5 ? 0.5 - q : 0;
        const double t4 = t * t * t * t, u4 = u * u * u * u;
        return 32 *
               (2 * t4 * (0.25 - 0.4 * t + t * t / 6) - 8 * u4 * (0.0625 - 0.2 * u + u * u / 6));
    }

    // The part of its integral that lies beyond a plane, s radii away; below 0 behind it.
    static double beyond(double s) {
        if (s < 0) return 1 - beyond(-s);
        const double t = s < 1 ? 1 - s : 0, u = s < 0.5 ? 0.5 - s : 0;
        const double t5 = t * t * t * t * t, u5 = u * u * u * u * u;
        return 16 * (t5 / 10 - t5 * t / 15 - u5 / 5 + 4 * u5 * u / 15);
    }
    static double beyondSlope(double s) {  // d beyond / ds
        const double q = s < 0 ? -s : s;
        const double t = q < 1 ? 1 - q : 0, u = q < 0.5 ? 0.5 - q : 0;
        const double t4 = t * t * t * t, u4 = u * u * u * u;
        return -16 * (t4 / 2 - 2 * t4 * t / 5 - u4 + 8 * u4 * u / 5);
    }
};

}  // namespace plait
