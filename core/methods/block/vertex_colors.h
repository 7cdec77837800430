// Colours of vertices: no two of a colour share a constraint, so that all of them can be moved
// from the same evaluation, as if one after another.
#pragma once

#include <span>
#include <vector>

namespace plait {

// Which vertices the constraints of a set join.
struct SetStencils {
    int arity;
    std::vector<int> ids;  // arity a constraint
};

struct VertexColor {
    // The constraints of a set at these vertices: their places in the set, and which of its
    // vertices has the colour.
    struct Share {
        std::vector<int> constraints, corners;
    };
    std::vector<int> vertices;
    std::vector<Share> sets;  // as many as there are sets
};

// Each vertex, in order, gets the lowest colour that no neighbour has; those that are pinned, by
// vertex, or have no constraint get none. Linear in the entries of the stencils times the
// neighbours of a vertex.
std::vector<VertexColor> vertexColors(std::span<const SetStencils> sets,
                                      std::span<const unsigned char> pinned);

}  // namespace plait
