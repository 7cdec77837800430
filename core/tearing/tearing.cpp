#include "tearing.h"

#include "tear.h"

#include <cmath>
#include <stdexcept>

namespace plait {

void holdTearing(World& world, Membrane membrane, Tearing tearing, SetOptions options) {
    const auto refuse = [&](bool bad, const char* what) {
        if (bad) throw std::invalid_argument(tearing.name + ": " + what);
    };
    refuse(!(tearing.strength > 0), "strength must be above 0");
    refuse(!(tearing.toughness >= 0) || !std::isfinite(tearing.toughness),
           "toughness must be finite and not negative");
    refuse(!(tearing.branching >= 2), "branching must be 2 or more");
    refuse(!(tearing.scatter >= 0 && tearing.scatter < 1), "scatter must be in [0, 1)");
    Tearable tearable{tearing.cloth, {}};
    for (const Range& spare : world.spare)
        if (spare.last == tearing.cloth.last)
            tearable = {{tearing.cloth.first, spare.first}, spare};
    refuse(tearable.spare.size() == 0, "the cloth has no spare vertices");
    for (const Membrane::Rubber& rubber : membrane.rubber)
        for (const int v : rubber.triangles)
            refuse(v < tearable.matter.first || v >= tearable.matter.last,
                   "a triangle is not of the cloth");
    world.tearable.push_back(tearable);
    membrane.toughness = tearing.toughness;
    membrane.toughnessMap = tearing.map;
    world.act<Tear>(TornMembrane{membrane.rubber, std::move(tearing)});
    holdMembrane(world, std::move(membrane), std::move(options));
}

}  // namespace plait
