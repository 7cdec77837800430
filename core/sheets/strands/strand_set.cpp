#include "strand_set.h"

namespace plait {

void strand(World& world, const Rows<Stretch>& set, SetOptions options, bool geometricStiffness) {
    strand(world, set, {}, std::move(options), geometricStiffness);
}

void strand(World& world, const Rows<Stretch>& set, std::vector<Strand> strands, SetOptions options,
            bool geometricStiffness) {
    const auto make =
        [shared = std::make_shared<const Rows<Stretch>>(set), strings = std::move(strands),
         geometricStiffness, name = options.name]<class Real>(
            const World& w, KernelChoice kernels) -> std::unique_ptr<Constraint<Real>> {
        checkRows(name, *shared, w.start.size());
        w.checkWhole(name, shared->ids);
        const int padding = static_cast<int>(w.start.size());
        return std::make_unique<StrandSet<Real>>(
            shared, strings.empty() ? strandsOf(shared->ids, w.rest) : strings, padding, kernels,
            geometricStiffness);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
