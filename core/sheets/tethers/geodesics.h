// Shortest ways over a surface, along its edges and across its triangles. Triangles whose edges
// keep their lengths keep every way across them, so the shortest way bounds how far apart two
// vertices can ever be, however the surface folds; along edges alone it is up to sqrt 2 longer in a
// grid.
//
// Windows of light fall from a source through one edge after another, unfolded into a plane (Chen
// and Han 1990), nearest first; what vertices know already puts those out that cannot help (Xin and
// Wang 2009), and where the surface is flat around a vertex, the two halves of a window that it has
// split are joined again behind it, so that a flat sheet of N vertices costs N log N. A window put
// out too much only makes a way longer: a length is always that of a way there is, to 1e-9. So an
// edge of three triangles and more is crossed at its ends alone: light would be parted at each,
// over and over, and windows grow without bound.
#pragma once

#include "../../complex/complex.h"
#include "../../complex/csr.h"
#include "../../numbers/math.h"

#include <span>
#include <vector>

namespace plait {

class Geodesics {
public:
    class Light;  // light.h

    // Of the edges and triangles that lie wholly in `range`; `rest` by vertex, m.
    Geodesics(const SimplicialComplex& complex, Range range, std::span<const Vec<double>> rest);

    struct Way {
        double length;  // m; infinity where none leads
        int source;     // the nearest, -1 where none leads
    };

    // By vertex of the complex. Throws std::invalid_argument for a source that is not in it.
    std::vector<Way> from(std::span<const int> sources) const;

    // What a cut takes out of a surface.
    struct Cut {
        std::vector<int> edges;      // of the complex
        std::vector<int> triangles;  // those on them, in a numbering of this class's own
    };
    // Of these edges, those that are here and not yet taken; ascending.
    Cut cutOf(std::span<const int> edges) const;
    // No way leads along these edges any more, nor across these triangles.
    void take(const Cut& cut);

private:
    struct Point {
        double x, y;
    };
    // A triangle entered across the side from `from` to `to`, laid in a plane: `from` at the
    // origin, `to` on the x axis, `apex` above it. Number 3 t + j is triangle t entered opposite
    // vertex j.
    struct Entry {
        int from, to, apex;
        double length;  // of the side, m
        Point at;       // the apex
    };
    struct Step {
        int vertex;
        double length;
    };

    std::vector<Entry> entries_;
    Csr beyond_;                // by entry: that of the other triangle across the same side
    Csr corners_;               // by vertex: entries whose apex it is
    Csr edges_;                 // by vertex: into steps_
    Csr sides_;                 // by edge of the complex: entries across it
    std::vector<Step> steps_;   // both ways of an edge, one after the other
    std::vector<int> stepsOf_;  // by edge of the complex: the first of the two, -1 for none
    std::vector<bool> taken_;   // by triangle
    std::vector<bool> bends_;   // by vertex: a shortest way may turn there
};

}  // namespace plait
