// How a solid of any shape is cut into convex cells: each lump gives up to the others, at a plane
// midway between their sites, what lies nearer to them (Voronoi's cells in space).
#pragma once

#include "../complex/shapes.h"

#include <span>
#include <vector>

namespace plait {

struct HalfSpace {
    Vec<double> normal;  // of unit length, outward
    double offset;       // m: x with dot(normal, x) <= offset are within
};

// What would be there if its site were alone.
struct Lump {
    Vec<double> site;               // m
    std::vector<HalfSpace> within;  // with what others take, they must close it
};

// A face that two cells have in common, as a rectangle of its area.
struct SolidSeam {
    int first, second;      // cells, first < second
    Vec<double> along;      // of unit length, the face's longest side
    double length, height;  // m, along it and across
};

struct SolidPattern {
    std::vector<Vec<double>> sites;  // m
    std::vector<Shape> cells;        // closed, faces outward
    std::vector<SolidSeam> seams;
};

// Every cut takes `kerf` (m), so that neighbours never coincide. Throws std::invalid_argument for a
// kerf that is not positive, for a lump that lacks its site, is empty, or reaches farther than 10 m
// from it.
SolidPattern cut(std::span<const Lump> lumps, double kerf);

}  // namespace plait
