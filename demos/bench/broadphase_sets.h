// Primitives for the broad phase: what moves in a step, and where.
#pragma once

#include <plait/collision/kdop.h>
#include <plait/complex/complex.h>

#include <string>
#include <vector>

namespace plait {

// Four crumpled sheets that lie on each other, with about `triangles`.
struct FoldedSheets {
    SimplicialComplex complex{};
    std::vector<Vec<double>> start{}, end{};  // m
    double radius, margin;                    // m: half the thickness; a quarter of an edge
};
FoldedSheets foldedSheets(int triangles);

// Edges, or points where the arity is 1.
struct BroadPhaseSet {
    std::string name;
    int arity = 2;
    double radius = 0;                 // half the thickness, m
    std::vector<Vec<double>> start{};  // of every vertex, m
    std::vector<Vec<double>> end{};
    std::vector<int> vertices{};  // `arity` a primitive

    int count() const { return static_cast<int>(vertices.size()) / arity; }
    std::span<const int> primitive(int i) const {
        return std::span(vertices).subspan(std::size_t(i) * arity, arity);
    }
};

constexpr int broadPhaseSets = 5;

// Of about `count` primitives: edges scattered uniformly, edges in clusters, edges of crumpled
// sheets that lie on each other, particles scattered uniformly, particles in clusters. As dense
// with any count.
BroadPhaseSet broadPhaseSet(int which, int count);

}  // namespace plait
