// A liquid: particles that keep their volume. C_i = sum_j W_ij / rest + walls - 1 <= 0 for each, at
// position level, all at once (PBF: Macklin, Müller, Position based fluids, 2013; nearest kin:
// Bodin, Lacoursière, Servin, Constraint fluids, 2012).
//
// Multipliers begin at 0 and a substep takes one evaluation: in effect weakly compressible SPH,
// with a speed of sound of about sqrt(2 relaxation) spacing / h. How far it gives way under its own
// weight is known beforehand: restCompression.
#pragma once

#include "../contacts/solids/collider.h"
#include "../contacts/surface.h"
#include "../world.h"
#include "walls.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plait {

struct Liquid {
    // Vertices. Those of another mass are another phase, that fills as much space: a lighter one is
    // compressed by the ratio of masses times the rule (restCompression).
    Range particles{};
    double spacing = 0;  // m; a particle stands for a cube of this side
    // What the liquid does not see through; that it collides with them as well is for the world to
    // say, collide(world, walls, {surfaceOf(liquid)}, ...). Solids no thinner than two spacings:
    // through a thinner one either side would press on the other.
    std::vector<Collider> walls = {};
    Shades shades = {};  // of turned walls: shadesOf(), or worked out each time they are needed
    // Part of a correction that is applied. At 0.5 a liquid at rest rings for ever, the limit of
    // explicit stability; below 0.35 that dies out.
    double relaxation = 0.25;
};

// Throws std::invalid_argument, naming `who`, for particles that are not in the world, a spacing
// that is not positive, a relaxation that is not above 0 and below 1, and walls that are no frames.
void checkLiquid(const World& world, const Liquid& liquid, const std::string& who);

// On which terms it meets walls, for collide(): smooth, and a twentieth of a spacing thick.
// Densities carry what presses on a wall; contacts catch what is thrown at it. Half a spacing would
// lift a column by 4 %, and a tenth would carry a sixtieth of its weight.
Surface surfaceOf(const Liquid& liquid);

// m; how far particles see.
double kernelRadius(const Liquid& liquid);

// What turned walls hide of a liquid's particles: a second of work for each.
Shades shadesOf(const Liquid& liquid);

// The largest part by which a liquid at rest of this depth (m) is compressed, under gravity
// (m/s^2), in substeps of h (s): measured, to a tenth, on columns of 24 and 48 layers; the mean is
// 0.45 of it. For a moment after an impact it is up to seven times as much.
double restCompression(const Liquid& liquid, double depth, double gravity, double h);

// By particle, how dense it is over how dense water is at rest: its own sum, not cut off at the
// surface, where it is less than 1; 0 of one that is not there, whose id is below 0 (by vertex;
// none: all are). Walls as they stand at time t (s).
std::vector<double> densityRatios(const Liquid& liquid, std::span<const Vec<double>> positions,
                                  double t = 0, std::span<const std::int32_t> ids = {});

// Adds the set. It is its own mirror image: of a palindrome, forward and backward, it takes the
// middle, so it should be last by order. Throws as checkLiquid does.
void holdDensity(World& world, const Liquid& liquid, SetOptions options);

}  // namespace plait
