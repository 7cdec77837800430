#include "membrane.h"

#include "membrane_set.h"

#include <stdexcept>

namespace plait {

void holdMembrane(World& world, const Membrane& membrane, SetOptions options) {
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument(options.name + ": " + what);
    };
    checkRows(options.name, membrane.springs, world.start.size());
    for (const auto& row : membrane.springs.rows)
        if (!(row.compliance > 0 && row.compression > 0)) refuse("a spring has no compliance");
    for (const Membrane::Rubber& rubber : membrane.rubber) {
        const std::size_t n = rubber.triangles.size() / 3;
        checkStencils(options.name, rubber.triangles, 3, n, {}, world.start.size());
        checkNumbers(options.name, rubber.thickness);
        if (rubber.thickness.size() != 1 && rubber.thickness.size() != n)
            refuse("rubber has one thickness for all triangles, or one for each");
    }
    for (const Membrane::Filling& filling : membrane.gases) {
        if (!(volume(filling.enclosure, world.start) > 0))
            refuse("what a gas is in has no volume, or is inside out");
    }
    const auto make = [membrane]<class Real>(const World& w,
                                             KernelChoice) -> std::unique_ptr<Constraint<Real>> {
        return std::make_unique<MembraneSet<Real>>(w, membrane);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
