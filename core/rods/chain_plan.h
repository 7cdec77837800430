// In which order the rows along curves are eliminated, and which of them couple: integers only.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace plait {

inline constexpr int mostChained = 5;  // vertices of a row

// A row of a part, or one value of several that a row has.
struct ChainPlace {
    int part, row, value;
    int arity;
    std::array<int, mostChained> at;  // places of its vertices in ChainCurve::vertices
};

struct ChainCurve {
    std::vector<int> vertices;       // that move, in order; then those of its rows that do not
    int moving = 0;                  // how many of them move
    std::vector<ChainPlace> places;  // the border last
    int halfWidth = 0, border = 0;
};

// What a plan is made of: the stencils of a part.
struct ChainStencils {
    std::span<const int> ids;
    int arity, values;
    bool links = false;  // C is a distance less a constant
};

// `curves`: the vertices of each, in order, each vertex that moves in one curve at most. A row
// belongs to the curve of its vertices that move, and is placed by the last of them; one that spans
// more than half of its curve closes a ring, and is of the border. Rows that move nothing are left
// out. `pinned` by vertex. Throws std::invalid_argument for a row that joins two curves or has a
// vertex on none.
std::vector<ChainCurve> planChains(std::span<const ChainStencils> parts,
                                   std::span<const std::vector<int>> curves,
                                   std::span<const unsigned char> pinned);

// True if nothing but vertices and rows tells the two apart, so that they can be solved side by
// side.
bool samePlan(const ChainCurve& a, const ChainCurve& b);

}  // namespace plait
