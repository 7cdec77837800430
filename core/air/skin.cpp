#include "skin.h"

#include "../forces/body.h"
#include "../world.h"

#include <algorithm>

namespace plait {
namespace {

constexpr double tiny = 1e-30;  // below it kernels do not divide

int wholeBlocks(std::size_t count) {
    return static_cast<int>((count + blockSize - 1) / blockSize * blockSize);
}

}  // namespace

RestFacets restFacets(const World& world, std::span<const Range> objects, double width) {
    const int count = static_cast<int>(world.rest.size());
    const std::vector<Range> everything{{0, count}};
    const auto marks = markObjects(count, objects.empty() ? everything : objects, "air");
    const auto acts = [&](int v) { return marks[static_cast<std::size_t>(v)] != 0; };
    const auto at = [&](int v) { return world.rest[static_cast<std::size_t>(v)]; };
    RestFacets facets;
    const std::vector<int> solids = world.complex.valences(2), sheets = world.complex.valences(1);
    for (int i = 0; i < world.complex.count(2); ++i) {
        const std::array<int, 3> v = world.complex.triangle(i);
        const double area = length(cross(at(v[1]) - at(v[0]), at(v[2]) - at(v[0]))) / 2;
        const bool outside = solids[static_cast<std::size_t>(i)] < 2;
        if (outside && acts(v[0]) && acts(v[1]) && acts(v[2]) && area > tiny)
            facets[1].push_back(
                {v, area, area, {at(v[2]) - at(v[1]), at(v[0]) - at(v[2]), at(v[1]) - at(v[0])}});
    }
    for (int i = 0; i < world.complex.count(1); ++i) {
        const auto [a, b] = world.complex.edge(i);
        const double size = length(at(b) - at(a)), area = width * size;
        const bool alone = sheets[static_cast<std::size_t>(i)] == 0;
        if (alone && acts(a) && acts(b) && area > tiny)
            facets[0].push_back({{a, b, b}, size, area});
    }
    return facets;
}

std::vector<double> areaShares(const RestFacets& facets, int vertices) {
    std::vector<double> shares(static_cast<std::size_t>(vertices), 0.0);
    for (std::size_t kind = 0; kind < 2; ++kind)
        for (const RestFacet& facet : facets[kind])
            for (std::size_t c = 0; c < kind + 2; ++c)
                shares[static_cast<std::size_t>(facet.vertices[c])] +=
                    facet.area / static_cast<double>(kind + 2);
    return shares;
}

template <class Real>
AirSkin<Real>::AirSkin(int corners, const std::vector<RestFacet>& facets,
                       const std::vector<double>& shares, int padding)
    : corners_(corners) {
    const int members = 2 + corners, count = wholeBlocks(facets.size());
    const auto blocks = static_cast<std::size_t>(count);
    ids_.assign(blocks * static_cast<std::size_t>(corners), padding);
    rows_.assign(blocks * static_cast<std::size_t>(members), Real(0));
    sides.assign(blocks + 1, {});
    impulses = sides;
    for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
        const RestFacet& facet = facets[static_cast<std::size_t>(f)];
        rows_[slot(f, 0, members)] = static_cast<Real>(facet.area);
        rows_[slot(f, 1, members)] = static_cast<Real>(1 / facet.size);
        for (int c = 0; c < corners; ++c) {
            const int v = facet.vertices[static_cast<std::size_t>(c)];
            ids_[slot(f, c, corners)] = v;
            rows_[slot(f, 2 + c, members)] =
                static_cast<Real>(shares[static_cast<std::size_t>(v)] / corners);
        }
    }
    layOutAround(static_cast<int>(facets.size()), padding);
}

template <class Real>
void AirSkin<Real>::layOutAround(int facets, int padding) {
    std::vector<std::vector<int>> around(static_cast<std::size_t>(padding));
    for (int f = 0; f < facets; ++f)
        for (int c = 0; c < corners_; ++c)
            around[static_cast<std::size_t>(vertex(f, c))].push_back(f);
    for (std::size_t v = 0; v < around.size(); ++v)
        if (!around[v].empty()) vertices_.push_back(static_cast<int>(v));
    const std::size_t used = vertices_.size(), all = static_cast<std::size_t>(wholeBlocks(used));
    vertices_.resize(all, padding);
    for (std::size_t first = 0; first < all; first += blockSize) {
        const std::size_t last = std::min<std::size_t>(first + blockSize, used);
        std::size_t rows = 0;
        for (std::size_t i = first; i < last; ++i)
            rows = std::max(rows, around[static_cast<std::size_t>(vertices_[i])].size());
        const std::size_t base = around_.size();
        around_.resize(base + rows * blockSize, size());
        for (std::size_t i = first; i < last; ++i) {
            const std::vector<int>& list = around[static_cast<std::size_t>(vertices_[i])];
            for (std::size_t r = 0; r < list.size(); ++r)
                around_[base + r * blockSize + (i - first)] = list[r];
        }
        start_.push_back(start_.back() + static_cast<int>(rows));
    }
}

template <class Real>
void AirSkin<Real>::setGust(int facet, const Vec<double>& start, const Vec<double>& change) {
    const double numbers[] = {start.x, start.y, start.z, change.x, change.y, change.z};
    for (int m = 0; m < 6; ++m) gusts_[slot(facet, m, 6)] = static_cast<Real>(numbers[m]);
}

template <class Real>
FacetBlocks<Real> AirSkin<Real>::blocks() {
    return {ids_.data(), rows_.data(), gusts_.empty() ? nullptr : gusts_.data(), &sides[0].v.x,
            &impulses[0].v.x};
}

template <class Real>
AroundBlocks<Real> AirSkin<Real>::around() const {
    return {vertices_.data(), start_.data(), around_.data()};
}

template class AirSkin<float>;
template class AirSkin<double>;

}  // namespace plait
