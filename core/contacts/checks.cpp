#include "checks.h"

#include "../world.h"

#include <algorithm>
#include <stdexcept>

namespace plait {

void checkSurface(World& world, const Surface& s, const std::string& set) {
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument(set + ": " + what);
    };
    if (s.vertices.first < 0 || s.vertices.last > world.complex.count(0) || s.vertices.size() < 1)
        refuse("a surface of vertices that are not there");
    if (!s.radii.empty() && std::ssize(s.radii) != s.vertices.size())
        refuse("one radius a vertex, or none");
    if (!isMeasure(s.thickness) || !std::ranges::all_of(s.radii, isMeasure) ||
        !isMeasure(s.stickiness) || !isMeasure(s.selfWidth))
        refuse("thickness, radii, stickiness and width are at least 0");
    for (const auto* flags : {&s.disableSelf, &s.disableExternal})
        if (!flags->empty() && (std::ssize(*flags) != s.vertices.size() ||
                                !std::ranges::all_of(*flags, [](int f) { return f <= 1; })))
            refuse("to disable by hand takes 0 or 1 a vertex, or nothing");
    if (!(s.pointMass > 0 && isMeasure(s.pointMass))) refuse("a point mass is above 0");
    if (!(s.restitution >= 0 && s.restitution <= 1)) refuse("restitution is from 0 to 1");
    world.warnOutside(set + ".staticFriction", s.staticFriction, 0, 1);
    world.warnOutside(set + ".dynamicFriction", s.dynamicFriction, 0, 1);
}

}  // namespace plait
