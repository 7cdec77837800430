// Topology: points, edges, triangles and tetrahedra in one structure of integers (S 3).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "csr.h"

namespace plait {

// What a complex is built from; vertices are named in the order that orients the simplex.
struct Simplices {
    std::vector<std::array<int, 2>> edges;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 4>> tetrahedra;
};

// Two triangles that share an edge. The edge v0 v1 runs along the first triangle's orientation:
// the triangles are (v0, v1, v2) and (v1, v0, v3), the first just as it is oriented, the second so
// oriented that both normals agree where the hinge is flat, whatever its own sign.
struct Hinge {
    std::array<int, 4> vertices;
    int edge;
};

// The indices first .. last - 1.
struct Range {
    int first = 0;
    int last = 0;

    int size() const { return last - first; }
};

// A k-simplex is named by its dimension k (0 to 3) and its index i. Point i is vertex i.
// Simplices that were given keep their order and come first; faces that only the closure asks for
// follow in the order of their vertices, with sign +1. A simplex given twice is kept once.
class SimplicialComplex {
public:
    static constexpr int maxDimension = 3;

    SimplicialComplex() = default;

    // All vertices 0 .. vertexCount - 1 are points, used or not. Throws std::invalid_argument on a
    // negative count, a vertex out of range and a vertex that stands twice in a simplex.
    explicit SimplicialComplex(int vertexCount, const Simplices& given = {});

    int count(int k) const;

    // The k + 1 vertices, ascending. Indices are not checked, here and in the next three.
    std::span<const int> vertices(int k, int i) const;

    // The k + 1 faces of dimension k - 1 (none for a point): face j lacks vertex j.
    std::span<const int> faces(int k, int i) const;

    // +1 if an even number of swaps sorts the vertices as given, -1 if odd, 0 if the simplex was
    // given in both orientations and so has none (S 3).
    int sign(int k, int i) const;

    // Sign of face j in the boundary of simplex i, both in their own orientations; where one has
    // none, its ascending order stands in. The boundary of a boundary is 0.
    int incidence(int k, int i, int j) const;

    // Vertices in an order that has the orientation given: an even permutation of what was given,
    // the smallest first (for an edge, exactly as given). Ascending where there is no orientation.
    std::array<int, 2> edge(int i) const;
    std::array<int, 3> triangle(int i) const;
    std::array<int, 4> tetrahedron(int i) const;

    // For each k-simplex the (k + 1)-simplices that it is a face of, ascending.
    Csr parents(int k) const;

    // For each k-simplex its number of parents.
    std::vector<int> valences(int k) const;

    // The k-simplices with exactly one parent, ascending.
    std::vector<int> boundary(int k) const;

    // Every pair of parents of every edge, by edge, then by the lower and the higher triangle.
    // An edge with p parents has p (p - 1) / 2 hinges.
    std::vector<Hinge> hinges() const;

    // For each vertex the other ends of its edges, ascending.
    Csr oneRing() const;

    // Points - edges + triangles - tetrahedra.
    int eulerCharacteristic() const;

    // Puts the simplices of `other` behind those here, its vertices renumbered; returns their
    // range.
    Range append(const SimplicialComplex& other);

    bool operator==(const SimplicialComplex&) const = default;

private:
    // All simplices of one dimension; vertices and faces are tables with k + 1 columns.
    struct Layer {
        std::vector<int> vertices, faces, signs;
        bool operator==(const Layer&) const = default;
    };

    const Layer& layer(int k) const;
    static Layer makeLayer(int k, int vertexCount, std::vector<int> table, Layer& above);

    std::array<Layer, maxDimension + 1> layers_;

    static_assert(std::is_same_v<decltype(Layer::vertices), std::vector<int>> &&
                      std::is_same_v<decltype(Layer::faces), std::vector<int>> &&
                      std::is_same_v<decltype(Layer::signs), std::vector<int>> &&
                      sizeof(Layer) == 3 * sizeof(std::vector<int>),
                  "topology holds only integers (S 3)");
};

// The class is its layers and nothing beside them: with the above, integers throughout.
static_assert(sizeof(SimplicialComplex) == 4 * 3 * sizeof(std::vector<int>));

inline std::span<const int> SimplicialComplex::vertices(int k, int i) const {
    return std::span(layers_[k].vertices).subspan((k + 1) * std::size_t(i), k + 1);
}

inline std::span<const int> SimplicialComplex::faces(int k, int i) const {
    return k == 0 ? std::span<const int>()
                  : std::span(layers_[k].faces).subspan((k + 1) * std::size_t(i), k + 1);
}

inline int SimplicialComplex::sign(int k, int i) const { return layers_[k].signs[i]; }

}  // namespace plait
