// What a scene of glass has around it.
#pragma once

#include "../metric.h"

#include <plait/complex/shapes.h>
#include <plait/pieces/piece.h>
#include <plait/world.h>

#include <string>
#include <vector>

namespace plait {

constexpr double glassDensity = 2500;  // kg/m^3

// A piece that stays where it is. Returns its place among the pieces.
int addPinned(World& world, const Shape& shape);
// A piece of glass, likewise.
int addShard(World& world, const Shape& shape, const Vec<double>& velocity = {});

// All pieces meet, but for what is welded. `friction`: by piece; those beyond have the last.
void meetAll(World& world, double thickness, const std::vector<double>& friction);

// The shards' lowest corner over the floor, mm.
Metric lowestOf(const World& world, const std::vector<int>& shards);

}  // namespace plait
