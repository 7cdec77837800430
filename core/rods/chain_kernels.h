// The border between chain sets and their inner loops, which are compiled once per instruction set
// (chain_kernels.cpp) and chosen at run time. Only plain pointers cross it.
//
// Curves of one plan are solved side by side, each lane a curve; of a curve alone only its rows are
// evaluated in lanes, which are then rows of a kind one behind the other. Either way each lane does
// what a single number would: the bits are those of a curve alone, in any width.
#pragma once

#include "../kernels/kernels.h"

namespace plait {

// A vertex of a curve as its rows see it, `vertexNumbers` numbers: x (relative to the curve's first
// vertex), s; x when the substep began, w; and its velocity where rates are asked for, 0. s is the
// root of w, so that J W J^T = (J S) (J S)^T.
inline constexpr int vertexNumbers = 12;

// What is left of a row's value: C (or its rate), its compliance, the square of J S, and J S by
// vertex.
inline constexpr int valueNumbers = 3;
// Of a link there is more: its direction, and its length.
inline constexpr int linkNumbers = 4;

// The rows of one kind, in blocks of `width`. Number m of what a block holds is at
// (block * numbers + m) * width + lane.
struct ChainRows {
    const double* rows;  // parameters
    const int* ids;      // arity places in `vertices`: by lane where lanes are rows, else by block
    const double* vertices;  // number m of a vertex, where lanes are curves, at m * width + lane
    double* out;
    int blocks, width;
    bool rates, falls;  // falls: ChainSystem::fall is not zero
    const double* fall;
    double inverseH2;
};
// [1]: where lanes are rows of one curve.
using ChainRowsKernel = void (*)(const ChainRows&);
struct ChainRowsTable {
    ChainRowsKernel evaluate[2];
};

// A row in the order of elimination, at a vertex: J S of that there is at `out` + place.
struct ChainMeeting {
    int row, place;
};

// A link: its row and what is left of that, and its ends, -1 where pinned: among vertices that
// move, and among those that links join.
struct ChainJoint {
    int row, place;
    int a, b, left, right;
};

// Rows from 0 to rows - border - 1, the band, couple with as many next ones as it is wide, those of
// the border with any.
struct BandShape {
    int rows, halfWidth, border;
};

// A curve, or as many as there are lanes.
struct ChainSystem {
    const int* ids;        // of the particles, by lane
    int vertices, moving;  // those that move come first
    const int* places;     // by row: where in `out` what is left of it begins
    const int* begins;     // by vertex that moves, and one more: its meetings
    const int* edges;      // the first of these that is of the border
    const int* ready;      // by vertex: how many rows of the band have none after it
    const ChainMeeting* meetings;
    const ChainJoint* joints;
    int jointCount, joined;  // vertices that links join
    const int* joinedAt;     // each of these among those that move
    BandShape rows, links;
    int step;  // from one number of what is left of a row to the next
    double* vertexNumbers;
    double* out;
    double* lambda;    // by row
    double* work;      // chainWork() numbers a lane
    double keep;       // of lambda from evaluations before
    double redundant;  // the least part of its row that a pivot is
    bool rates;
    double fall[3];  // m: rows are linear where what is pinned would be, did it fall so far
};

template <class Real>
struct ChainTable {
    using Kernel = void (*)(const Sweep<Real>&, const ChainSystem&);
    // [1]: of a curve alone.
    Kernel gather[2], solve[2];
};

// Throws std::invalid_argument if `choice` is not available.
template <class Real>
const ChainTable<Real>& chainKernels(KernelChoice choice);
template <>
const ChainTable<float>& chainKernels<float>(KernelChoice choice);
template <>
const ChainTable<double>& chainKernels<double>(KernelChoice choice);
// Of the kind at this place of the list in chain_kinds.h.
const ChainRowsTable& chainRowsKernels(KernelChoice choice, int kind);

}  // namespace plait
