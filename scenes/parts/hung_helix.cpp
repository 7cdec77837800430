#include "hung_helix.h"

#include <plait/numbers/elementary.h>

namespace plait {

// Balance of twist and bending in a cross-section, by Newton's method.
Helix hungBy(const Helix& rest, const CoilStiffness& wire, double force, Helix at) {
    const double level = rest.pitch, r0 = rest.radius;
    const double bending = wire.bending, twisting = wire.twisting;
    for (int round = 0; round < 20; ++round) {
        const double s = sine(at.pitch), c = cosine(at.pitch), r = at.radius;
        const double twist =
            twisting * (s * c / r - sine(level) * cosine(level) / r0) - force * r * c;
        const double bend =
            bending * (c * c / r - cosine(level) * cosine(level) / r0) + force * r * s;
        const double a = twisting * (c * c - s * s) / r + force * r * s,
                     b = -twisting * s * c / (r * r) - force * c,
                     d = -2 * bending * s * c / r + force * r * c,
                     e = -bending * c * c / (r * r) + force * s;
        at.pitch -= (twist * e - b * bend) / (a * e - b * d);
        at.radius -= (a * bend - d * twist) / (a * e - b * d);
    }
    return at;
}

double sagOf(const Helix& rest, const CoilStiffness& wire, double length, double weight) {
    constexpr int parts = 400;
    const double l = length / parts;
    Helix at = rest;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        at = hungBy(rest, wire, (i + 0.5) * l * weight, at);
        sum += l * (sine(at.pitch) - sine(rest.pitch));
    }
    return sum;
}

}  // namespace plait
