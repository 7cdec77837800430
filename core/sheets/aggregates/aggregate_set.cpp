#include "aggregate_set.h"

namespace plait {

void aggregate(World& world, const Rows<Stretch>& set, SetOptions options, int fewest) {
    const auto make = [shared = std::make_shared<const Rows<Stretch>>(set), fewest,
                       name = options.name]<class Real>(
                          const World& w,
                          KernelChoice kernels) -> std::unique_ptr<Constraint<Real>> {
        checkRows(name, *shared, w.start.size());
        return std::make_unique<AggregateSet<Real>>(
            aggregate(w.effectiveMass(), w.rest, linksOf(*shared), fewest), kernels);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

void aggregate(World& world, std::vector<AggregateLevel> levels, SetOptions options) {
    const auto make = [ready = std::move(levels)]<class Real>(
                          const World&, KernelChoice kernels) -> std::unique_ptr<Constraint<Real>> {
        return std::make_unique<AggregateSet<Real>>(ready, kernels);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
