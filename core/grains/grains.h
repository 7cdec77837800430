// Grains: balls that push each other apart, rub and may cling [GR1-GR11].
#pragma once

#include "../world.h"

#include <vector>

namespace plait {

// Whether pairs are corrected one after another, or all from where everything is; and then, by what
// the sum of a grain's corrections is divided.
enum class Averaging {
    inTurn,  // what comes later sees what came before: needs no average, and keeps momentum
    none,    // nothing: weights above 0.5 blow up where many meet (V)
    grain,   // how many meet it (V): stable, and loses momentum
    pair     // of a pair the larger of both counts: stable, and keeps momentum
};

struct Grains {
    Range vertices{};
    double radius = 0.01;            // m
    std::vector<double> radii = {};  // m, one a vertex in place of it
    double staticFriction = 0.6, dynamicFriction = 0.4;
    // Parts of an overlap, and of a gap, that an evaluation takes away, of all and of either [GR5,
    // GR6, GR7]. What clings does so up to `cling` (m) apart.
    double weight = 1, repulsion = 1, attraction = 0;
    double cling = 0;
    Averaging averaging = Averaging::inTurn;
    // Of the sum of their radii by which two that rest may overlap, so that they keep touching.
    double slop = 0.005;
    double recovery = 0.5;  // m/s: how fast what begins a substep too near may part
    // Those are neighbours for a substep that are within this many times the sum of their radii as
    // it begins, since nobody looks again before it ends [GR1]; and of them the nearest so many, 0:
    // all [GR2]; in turn, those of the one of a pair that comes first.
    double searchScale = 1.5;
    int mostNeighbours = 0;
    // By vertex; those of one piece, 0 or more, do not meet [GR4]. Empty: all do.
    std::vector<int> pieces = {};
    // What is under a grain counts as heavier by k = 1 + x + x^2 / 2 + x^3 / 6, x the shock times
    // how straight it is under it, at most 1, and below 1 of what is over it: piles stand sooner,
    // and momentum is not kept (V) [GR9, GR10].
    double shock = 0;
    Vec<double> up{0, 1, 0};
};

// Adds the set. Throws std::invalid_argument, naming it, for vertices that are not in the world, a
// radius that is not above 0, lists of another length, a search scale below 1, and what is negative
// that cannot be.
void pushGrains(World& world, const Grains& grains, SetOptions options);

}  // namespace plait
