// What of a world the air touches, laid out for its kernels.
#pragma once

#include "../complex/complex.h"
#include "../state.h"
#include "air_kernels.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

struct World;

// An edge or a triangle at rest.
struct RestFacet {
    std::array<int, 3> vertices;            // of an edge the first two
    double size;                            // length (m) or area (m^2)
    double area;                            // m^2
    std::array<Vec<double>, 3> sides = {};  // m, of a triangle: opposite its vertices
};

// Edges and triangles, in places 0 and 1 as in AirTable.
using RestFacets = std::array<std::vector<RestFacet>, 2>;

// The triangles within `objects` (none: everything) that are not inside a solid, and the edges of
// `width` (m) that no triangle has. What has no area at rest has no mass either, and is left out.
// Throws std::invalid_argument for objects that the world has not.
RestFacets restFacets(const World& world, std::span<const Range> objects, double width);

// Each vertex's part of the rest area around it, m^2.
std::vector<double> areaShares(const RestFacets& facets, int vertices);

// The facets of one kind and the vertices around them, both filled up to whole blocks: facets
// without area on the padding vertex, and around vertices the facet `size()`, which stays 0.
template <class Real>
class AirSkin {
public:
    // `padding` is a vertex without mass that nothing else uses.
    AirSkin(int corners, const std::vector<RestFacet>& facets, const std::vector<double>& shares,
            int padding);

    int corners() const { return corners_; }
    int size() const { return static_cast<int>(sides.size()) - 1; }      // with padding
    int vertices() const { return static_cast<int>(vertices_.size()); }  // with padding
    // The vertex at a corner of a facet.
    int vertex(int facet, int corner) const { return ids_[slot(facet, corner, corners_)]; }

    // Allocates room for gusts.
    void makeGusts() { gusts_.resize(6 * (sides.size() - 1)); }
    void setGust(int facet, const Vec<double>& start, const Vec<double>& change);

    FacetBlocks<Real> blocks();
    AroundBlocks<Real> around() const;

    std::vector<Padded<Real>> sides, impulses;  // by facet: as in FacetBlocks

private:
    static std::size_t slot(int facet, int member, int members) {
        const int lane = facet % blockSize;
        const int at = (facet - lane) * members + member * blockSize + lane;
        return static_cast<std::size_t>(at);
    }
    void layOutAround(int facets, int padding);

    int corners_;
    std::vector<int> ids_, vertices_, start_{0}, around_;
    std::vector<Real> rows_, gusts_;
};

}  // namespace plait
