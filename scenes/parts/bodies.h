// Matter of scenes in which things meet.
#pragma once

#include <plait/contacts/surface.h>
#include <plait/world.h>

#include <span>
#include <vector>

namespace plait {

// Adds a closed shell of this mass (kg), spread evenly on its surface. It keeps no shape until
// `keepShapes`.
Range addBody(World& world, const Shape& shape, double mass);

// Links every vertex of each of these bodies with every other, so that a sweep or two suffices: as
// many links as half the square of its vertices.
void keepShapes(World& world, std::span<const Range> bodies, SetOptions options);

// Keeps these vertices so far (m) above a floor of this height (m), without friction: adds the set
// `ground`.
void addGround(World& world, Range vertices, double height, double thickness, int order);

// Thickness in m; the same friction standing and sliding.
Surface roughSurface(Range vertices, double thickness, double friction);

}  // namespace plait
