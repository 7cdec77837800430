#include "../../world.h"
#include "../checks.h"
#include "contact_set.h"

#include <algorithm>
#include <stdexcept>

namespace plait {

void meet(World& world, std::vector<Surface> surfaces, const ContactOptions& options) {
    if (!isMeasure(options.recovery) || !isMeasure(options.margin) ||
        !isMeasure(options.layerShock - 1) || !isMeasure(options.bounceThreshold) ||
        !isMeasure(options.displacementLimit))
        throw std::invalid_argument(options.name +
                                    ": recovery, margin, threshold and limit are at least 0, the "
                                    "shock of layers at least 1");
    for (Surface& s : surfaces) s = checked(world, s, options.name);
    const auto make = [surfaces, options]<class Real>(const World& made, KernelChoice) {
        return std::make_unique<ContactSet<Real>>(made, surfaces, options);
    };
    world.constrain(
        recipeOf<Constraint>(make),
        {.name = options.name, .order = options.order, .importance = options.importance}, true);
}

}  // namespace plait
