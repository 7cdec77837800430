// Intersections of a soup of triangles and edges, counted exactly: how tangled a state is.
// Independent of the solver's and of the collision code; decided by signs of orientation.h alone.
#pragma once

#include <array>
#include <compare>
#include <span>
#include <vector>

#include "../../numbers/math.h"

namespace plait {

// Edge i pierces triangle j.
struct Intersection {
    int edge, triangle;
    auto operator<=>(const Intersection&) const = default;
};

// All pairs of an edge and a triangle that share no vertex index and where the edge's ends lie
// strictly on opposite sides of the triangle's plane and the edge meets the closed triangle; by
// edge, then by triangle.
//
// So touching does not count: an edge in the plane of a triangle, an end that lies on one, a
// triangle without area. An edge that goes through a side or corner is counted once for each
// triangle there. Two points at one place are two points: shared means the same index.
//
// Positions in m, finite and within the range of orientation.h. Throws std::invalid_argument on
// a position that is not finite or an index out of range. About n log n in time for n triangles.
std::vector<Intersection> findIntersections(std::span<const Vec<double>> positions,
                                            std::span<const std::array<int, 2>> edges,
                                            std::span<const std::array<int, 3>> triangles);

// How many pairs that is.
int countIntersections(std::span<const Vec<double>> positions,
                       std::span<const std::array<int, 2>> edges,
                       std::span<const std::array<int, 3>> triangles);

// The same for the triangles' own edges, each taken once.
int countIntersections(std::span<const Vec<double>> positions,
                       std::span<const std::array<int, 3>> triangles);

// How often two surfaces cross, such as a body and a cloth: edges of either through triangles of
// the other.
int countCrossings(std::span<const Vec<double>> positions, std::span<const std::array<int, 3>> a,
                   std::span<const std::array<int, 3>> b);

// The sides of triangles, the lower index first, each once, ascending.
std::vector<std::array<int, 2>> edgesOf(std::span<const std::array<int, 3>> triangles);

}  // namespace plait
