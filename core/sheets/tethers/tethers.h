// How far a sheet whose triangles keep their lengths lets each of its vertices be from some
// anchors: what it holds anyway, said at once.
#pragma once

#include "../../constraints/kinds.h"
#include "../../constraints/rows.h"
#include "light.h"

#include <memory>
#include <vector>

namespace plait {

struct Tethers {
    Rows<Tether> set;          // with the anchors where `rest` has them
    std::vector<int> anchors;  // the vertex that each row is tied to
};

// Anchors that edges join count as one, of which the nearest is meant; every such group gives each
// vertex that a way leads to a row, anchors excepted. A cut parts no group: a row is tied to the
// nearest of the group that a way still leads to.
class TetherPlan {
public:
    // Of the simplices that lie wholly in `range`; `rest` by vertex, m. Throws
    // std::invalid_argument for an anchor that is not there.
    TetherPlan(const SimplicialComplex& complex, Range range, std::span<const Vec<double>> rest,
               std::span<const int> anchors);

    // Edges of the complex that hold no more, nor triangles on them. Ways that do not lead there
    // stay as they are, to the bit; the others are found again, as short as if the mesh had been
    // cut from the start, to 1e-9.
    void cut(std::span<const int> edges);

    Tethers tethers() const;
    // Windows and vertices looked at by the constructor or the last cut.
    long visited() const;

private:
    std::vector<Vec<double>> rest_;
    std::vector<bool> isAnchor_;
    std::unique_ptr<Geodesics> surface_;    // stays where it is
    std::vector<Geodesics::Light> lights_;  // by group
    Range range_;
};

// Those of a sheet that nothing cuts.
Tethers tethersOf(const SimplicialComplex& complex, Range range, std::span<const Vec<double>> rest,
                  std::span<const int> anchors);

}  // namespace plait
