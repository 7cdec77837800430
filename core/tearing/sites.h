// Vertices as places where a sheet may come apart: by the names that they have by now.
#pragma once

#include "../complex/cuts.h"
#include "../numbers/math.h"

#include <span>
#include <vector>

namespace plait {

// An edge at a vertex.
struct Spoke {
    int end;                // the vertex at its other end
    int edge;               // of the whole complex
    int triangles;          // of this vertex that have it
    double length;          // m, at rest
    Vec<double> direction;  // of unit length, at rest, away from the vertex
};

struct Site {
    std::vector<Spoke> spokes;   // by edge
    std::vector<int> triangles;  // of the whole complex, ascending
    double angle = 0;            // of its triangles at rest, together
    Vec<double> normal{};        // of unit length, at rest

    bool inside() const;  // triangles all around
    // The end of a tear or of a notch: its triangles go nearly all the way round, and its edge
    // comes back beside itself.
    bool endsTear() const { return !inside() && angle > 5.2; }
    // Of unit length, at rest: where a tear that ends here would go straight on.
    Vec<double> ahead() const;
};

// By vertex of the complex; those that are in no triangle have none.
std::vector<Site> sitesOf(const Cuts& cuts, std::span<const Vec<double>> rest);

}  // namespace plait
