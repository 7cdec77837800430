#include "mend_set.h"

namespace plait {

void mend(World& world, const Rows<Stretch>& set, SetOptions options, const Mending& mending) {
    const auto make = [shared = std::make_shared<const Rows<Stretch>>(set), mending,
                       name = options.name]<class Real>(
                          const World& w,
                          KernelChoice kernels) -> std::unique_ptr<Constraint<Real>> {
        checkRows(name, *shared, w.start.size());
        const int padding = static_cast<int>(w.start.size());
        return std::make_unique<MendSet<Real>>(*shared, padding, kernels, mending);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
