// How rows become a set of a world, for kinds that are not the core's own: those are compiled once
// (constrain.cpp).
#pragma once

#include "../world.h"
#include "constraint_set.h"
#include "direct_set.h"

namespace plait {

// Stencils by the names that their vertices have in what has come apart; of those that lie across
// a cut `padding`, throughout. Empty: nothing has.
std::vector<int> renamed(const World& world, std::span<const int> ids, int arity, int padding);

template <class Kind>
void World::constrain(Rows<Kind> rows, SetOptions options) {
    if (options.direct && Kind::arity != 2)
        throw std::invalid_argument(options.name +
                                    ": a direct solve is for constraints of two vertices");
    const auto make =
        [set = std::make_shared<const Rows<Kind>>(std::move(rows)), options]<class Real>(
            const World& world, KernelChoice kernels) -> std::unique_ptr<Constraint<Real>> {
        checkRows(options.name, *set, world.start.size());
        if constexpr (!requires { Kind::contact; }) world.checkThere(options.name, set->ids);
        if constexpr (Kind::arity == 2)
            if (options.direct) {
                world.checkWhole(options.name, set->ids);
                return std::make_unique<DirectSet<Kind, Real>>(set, world.pinned);
            }
        const int padding = static_cast<int>(world.start.size());
        return std::make_unique<ConstraintSet<Kind, Real>>(
            set, padding, kernels, renamed(world, set->ids, Kind::arity, padding));
    };
    constrain(recipeOf<Constraint>(make), std::move(options), requires { Kind::contact; });
}

extern template void World::constrain(Rows<Stretch>, SetOptions);
extern template void World::constrain(Rows<Angle>, SetOptions);
extern template void World::constrain(Rows<Shear>, SetOptions);
extern template void World::constrain(Rows<Bend>, SetOptions);
extern template void World::constrain(Rows<Attach>, SetOptions);
extern template void World::constrain(Rows<Tether>, SetOptions);
extern template void World::constrain(Rows<PlaneContact>, SetOptions);
extern template void World::constrain(Rows<SphereContact>, SetOptions);
extern template void World::constrain(Rows<CapsuleContact>, SetOptions);

}  // namespace plait
