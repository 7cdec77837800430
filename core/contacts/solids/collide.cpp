#include "../../numbers/finite.h"
#include "../../world.h"
#include "../checks.h"
#include "collider_set.h"

#include <stdexcept>

namespace plait {
namespace {

void check(World& world, const Collider& c, const std::string& set) {
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument(set + ": " + what);
    };
    const Solid& s = c.solid;
    if (!isMeasure(s.half.x) || !isMeasure(s.half.y) || !isMeasure(s.half.z) ||
        !isMeasure(s.radius))
        refuse("lengths of a collider are at least 0");
    if (!isMeasure(c.stickiness)) refuse("stickiness is at least 0");
    if (!(c.restitution >= 0 && c.restitution <= 1)) refuse("restitution is from 0 to 1");
    world.warnOutside(set + ".staticFriction", c.staticFriction, 0, 1);
    world.warnOutside(set + ".dynamicFriction", c.dynamicFriction, 0, 1);
}

}  // namespace

void collide(World& world, const std::vector<Collider>& colliders, std::vector<Surface> surfaces,
             const ColliderOptions& options) {
    if (!isMeasure(options.recovery) || !isMeasure(options.bounceThreshold))
        throw std::invalid_argument(options.name + ": recovery and threshold are at least 0");
    std::vector<Range> taken;
    for (Surface& s : surfaces) {
        s = checked(world, s, options.name);
        for (const Range& r : taken)
            if (s.vertices.first < r.last && r.first < s.vertices.last)
                throw std::invalid_argument(options.name + ": a vertex of two surfaces");
        taken.push_back(s.vertices);
    }
    for (const Collider& c : colliders) {
        check(world, c, options.name);
        Placement(c.motion ? c.motion(0) : c.frame, options.name);
    }
    const auto recipeFor = [&](const std::vector<Collider>& solids,
                               const std::vector<Surface>& terms) {
        return recipeOf<Constraint>(
            [solids, terms, options]<class Real>(const World& made, KernelChoice) {
                return std::make_unique<ColliderSet<Real>>(made, solids, terms, options);
            });
    };
    Recipe<Constraint> recipe = recipeFor(colliders, surfaces);
    std::vector<Collider> smooth = colliders, dull = colliders;
    for (Collider& c : smooth) c.staticFriction = c.dynamicFriction = 0;
    for (Collider& c : dull) c.restitution = 0;
    for (const LesserSurfaces& form : lesserForms(surfaces)) {
        if (form.without == "friction")
            recipe.offer("without " + form.without, recipeFor(smooth, form.surfaces));
        if (form.without == "restitution")
            recipe.offer("without " + form.without, recipeFor(dull, form.surfaces));
    }
    world.constrain(
        std::move(recipe),
        {.name = options.name, .order = options.order, .importance = options.importance}, true);
}

}  // namespace plait
