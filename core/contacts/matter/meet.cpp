#include "../../world.h"
#include "../checks.h"
#include "contact_set.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

Recipe<Constraint> recipeFor(const std::vector<Surface>& surfaces, const ContactOptions& options) {
    return recipeOf<Constraint>([=]<class Real>(const World& made, KernelChoice) {
        return std::make_unique<ContactSet<Real>>(made, surfaces, options);
    });
}

}  // namespace

void meet(World& world, std::vector<Surface> surfaces, const ContactOptions& options) {
    if (!isMeasure(options.recovery) || !isMeasure(options.margin) ||
        !isMeasure(options.layerShock - 1) || !isMeasure(options.bounceThreshold) ||
        !isMeasure(options.displacementLimit) || !isMeasure(options.selfFriction) ||
        !isMeasure(options.otherFriction))
        throw std::invalid_argument(options.name +
                                    ": recovery, margin, threshold, limit and factors of "
                                    "friction are at least 0, the "
                                    "shock of layers at least 1");
    for (Surface& s : surfaces) {
        s = checked(world, s, options.name);
        for (const int other : s.ignores)
            if (other < 0 || other >= std::ssize(surfaces))
                throw std::invalid_argument(options.name + ": there is no surface " +
                                            std::to_string(other) + " to ignore");
    }
    Recipe<Constraint> recipe = recipeFor(surfaces, options);
    for (const LesserSurfaces& form : lesserForms(surfaces))
        recipe.offer("without " + form.without, recipeFor(form.surfaces, options));
    if (options.detection == Detection::path) {
        ContactOptions atEnds = options;
        atEnds.detection = Detection::end;
        recipe.offer("without the way there", recipeFor(surfaces, atEnds));
    }
    world.constrain(
        std::move(recipe),
        {.name = options.name, .order = options.order, .importance = options.importance}, true);
}

}  // namespace plait
