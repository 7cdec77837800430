// Fabrics by what a laboratory measures of them: presets in units [UN6].
#pragma once

#include <plait/contacts/surface.h>

#include <span>
#include <string>

namespace plait {

// Typical of its kind; one roll differs from the next by half.
struct Fabric {
    std::string name;
    double density;           // kg/m^2
    double flexuralRigidity;  // N m
    double shearStiffness;    // N/m, of the weave on the bias
    double thickness;         // m
    double friction;          // standing and sliding, on itself

    // In m, the cube root of rigidity over weight (Peirce 1930, The handle of cloth as a measurable
    // quantity).
    double bendingLength() const;
    // As it meets others, at half its thickness from its middle.
    Surface surface(Range vertices) const;
};

// silk, cotton, burlap, leather: from limp to stiff.
std::span<const Fabric> fabrics();

// Throws std::invalid_argument for a name that is not there.
const Fabric& findFabric(const std::string& name);

}  // namespace plait
