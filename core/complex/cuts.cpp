#include "cuts.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace plait {

Cuts::Cuts(SimplicialComplex whole, std::vector<Tearable> tearable,
           std::span<const unsigned char> held)
    : whole_(std::move(whole)),
      tearable_(std::move(tearable)),
      held_(held.begin(), held.end()),
      cut_(static_cast<std::size_t>(whole_.count(1))),
      parted_(static_cast<std::size_t>(whole_.count(0))),
      original_(static_cast<std::size_t>(whole_.count(0))),
      region_(original_.size(), -1),
      apart_(original_.size()),
      wings_(whole_.parents(1)) {
    std::iota(original_.begin(), original_.end(), 0);
    std::vector<std::vector<int>> around(original_.size());
    for (int t = 0; t < whole_.count(2); ++t)
        for (const int v : whole_.vertices(2, t)) {
            corners_.push_back(v);
            around[v].push_back(t);
        }
    for (const auto& triangles : around) {
        around_.item.insert(around_.item.end(), triangles.begin(), triangles.end());
        around_.start.push_back(static_cast<int>(around_.item.size()));
    }
    for (std::size_t r = 0; r < tearable_.size(); ++r) {
        const Range& matter = tearable_[r].matter;
        std::fill(region_.begin() + matter.first, region_.begin() + matter.last,
                  static_cast<int>(r));
        next_.push_back(tearable_[r].spare.first);
    }
}

bool Cuts::cut(int edge) {
    const auto ends = whole_.vertices(1, edge);
    const int region = region_[ends[0]];
    if (isCut(edge) || wings_[edge].size() < 2 || region < 0 || region != region_[ends[1]])
        return false;
    cut_[edge] = 1;
    const int lacking = part(ends[0], edge, false) + part(ends[1], edge, false);
    if (next_[region] + lacking > tearable_[region].spare.last) {
        cut_[edge] = 0;
        return false;
    }
    for (const int v : ends) part(v, edge, true);
    order_.push_back(edge);
    return true;
}

std::vector<std::vector<int>> Cuts::fansOf(int vertex) const {
    const auto triangles = around_[vertex];
    std::vector<std::vector<int>> fans;
    std::vector<bool> taken(triangles.size());
    const auto place = [&](int t) { return std::ranges::find(triangles, t) - triangles.begin(); };
    for (std::size_t first = 0; first < triangles.size(); ++first) {
        if (taken[first]) continue;
        taken[first] = true;
        std::vector<int> fan{triangles[first]};
        for (std::size_t i = 0; i < fan.size(); ++i)
            for (const int e : whole_.faces(2, fan[i])) {
                const auto ends = whole_.vertices(1, e);
                if (isCut(e) || (ends[0] != vertex && ends[1] != vertex)) continue;
                for (const int t : wings_[e])
                    if (!taken[place(t)]) {
                        taken[place(t)] = true;
                        fan.push_back(t);
                    }
            }
        std::ranges::sort(fan);
        fans.push_back(std::move(fan));
    }
    return fans;
}

int Cuts::nameIn(int triangle, int vertex) const {
    const auto whole = whole_.vertices(2, triangle);
    return corners(triangle)[std::ranges::find(whole, vertex) - whole.begin()];
}

void Cuts::rename(int triangle, int vertex, int copy) {
    const auto whole = whole_.vertices(2, triangle);
    corners_[3L * triangle + (std::ranges::find(whole, vertex) - whole.begin())] = copy;
}

// Fans come by their lowest triangles: the first of a name keeps it.
int Cuts::part(int vertex, int edge, bool make) {
    if (held_[vertex]) return 0;
    std::vector<int> kept;
    int copies = 0;
    for (const std::vector<int>& fan : fansOf(vertex)) {
        const int name = nameIn(fan[0], vertex);
        if (std::ranges::find(kept, name) == kept.end()) {
            kept.push_back(name);
            continue;
        }
        ++copies;
        if (!make) continue;
        const int copy = next_[region_[vertex]]++;
        original_[copy] = vertex;
        apart_[vertex] = 1;
        splits_.push_back({name, copy, edge});
        for (const int t : fan) rename(t, vertex, copy);
    }
    return copies;
}

bool Cuts::rename(std::span<int> stencil) const {
    if (stencil.size() < 2 || std::ranges::none_of(stencil, [&](int v) { return apart_[v]; }))
        return true;
    const std::vector<int> whole(stencil.begin(), stencil.end());
    const auto among = [](int v, std::span<const int> these) {
        return std::ranges::find(these, v) != these.end();
    };
    const auto says = [&](int t) {
        const auto corners = whole_.vertices(2, t);
        const bool few = whole.size() < 3;
        return few ? among(whole[0], corners) && among(whole[1], corners)
                   : std::ranges::all_of(corners, [&](int v) { return among(v, whole); });
    };
    for (std::size_t i = 0; i < whole.size(); ++i) {
        int name = -1;
        for (const int t : around_[whole[i]]) {
            if (!says(t)) continue;
            const int here = nameIn(t, whole[i]);
            if (name >= 0 && here != name) return false;
            name = here;
        }
        if (name < 0 && apart_[whole[i]]) return false;
        if (name >= 0) stencil[i] = name;
    }
    return true;
}

SimplicialComplex Cuts::torn() const {
    Simplices given;
    for (int e = 0; e < whole_.count(1); ++e)
        if (wings_[e].empty()) given.edges.push_back(whole_.edge(e));
    for (int t = 0; t < whole_.count(2); ++t) {
        std::array<int, 3> corners = whole_.triangle(t);
        for (int& v : corners) v = nameIn(t, v);
        given.triangles.push_back(corners);
    }
    for (int t = 0; t < whole_.count(3); ++t) given.tetrahedra.push_back(whole_.tetrahedron(t));
    return SimplicialComplex(whole_.count(0), given);
}

}  // namespace plait
