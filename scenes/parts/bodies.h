// Matter of scenes in which things meet.
#pragma once

#include <plait/contacts/surface.h>
#include <plait/pieces/piece.h>

namespace plait {

// Adds a solid of this mass (kg), which is rigid from `holdPieces` on.
Piece addSolid(World& world, const Shape& shape, double mass);

// Keeps these vertices so far (m) above a floor of this height (m), without friction: adds the set
// `ground`.
void addGround(World& world, Range vertices, double height, double thickness, int order);

// Thickness in m; the same friction standing and sliding.
Surface roughSurface(Range vertices, double thickness, double friction);

}  // namespace plait
