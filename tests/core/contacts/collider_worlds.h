// Colliders of all sorts, and what meets them.
#pragma once

#include "contact_worlds.h"
#include "tests/random.h"

#include <plait/contacts/solids/collider.h>

#include <string>

namespace plait::test {

constexpr double skin = 0.001;  // m, the thickness of what meets colliders

inline const std::vector<std::pair<std::string, Solid>> solids{
    {"sphere", Solid::sphere(0.3)},
    {"capsule", Solid::capsule(0.8, 0.1)},
    {"box", Solid::box(1, 0.02, 0.6)},
    {"rounded box", {.half = {0.2, 0.3, 0.1}, .radius = 0.05}}};

inline Vec<double> direction(Random& random) {
    for (;;) {
        const Vec<double> d = random.point(1);
        const double l = length(d);
        if (l < 1 && l > 0.01) return (1 / l) * d;
    }
}

inline Frame turnedAbout(const Vec<double>& axis, double angle, const Vec<double>& origin = {}) {
    const Placement still(Frame{}, "still");
    Frame frame = between(still, still, angle * axis, 1).frame();
    frame.origin = origin;
    return frame;
}

inline Surface rough(Range vertices, double friction, double restitution = 0) {
    Surface surface;
    surface.vertices = vertices;
    surface.thickness = skin;
    surface.staticFriction = surface.dynamicFriction = friction;
    surface.restitution = restitution;
    return surface;
}

inline Collider hard(const Solid& solid, double friction, double restitution = 0) {
    return {.solid = solid,
            .staticFriction = friction,
            .dynamicFriction = friction,
            .restitution = restitution};
}

}  // namespace plait::test
