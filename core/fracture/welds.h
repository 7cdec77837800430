// Welds: faces by which pieces hold together until what they bear is too much. README.md tells how
// it is done.
#pragma once

#include "../numbers/math.h"
#include "../patterns/pattern.h"
#include "../patterns/solid_pattern.h"
#include "../world.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plait {

// A rectangle that two pieces of the world have in common, where all starts. Its spring is as long
// as what lies between two Voronoi sites, and acts midway between them.
struct Weld {
    int first, second;   // pieces
    Vec<double> at;      // m, where the spring acts
    Vec<double> normal;  // of unit length, from the first to the second
    Vec<double> along;   // of unit length, across the normal: a side of the rectangle
    double length;       // m, of that side
    double height;       // m, of the other
    double span;         // m, of the spring
};

struct WeldMatter {
    double stiffness = 70e9;  // Pa, Young's modulus
    double strength = 45e6;   // Pa, of tension and bending together
    double scatter = 0.1;     // of the strength from face to face, in parts of it, 0 to below 1
    std::uint64_t seed = 1;
    double toughness = 8;  // J/m^2 of both new faces
    // Of what blows press against each other (Hertz).
    double contactStiffness = 55e9;  // Pa, 1 / ((1 - nu1^2) / E1 + (1 - nu2^2) / E2)
    // m, kg/m^3: a plate gives way before Hertz's force is reached. 0: not a plate.
    double plate = 0, density = 2500;
};

struct WeldOptions {
    std::string name = "welds";
    WeldMatter matter = {};
    int order = 0;
    int importance = 24;
};

// Holds all pieces that the world has by now rigid, and those that welds join as one, until they
// break; it takes the place of holdPieces. Call it before meetPieces, whose contacts are the loads.
// Throws std::invalid_argument, naming the options' name and the value, for one out of range, a
// weld of pieces that are not there, or a world that has welds.
void weldPieces(World& world, std::vector<Weld> welds, const WeldOptions& options = {});

// Of a pattern whose cells are these pieces, its plane at z = 0 and its corner at `corner`. A face
// on the border is welded to the piece of its side (bottom, right, top, left), -1: to none.
std::vector<Weld> weldsOf(const Pattern& pattern, const Vec<double>& corner,
                          std::span<const int> pieces, const std::array<int, 4>& sides);
std::vector<Weld> weldsOf(const SolidPattern& pattern, std::span<const int> pieces);

template <class Real>
struct State;

// Which of a world's welds hold, 1 or 0 each; empty if it has none.
template <class Real>
std::vector<std::int32_t> holdingOf(const World& world, const State<Real>& state);

}  // namespace plait
