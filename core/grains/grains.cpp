#include "grains.h"

#include "grain_set.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {

void pushGrains(World& world, const Grains& grains, SetOptions options) {
    const auto refuse = [&](bool bad, const char* what) {
        if (bad) throw std::invalid_argument(options.name + ": " + what);
    };
    const Range range = grains.vertices;
    const auto n = static_cast<std::size_t>(std::max(range.size(), 0));
    refuse(!(0 <= range.first && range.first < range.last &&
             range.last <= static_cast<int>(world.start.size())),
           "its grains are not in the world");
    refuse(!grains.radii.empty() && grains.radii.size() != n, "there must be one radius a grain");
    refuse(!grains.pieces.empty() && grains.pieces.size() != n, "there must be one piece a grain");
    const auto isLength = [](double r) { return r > 0 && std::isfinite(r); };
    refuse(grains.radii.empty() ? !isLength(grains.radius)
                                : !std::ranges::all_of(grains.radii, isLength),
           "a radius must be above 0");
    for (const double number :
         {grains.staticFriction, grains.dynamicFriction, grains.weight, grains.repulsion,
          grains.attraction, grains.cling, grains.slop, grains.recovery, grains.shock})
        refuse(!(number >= 0) || !std::isfinite(number), "no number may be below 0");
    refuse(!(grains.searchScale >= 1) || !std::isfinite(grains.searchScale),
           "it must look as far as grains reach");
    refuse(grains.mostNeighbours < 0, "there are no fewer neighbours than none");
    refuse(std::fabs(length(grains.up) - 1) > 1e-6, "up must be of unit length");
    const auto make = [grains]<class Real>(const World& made,
                                           KernelChoice) -> std::unique_ptr<Constraint<Real>> {
        return std::make_unique<GrainSet<Real>>(made, grains);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
