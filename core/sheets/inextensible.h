// What holds a sheet that does not stretch, whatever its mesh and however fine.
//
// Plain sweeps carry a load one edge an evaluation, and a sheet of N x N hung up wants some N^2 of
// them. Each part below says at once what sweeps say slowly. Every part is a set of the schedule
// like any other, and each can be left out.
#pragma once

#include "../world.h"
#include "aggregates/aggregates.h"
#include "strands/strands.h"
#include "tethers/tethers.h"

#include <optional>

namespace plait {

struct SheetOptions {
    double compliance = 0;    // m/N, of every edge; where it is not 0, nothing bounds how far the
                              // sheet goes: tethers, aggregates and mending are left out
    bool strands = true;      // straight ways through the mesh, each solved whole
    bool tethers = true;      // how far the sheet lets a vertex be from each pin; pins may move
    bool aggregates = false;  // coarse levels, of more use without strands
    double mending = 0.008;   // part of its length by which an edge may be too long after all this
                              // before it is mended (mend_set.h); 0: none is
    int order = 0;            // of the first of the sets; the others have the next four

    // Of strands (strand_set.h): a half to a third of the substeps for a fine sheet that hangs
    // free. Off, since strands that contacts wring are straightened through them: one of 41 x 11,
    // twisted ten turns, crosses itself a thousand times, and without it not at all.
    bool geometricStiffness = false;
};

// Constrains every edge of `sheet` to its rest length. From the outside of the palindrome to its
// inside: mending, which has the last word; what strands leave out (of a grid its diagonals), edge
// by edge; strands; tethers from the vertices of `sheet` that are pinned by now; aggregates, of
// what is pinned and weighs by now. With strands outside, or without the diagonals there, cells of
// a sheet that whips round fold up into themselves and stay so.
void holdSheet(World& world, Range sheet, const SheetOptions& options = {});

// What holdSheet finds out about a sheet, kept so that a cut changes only what it touches: tethers
// whose way led through it, aggregates that come apart and bounds near them, strands with an edge
// cut. The sheet then goes on in a world that is alike but for these sets, from the same state
// (Solver::restore).
class SheetPlan {
public:
    // As above.
    SheetPlan(const World& world, Range sheet, const SheetOptions& options = {});

    // Edges of the complex that hold no more; one that is cut already stays so. A triangle on one
    // is no surface any more for ways to lead across; its other edges hold on. Throws
    // std::invalid_argument, and cuts nothing, for an edge that is not one of the sheet's.
    void cut(std::span<const int> edges);

    // Adds the sets to a world of the same vertices and pins.
    void hold(World& world) const;

    // Windows, vertices and pairs looked at by the constructor or the last cut: the counted work
    // of tethers and aggregates. What is merely copied is not counted, nor what strands take.
    long visited() const;

private:
    SheetOptions options_;
    Rows<Stretch> edges_;               // all that there were, in the order of the complex
    std::vector<int> place_;            // by edge of the complex: in edges_, -1 for none
    std::vector<bool> isCut_;           // by place
    std::vector<int> threads_, swept_;  // places: of edges in strands, and of the others
    std::vector<Strand> strands_;       // of threads_
    std::optional<TetherPlan> tethers_;
    std::optional<AggregatePlan> aggregates_;
};

}  // namespace plait
