// What a multifrontal Cholesky factorisation of 3 x 3 blocks knows before it sees a number: its
// fronts, where their numbers lie, and what goes where.
#pragma once

#include "dissection.h"
#include "front_kernels.h"

#include <span>
#include <vector>

namespace plait {

// The dense matrix of one part: its pivots, then its boundary (the later vertices that they couple
// with, once everything earlier is eliminated), three rows a vertex, each padded to whole strips.
struct Front {
    int begin, end;             // pivots: positions in the order of elimination
    int parent;                 // -1 for a root
    std::vector<int> boundary;  // positions, ascending

    int pivotStrips, boundaryStrips;
    long panel;      // its first column among those of all panels
    long rows;       // its first row among those of all fronts
    long schur;      // first column of its Schur complement, in the memory of `ownMemory`
    bool ownMemory;  // or in that of the thread that runs its subtree
    double work;     // multiplications, with those of its descendants

    // Extend-add: how its Schur complement goes into the parent's front.
    std::vector<int> inParent;      // row of the parent's front, by row of the boundary
    int parentPivots;               // rows of the boundary that are pivots there
    std::vector<int> firstOverlap;  // by strip of the boundary, and the end
    std::vector<Overlap> overlaps;
};

// An edge at a vertex.
struct Incidence {
    int edge;
    int row;  // of the other vertex, in the front where this one is a pivot; -1 if it is eliminated
              // earlier, or never
};

// A run of fronts [begin, end) that needs no other.
struct Subtree {
    int begin, end;
};

struct Fronts {
    std::vector<int> order;                  // vertices, as they are eliminated
    std::vector<Front> fronts;               // children before parents
    std::vector<std::vector<int>> children;  // by front
    std::vector<int> firstIncidence;         // by position in the order, and the end
    std::vector<Incidence> incidences;       // ascending edges at each vertex

    // Subtrees first, in any order; then one level of fronts after the other.
    std::vector<Subtree> subtrees;
    std::vector<std::vector<int>> levels;

    long panelColumns = 0, rows = 0, ownColumns = 0, threadColumns = 0;  // sizes
};

// `edges` in pairs; those of a vertex with itself are nothing. `pinned` vertices are in no front.
Fronts analyse(std::span<const Vec<double>> rest, std::span<const int> edges,
               std::span<const unsigned char> pinned, int leaf);

}  // namespace plait
