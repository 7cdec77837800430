#include "fabrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

// Bending lengths of 14, 20, 40 and 50 mm: habotai, shirting, hessian of 340 g, hide of 1 mm.
const std::array<Fabric, 4> kinds{{{"silk", 0.055, 1.5e-6, 15, 0.15e-3, 0.25},
                                   {"cotton", 0.12, 9.4e-6, 40, 0.25e-3, 0.5},
                                   {"burlap", 0.34, 2.1e-4, 60, 0.9e-3, 0.6},
                                   {"leather", 0.7, 8.6e-4, 3800, 1e-3, 0.6}}};

}  // namespace

double Fabric::bendingLength() const { return std::cbrt(flexuralRigidity / (9.81 * density)); }

Surface Fabric::surface(Range vertices) const {
    return {.vertices = vertices,
            .thickness = thickness / 2,
            .staticFriction = friction,
            .dynamicFriction = friction};
}

std::span<const Fabric> fabrics() { return kinds; }

const Fabric& findFabric(const std::string& name) {
    const auto* const found =
        std::find_if(kinds.begin(), kinds.end(), [&](const Fabric& f) { return f.name == name; });
    if (found == kinds.end()) throw std::invalid_argument("no fabric is named " + name);
    return *found;
}

}  // namespace plait
