// How a pane is cut into convex cells: Voronoi's, of sites that lie evenly or as a star about a
// point. Lengths in metres, in the plane of the pane, whose corner is the origin.
#pragma once

#include "../complex/shapes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plait {

struct PlanePoint {
    double x, y;
};

struct Pane {
    double width, height, thickness;  // m
    double kerf = 20e-6;              // m, that every cut takes: neighbours never coincide
    double leastCell =
        0;  // m^2: the sites of smaller cells go, and their neighbours take them over
};

struct Cell {
    PlanePoint site;
    std::vector<PlanePoint> outline;  // anticlockwise, less half the kerf at every cut
};

// What two cells have in common, or one and the border, as the middle of the kerf has it. It runs
// with the first cell on its left.
struct Seam {
    int first, second;  // second: border - 1 - side, of sides y = 0, x = width, y = height, x = 0
    PlanePoint from, to;

    static constexpr int border = 0;
    bool onBorder() const { return second < border; }
};

struct Pattern {
    Pane pane;
    std::vector<Cell> cells;
    std::vector<Seam> seams;  // by first cell, first < second; each once
};

// Voronoi's cells. Throws std::invalid_argument for a pane without a size, for a site outside of
// it, and if there is none.
Pattern cut(const Pane& pane, std::vector<PlanePoint> sites);

// So many sites, each anywhere with the same chance.
std::vector<PlanePoint> evenSites(const Pane& pane, int count, std::uint64_t seed);

struct Star {
    PlanePoint centre;      // m, where it is struck
    double inner = 0.006;   // m, of the first ring
    double slender = 1.8;   // cells are so many times as long, away from the centre, as wide
    double scatter = 0.35;  // of a site, in parts of what lies between two
};

// About so many sites on rays and rings whose radii grow by one factor (log-polar): cracks run out
// from the centre and around it, and cells are the larger the farther away.
std::vector<PlanePoint> starSites(const Pane& pane, const Star& star, int count,
                                  std::uint64_t seed);

// A cell as a closed solid, its faces outward, from z = -thickness / 2 to thickness / 2. With a
// `bevel` (m, at most a quarter of what is within) it is the widest in the middle, and about as
// much narrower at both faces: rigid prisms that fill a plane leave no way for one of them to turn.
Shape prismOf(const Cell& cell, double thickness, double bevel = 0);

}  // namespace plait
