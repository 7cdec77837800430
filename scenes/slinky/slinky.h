// The toy of two demos: a flat wire of steel, wound turn on turn. The wire is all that is put in.
#pragma once

#include "../parts/measures.h"
#include "../scene.h"

#include <plait/contacts/surface.h>
#include <plait/rods/rod.h>
#include <plait/world.h>

#include <span>
#include <string>
#include <vector>

namespace plait {

struct Slinky {
    Wire wire{.poisson = 0.27, .along = 2.5e-3, .across = 0.62e-3};
    double radius = 0.034;  // m, of the helix
    int turns = 86;
    int links = 24;         // of a turn
    double pretension = 0;  // N, that draws its turns together: so much hangs closed

    // Closed forms of a close-wound coil, all of whose turns are free (Wahl, "Mechanical springs").
    double mass() const;       // kg
    double stiffness() const;  // N/m
    double period() const;     // s, of the slowest swing up and down, hung
    // m, hung by its first turn: 0.968 of m g / 2 k of the others, since turns that are drawn apart
    // are no longer level (validation A7), and of what weighs more than the pre-tension.
    double extension() const;
    // s from letting go until the last turn moves, turns that meet staying together (Calkin,
    // "Motion of a falling spring", 1993).
    double collapse() const;
};

// What `describe` says of it.
std::vector<std::string> factsOf(const Slinky& slinky);

// Closed, from y = 0 up, around the upright through `foot`. Names its set "wire".
Rod addSlinky(World& world, const Slinky& slinky, const Vec<double>& foot);

// How its wire meets others: flat.
Surface skinOf(const Slinky& slinky, const Rod& rod);

// The points and directors of so many turns from the upper end.
std::vector<int> upperTurns(const Slinky& slinky, const Rod& rod, int turns);

// Starts it as it hangs by what is pinned of its upper end. It takes 1.7 s, so that whatever is let
// go in that time must be told of later.
void hang(World& world, const Slinky& slinky, const Rod& rod);

// How many turns have the next one beside them, by more than half the wire's width, in place of on
// them, by parts of a turn. So stands a coil that does not close any more.
double turnsBeside(const Slinky& slinky, const Rod& rod, std::span<const Vec<double>> positions);
Metric ridingOff(const Slinky& slinky, const Rod& rod, const Band& band);

Scene levitation(const Knobs& knobs);
Scene slinky(const Knobs& knobs);

// Bare steel, brushed along the wire.
Look lookOf(const Slinky& slinky, const Rod& rod);

}  // namespace plait
