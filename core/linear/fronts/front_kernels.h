// The border between the multifrontal factorisation and its inner loops, which are compiled once
// per instruction set (front_kernels.cpp) and chosen at run time. Only plain pointers cross it.
#pragma once

#include "../../kernels/kernels.h"
#include "../../numbers/math.h"

namespace plait {

// Dense matrices lie in strips of this many rows, column after column within a strip, whatever the
// width of the registers: every number sees the same operations in the same order.
inline constexpr int stripRows = 16;

inline namespace PLAIT_ISA {

// Columns before strip s of a symmetric matrix, of which strips end with their diagonal block.
inline long columnsBefore(long s) { return s * (s + 1) * (stripRows / 2); }

// Columns before strip s of a panel: pivots, of which only the lower half is kept, then boundary.
inline long columnsBefore(long pivotStrips, long s) {
    if (s <= pivotStrips) return columnsBefore(s);
    return columnsBefore(pivotStrips) + (s - pivotStrips) * pivotStrips * stripRows;
}

}  // namespace PLAIT_ISA

// The numbers of a front. Once eliminated, the diagonal blocks of the panel hold L^-T of
// themselves.
struct FrontView {
    float* panel;        // pivots, then boundary rows, by columns of pivots
    float* schur;        // boundary by boundary, lower half
    const float* least;  // by pivot: one that is not above it is frozen
    int pivotStrips, boundaryStrips;
};

// The rows of one strip of a child's Schur complement that go into one strip of its parent.
struct Overlap {
    int strip;                      // of the parent
    int end;                        // of the child's columns that are within its lower half
    unsigned short mask;            // lanes of the parent's strip
    unsigned char lane[stripRows];  // of the child's strip, by lane of the parent's
};

struct Extension {
    const float* schur;  // of the child
    const Overlap* overlaps;
    const int* firstOverlap;  // by strip of the child, and the end
    const int* inParent;      // column of the parent by column of the child
    int strips;               // of the child
    FrontView parent;
};

struct FrontTable {
    // Eliminates the pivots of one diagonal block, those of all earlier blocks being eliminated.
    // Returns how many were frozen.
    int (*eliminate)(const FrontView&, int block);
    // What is left of that block's columns in strips [begin, end) below it.
    void (*eliminateBelow)(const FrontView&, int block, int begin, int end);
    // Strips [begin, end) of the Schur complement, children not counted.
    void (*complement)(const FrontView&, int begin, int end);
    // Adds columns [begin, end) of a child, all of them pivots of the parent or none.
    void (*extendPanel)(const Extension&, int begin, int end);
    void (*extendComplement)(const Extension&, int begin, int end);
    // x: a number a row. Forward leaves in the boundary what is to be added to the parent's rows;
    // backward finds the solution there.
    void (*forward)(const FrontView&, float* x);
    void (*backward)(const FrontView&, float* x);
};

// Throws std::invalid_argument if `choice` is not available. Its lanes say nothing here.
const FrontTable& frontKernels(KernelChoice choice);

}  // namespace plait
