#include "sites.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

// One that is cut has two sides.
Spoke& spokeOf(Site& site, int edge, bool isCut) {
    const auto at = std::ranges::lower_bound(site.spokes, edge, {}, &Spoke::edge);
    if (at != site.spokes.end() && at->edge == edge && !isCut) return *at;
    return *site.spokes.insert(at, {-1, edge, 0, 0, {}});
}

}  // namespace

bool Site::inside() const {
    return std::ranges::all_of(spokes, [](const Spoke& s) { return s.triangles > 1; });
}

Vec<double> Site::ahead() const {
    Vec<double> back{0, 0, 0};
    for (const Spoke& spoke : spokes)
        if (spoke.triangles < 2) back += spoke.direction;
    return divide(-1.0, length(back)) * back;
}

std::vector<Site> sitesOf(const Cuts& cuts, std::span<const Vec<double>> rest) {
    const SimplicialComplex& whole = cuts.whole();
    std::vector<Site> sites(static_cast<std::size_t>(whole.count(0)));
    for (int t = 0; t < whole.count(2); ++t) {
        const auto names = cuts.corners(t);
        const auto triangle = whole.triangle(t);
        const Vec<double> area =
            cross(rest[triangle[1]] - rest[triangle[0]], rest[triangle[2]] - rest[triangle[0]]);
        for (int c = 0; c < 3; ++c) {
            Site& site = sites[names[c]];
            site.triangles.push_back(t);
            site.normal += area;
            Vec<double> sides[2];
            int n = 0;
            for (int other = 0; other < 3; ++other) {
                if (other == c) continue;
                // The face that lacks the third vertex.
                const int edge = whole.faces(2, t)[3 - c - other];
                Spoke& spoke = spokeOf(site, edge, cuts.isCut(edge));
                sides[n++] = rest[names[other]] - rest[names[c]];
                spoke.end = names[other];
                spoke.length = length(sides[n - 1]);
                spoke.direction = divide(1.0, spoke.length) * sides[n - 1];
                ++spoke.triangles;
            }
            site.angle += std::atan2(length(cross(sides[0], sides[1])), dot(sides[0], sides[1]));
        }
    }
    for (Site& site : sites) site.normal = divide(1.0, length(site.normal)) * site.normal;
    return sites;
}

}  // namespace plait
