#include "grip.h"

#include "grip_set.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace plait {

void addGrip(World& world, const Grip& grip, SetOptions options) {
    const auto refuse = [&](const std::string& why) {
        throw std::invalid_argument(options.name + ": " + why);
    };
    if (!grip.hand) refuse("there is no hand");
    if (!(grip.from <= grip.to)) refuse("it must take hold before it lets go");
    std::vector<int> sorted = grip.vertices;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end()) refuse("a vertex is named twice");
    if (!sorted.empty() && (sorted.front() < 0 || sorted.back() >= std::ssize(world.start)))
        refuse("a vertex is not there");
    const auto make = [grip]<class Real>(const World&, KernelChoice) {
        return std::make_unique<GripSet<Real>>(grip);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
