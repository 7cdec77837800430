// What contacts of either sort refuse.
#pragma once

#include "surface.h"

#include <cmath>
#include <cstddef>

namespace plait {

inline bool isMeasure(double a) { return a >= 0 && std::isfinite(a); }

// The surface, its thickness given. Throws std::invalid_argument, naming the set and the value, for
// one out of range; friction out of range is warned of.
Surface checked(World& world, Surface surface, const std::string& set);

// The same surfaces with something left out: what recipes of contacts offer as their lesser forms.
struct LesserSurfaces {
    std::string without;
    std::vector<Surface> surfaces;
};
std::vector<LesserSurfaces> lesserForms(const std::vector<Surface>& surfaces);

// Of a vertex of a checked surface, m.
inline double thicknessAt(const Surface& surface, int vertex) {
    return surface.radii.empty()
               ? surface.thickness.value_or(0)
               : surface.radii[static_cast<std::size_t>(vertex - surface.vertices.first)];
}

}  // namespace plait
