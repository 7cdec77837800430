// What holds a sheet that does not stretch, whatever its mesh and however fine.
//
// Plain sweeps carry a load one edge an evaluation, and a sheet of N x N hung up wants some N^2 of
// them. Each part below says at once what sweeps say slowly. Every part is a set of the schedule
// like any other, and each can be left out.
#pragma once

#include "world.h"

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
};

// Constrains every edge of `sheet` to its rest length. From the outside of the palindrome to its
// inside: mending, which has the last word; what strands leave out (of a grid its diagonals), edge
// by edge; strands; tethers from the vertices of `sheet` that are pinned by now; aggregates. With
// strands outside, or without the diagonals there, cells of a sheet that whips round fold up into
// themselves and stay so.
void holdSheet(World& world, Range sheet, const SheetOptions& options = {});

}  // namespace plait
