// Sets of every kind in constraints/kinds.h, so that no other file compiles them again.
#include "constrain.h"

#include <algorithm>

namespace plait {

std::vector<int> renamed(const World& world, std::span<const int> ids, int arity, int padding) {
    if (!world.torn) return {};
    std::vector<int> names(ids.begin(), ids.end());
    const auto size = static_cast<std::size_t>(arity);
    for (std::size_t i = 0; i < names.size(); i += size) {
        const auto stencil = std::span(names).subspan(i, size);
        if (!world.torn->rename(stencil)) std::ranges::fill(stencil, padding);
    }
    return names;
}

template void World::constrain(Rows<Stretch>, SetOptions);
template void World::constrain(Rows<Angle>, SetOptions);
template void World::constrain(Rows<Shear>, SetOptions);
template void World::constrain(Rows<Bend>, SetOptions);
template void World::constrain(Rows<Attach>, SetOptions);
template void World::constrain(Rows<Tether>, SetOptions);
template void World::constrain(Rows<PlaneContact>, SetOptions);
template void World::constrain(Rows<SphereContact>, SetOptions);
template void World::constrain(Rows<CapsuleContact>, SetOptions);

}  // namespace plait
