#include "geodesics.h"

#include "../../numbers/arctangent.h"
#include "light.h"

#include <algorithm>
#include <array>

namespace plait {
namespace {

constexpr double flat = 1e-6;  // rad that the angles around a vertex may miss

Csr listsOf(int count, std::span<const std::array<int, 2>> pairs) {
    Csr lists;
    lists.start.assign(static_cast<std::size_t>(count) + 1, 0);
    for (const auto& [list, item] : pairs) ++lists.start[list + 1];
    for (int i = 0; i < count; ++i) lists.start[i + 1] += lists.start[i];
    lists.item.resize(pairs.size());
    std::vector<int> end(lists.start.begin(), lists.start.end() - 1);
    for (const auto& [list, item] : pairs) lists.item[end[list]++] = item;
    return lists;
}

}  // namespace

Geodesics::Geodesics(const SimplicialComplex& complex, Range range,
                     std::span<const Vec<double>> rest)
    : stepsOf_(complex.count(1), -1), bends_(rest.size(), false) {
    const int vertices = complex.count(0);
    const auto inside = [&](std::span<const int> simplex) {
        return std::all_of(simplex.begin(), simplex.end(),
                           [&](int v) { return v >= range.first && v < range.last; });
    };
    std::vector<std::array<int, 2>> ends, apexes, across, sides;
    std::vector<double> angle(rest.size(), 0);
    for (int t = 0; t < complex.count(2); ++t) {
        const std::span<const int> v = complex.vertices(2, t);
        if (!inside(v)) continue;
        for (int j = 0; j < 3; ++j) {
            const int from = v[(j + 1) % 3], to = v[(j + 2) % 3], apex = v[j];
            const Vec<double> side = rest[to] - rest[from], out = rest[apex] - rest[from];
            const double l = length(side);
            const int entry = static_cast<int>(entries_.size());
            entries_.push_back({from,
                                to,
                                apex,
                                l,
                                {divide(dot(out, side), l), divide(length(cross(side, out)), l)}});
            apexes.push_back({apex, entry});
            sides.push_back({complex.faces(2, t)[j], entry});
            const Vec<double> a = rest[from] - rest[apex], b = rest[to] - rest[apex];
            angle[apex] += arctangent2(length(cross(a, b)), dot(a, b));
        }
    }
    sides_ = listsOf(complex.count(1), sides);
    taken_.assign(entries_.size() / 3, false);
    std::vector<int> rim(rest.size(), 0);  // edges
    for (int e = 0; e < complex.count(1); ++e) {
        const std::span<const int> v = complex.vertices(1, e);
        if (!inside(v)) continue;
        stepsOf_[e] = static_cast<int>(steps_.size());
        for (const int end : {0, 1}) {
            ends.push_back({v[end], static_cast<int>(steps_.size())});
            steps_.push_back({v[1 - end], length(rest[v[1]] - rest[v[0]])});
            // A thread, or a seam of three sheets and more: no angle says how ways run there.
            if (sides_[e].empty() || sides_[e].size() > 2) bends_[v[end]] = true;
            if (sides_[e].size() == 1) ++rim[v[end]];
        }
        if (sides_[e].size() != 2) continue;
        across.push_back({sides_[e][0], sides_[e][1]});
        across.push_back({sides_[e][1], sides_[e][0]});
    }
    for (std::size_t v = 0; v < rest.size(); ++v)
        if (angle[v] > (rim[v] ? pi : 2 * pi) + flat || rim[v] > 2) bends_[v] = true;
    corners_ = listsOf(vertices, apexes);
    beyond_ = listsOf(static_cast<int>(entries_.size()), across);
    edges_ = listsOf(vertices, ends);
}

std::vector<Geodesics::Way> Geodesics::from(std::span<const int> sources) const {
    return Light(*this, sources).ways();
}

Geodesics::Cut Geodesics::cutOf(std::span<const int> edges) const {
    Cut cut;
    for (const int e : edges) {
        if (stepsOf_[e] < 0 || steps_[stepsOf_[e]].length == infinity) continue;
        cut.edges.push_back(e);
        for (const int entry : sides_[e])
            if (!taken_[entry / 3]) cut.triangles.push_back(entry / 3);
    }
    for (std::vector<int>* list : {&cut.edges, &cut.triangles}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return cut;
}

void Geodesics::take(const Cut& cut) {
    for (const int e : cut.edges)
        for (const int side : {0, 1}) {
            Step& step = steps_[stepsOf_[e] + side];
            step.length = infinity;
            bends_[step.vertex] = true;
        }
    for (const int t : cut.triangles) {
        taken_[t] = true;
        for (const int entry : {3 * t, 3 * t + 1, 3 * t + 2}) bends_[entries_[entry].apex] = true;
    }
}

}  // namespace plait
