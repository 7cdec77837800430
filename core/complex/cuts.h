// Topology that comes apart: which vertices the triangles of a complex have once some of its edges
// are cut. A vertex whose triangles hang together no more is split: those with the lowest one keep
// it, each other fan has the next spare vertex. So what there is follows from the edges and their
// order alone.
#pragma once

#include "complex.h"

#include <span>
#include <vector>

namespace plait {

// What may come apart, and the vertices that its copies are taken from, in order.
struct Tearable {
    Range matter, spare;
};

// A vertex that came apart, and the copy that some of its triangles have in its place.
struct VertexSplit {
    int vertex, copy;
    int cut;  // the edge by which they did
};

class Cuts {
public:
    // `held`, by vertex: 1 where a vertex never splits, as what is pinned does not.
    Cuts(SimplicialComplex whole, std::vector<Tearable> tearable,
         std::span<const unsigned char> held);

    // Cuts an edge of the whole complex. False, and nothing is changed: it is cut already, has less
    // than two triangles, lies in nothing that may come apart, or there are no spare vertices left.
    bool cut(int edge);

    // An entry of State::cuts: an edge to cut, or -1 - v: the copy v is now clear of what it was.
    void take(int entry) {
        if (entry < 0)
            parted_[static_cast<std::size_t>(-1 - entry)] = 1;
        else
            cut(entry);
    }
    bool isParted(int copy) const { return parted_[static_cast<std::size_t>(copy)] != 0; }

    const SimplicialComplex& whole() const { return whole_; }
    bool isCut(int edge) const { return cut_[static_cast<std::size_t>(edge)] != 0; }
    bool isHeld(int vertex) const { return held_[static_cast<std::size_t>(vertex)] != 0; }
    bool isApart(int vertex) const { return apart_[static_cast<std::size_t>(vertex)] != 0; }
    // The edges that are cut, in order.
    std::span<const int> order() const { return order_; }
    // In the order in which they came; in one of several fans, later copies are of the first.
    std::span<const VertexSplit> splits() const { return splits_; }
    // The vertex that it was in the whole complex.
    int original(int vertex) const { return original_[static_cast<std::size_t>(vertex)]; }
    // The vertices of triangle t of the whole complex, in the order of whole().vertices(2, t).
    std::span<const int> corners(int t) const {
        return std::span(corners_).subspan(3 * static_cast<std::size_t>(t), 3);
    }
    // As triangles of the whole complex have it: those around a vertex of that.
    std::span<const int> around(int vertex) const { return around_[vertex]; }
    // The vertex that a vertex of the whole complex is called in one of its triangles.
    int nameIn(int triangle, int vertex) const;

    // Renames vertices of the whole complex, as a constraint joins them, by the triangles whose
    // corners are all among them (of two vertices: that have both). False: it lies across a cut, or
    // a vertex of it has come apart and no triangle says which is meant.
    bool rename(std::span<int> stencil) const;
    // The complex as it is by now: triangles in their order, then what else there was.
    SimplicialComplex torn() const;

private:
    // Triangles around a vertex of the whole complex that hang together, lowest first.
    std::vector<std::vector<int>> fansOf(int vertex) const;
    void rename(int triangle, int vertex, int copy);
    // How many copies the fans of a vertex lack for an edge that is cut; made where `make`.
    int part(int vertex, int edge, bool make);

    SimplicialComplex whole_;
    std::vector<Tearable> tearable_;
    std::vector<unsigned char> held_, cut_, parted_;
    std::vector<int> corners_, original_, next_;  // next_: spare vertex, by tearable
    std::vector<int> region_;                     // by vertex: place in tearable_, -1
    std::vector<unsigned char> apart_;            // by vertex of the whole: it has copies
    std::vector<VertexSplit> splits_;
    std::vector<int> order_;
    Csr around_, wings_;  // triangles, by vertex and by edge
};

}  // namespace plait
