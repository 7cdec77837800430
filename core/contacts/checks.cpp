#include "checks.h"

#include "../stencils.h"
#include "../world.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace plait {
namespace {

double thicknessOf(const World& world, Range vertices) {
    constexpr double thickest = 0.001, part = 1.0 / 8;  // m; of the mean edge
    const std::vector<int> edges = edgeStencils(world.complex, vertices);
    if (edges.empty()) return thickest;
    double sum = 0;
    for (std::size_t i = 0; i < edges.size(); i += 2)
        sum += length(world.rest[edges[i + 1]] - world.rest[edges[i]]);
    return std::min(thickest, part * sum / (static_cast<double>(edges.size()) / 2));
}

}  // namespace

Surface checked(World& world, Surface s, const std::string& set) {
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument(set + ": " + what);
    };
    if (s.vertices.first < 0 || s.vertices.last > world.complex.count(0) || s.vertices.size() < 1)
        refuse("a surface of vertices that are not there");
    if (!s.radii.empty() && std::ssize(s.radii) != s.vertices.size())
        refuse("one radius a vertex, or none");
    if (!s.thickness) s.thickness = thicknessOf(world, s.vertices);
    if (!isMeasure(*s.thickness) || !std::ranges::all_of(s.radii, isMeasure) ||
        !isMeasure(s.stickiness) || !isMeasure(s.selfWidth))
        refuse("thickness, radii, stickiness and width are at least 0");
    if (s.directors.size() != 0) {
        const bool one = s.directors.size() == s.vertices.size() - 1 && s.directors.first >= 0 &&
                         s.directors.last <= world.complex.count(0);
        if (!one || std::ssize(edgeStencils(world.complex, s.vertices)) != 2L * s.directors.size())
            refuse("a flat section is one open curve's, with a director an edge");
        if (!s.radii.empty() || !(*s.thickness > 0 && isMeasure(s.halfWidth - *s.thickness)) ||
            s.restitution != 0)
            refuse("a flat section is at least as wide as thick, above 0, and does not bounce");
    }
    for (const auto* flags : {&s.disableSelf, &s.disableExternal})
        if (!flags->empty() && (std::ssize(*flags) != s.vertices.size() ||
                                !std::ranges::all_of(*flags, [](int f) { return f <= 1; })))
            refuse("to disable by hand takes 0 or 1 a vertex, or nothing");
    if (!(s.pointMass > 0 && isMeasure(s.pointMass))) refuse("a point mass is above 0");
    if (!(s.restitution >= 0 && s.restitution <= 1)) refuse("restitution is from 0 to 1");
    world.warnOutside(set + ".staticFriction", s.staticFriction, 0, 1);
    world.warnOutside(set + ".dynamicFriction", s.dynamicFriction, 0, 1);
    return s;
}

std::vector<LesserSurfaces> lesserForms(const std::vector<Surface>& surfaces) {
    std::vector<LesserSurfaces> forms;
    // Offered where `change` says that it has changed one.
    const auto offer = [&](const std::string& without, bool (*change)(Surface&)) {
        LesserSurfaces form{without, surfaces};
        bool any = false;
        for (Surface& s : form.surfaces) any |= change(s);
        if (any) forms.push_back(std::move(form));
    };
    offer("edges with edges of its own",
          [](Surface& s) { return s.self == Self::full && (s.self = Self::vertexFace, true); });
    offer("contact with itself",
          [](Surface& s) { return s.self != Self::none && (s.self = Self::none, true); });
    offer("friction", [](Surface& s) {
        const bool rough = s.staticFriction != 0 || s.dynamicFriction != 0;
        s.staticFriction = s.dynamicFriction = 0;
        return rough;
    });
    offer("restitution", [](Surface& s) { return std::exchange(s.restitution, 0) != 0; });
    offer("stickiness", [](Surface& s) { return std::exchange(s.stickiness, 0) != 0; });
    return forms;
}

}  // namespace plait
