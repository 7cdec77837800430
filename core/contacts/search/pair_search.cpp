#include "pair_search.h"

#include "../checks.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace plait {

namespace {

// By vertex, the rows of a table that it stands in.
Csr membersOf(std::span<const int> table, int arity, std::size_t vertices) {
    Csr members{.start = std::vector<int>(vertices + 1, 0), .item = std::vector<int>(table.size())};
    if (table.empty()) return {};
    for (const int v : table) ++members.start[std::size_t(v) + 1];
    std::partial_sum(members.start.begin(), members.start.end(), members.start.begin());
    std::vector<int> next(members.start.begin(), members.start.end() - 1);
    for (std::size_t i = 0; i < table.size(); ++i)
        members.item[next[table[i]]++] = static_cast<int>(i) / arity;
    return members;
}

}  // namespace

PairSearch::PairSearch(const SimplicialComplex& complex, std::vector<Surface> surfaces,
                       std::span<const unsigned char> pinned, double margin,
                       std::span<const int> whole)
    : surfaces_(std::move(surfaces)),
      surface_(complex.count(0), -1),
      thickness_(complex.count(0), 0),
      pinned_(pinned.begin(), pinned.end()),
      whole_(whole.begin(), whole.end()),
      margin_(margin) {
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
        const Surface& of = surfaces_[s];
        for (const int other : of.ignores) {
            ignored_.resize(surfaces_.size() * surfaces_.size());
            ignored_[s * surfaces_.size() + other] = ignored_[other * surfaces_.size() + s] = 1;
        }
        for (int v = of.vertices.first; v < of.vertices.last; ++v) {
            if (!whole_.empty() && whole_[v] < 0) continue;
            surface_[v] = static_cast<int>(s);
            thickness_[v] = thicknessAt(of, v);
            members_.push_back(v);
        }
    }
    for (auto& side : groups_)
        for (const auto& [kind, arity] : {std::pair{points, 1},
                                          {edges, 2},
                                          {triangles, 3},
                                          {curves, 2},
                                          {grains, 1},
                                          {balls, 1}})
            side[kind].arity = arity;
    addMatter(complex);
    for (auto& side : groups_)
        for (Group& group : side) group.around = membersOf(group.ids, group.arity, surface_.size());
    mayMeet(points, triangles, Self::vertexFace);
    mayMeet(edges, edges, Self::full);
    mayMeet(grains, triangles, Self::vertexFace);
    mayMeet(grains, curves, Self::vertexFace);
    mayMeet(grains, grains, Self::vertexFace);
    mayMeet(balls, balls, Self::vertex);
}

// But for what lies within: faces that two tetrahedra share, and their edges and corners that are
// of no other face (V) [CC19].
void PairSearch::addMatter(const SimplicialComplex& complex) {
    const std::vector<int> fans = complex.valences(0), wings = complex.valences(1),
                           cells = complex.valences(2);
    std::vector<bool> within(fans.size()), edgeWithin(wings.size());
    for (std::size_t v = 0; v < fans.size(); ++v) within[v] = fans[v] > 0;
    const Csr faces = complex.parents(1);
    for (int e = 0; e < complex.count(1); ++e) {
        edgeWithin[e] =
            wings[e] > 0 && std::ranges::all_of(faces[e], [&](int t) { return cells[t] > 1; });
        if (!edgeWithin[e])
            for (const int v : complex.vertices(1, e)) within[v] = false;
    }
    for (int v = 0; v < complex.count(0); ++v) {
        if (!within[v]) add(fans[v] ? points : grains, complex.vertices(0, v));
        if (surface_[v] >= 0 && surfaces_[surface_[v]].self == Self::vertex)
            add(balls, complex.vertices(0, v));
    }
    for (int e = 0; e < complex.count(1); ++e) {
        if (!edgeWithin[e]) add(edges, complex.vertices(1, e));
        if (!wings[e]) add(curves, complex.vertices(1, e));
    }
    for (int t = 0; t < complex.count(2); ++t)
        if (cells[t] < 2) add(triangles, complex.vertices(2, t));
}

bool PairSearch::hasRound() const {
    return std::ranges::any_of(
        groups_, [](const auto& side) { return side[grains].count() + side[balls].count() > 0; });
}

// A simplex belongs to the surface of all its vertices, and is pinned if they all are.
void PairSearch::add(Kind kind, std::span<const int> ids) {
    bool fixed = true;
    for (const int v : ids) {
        if (surface_[v] < 0 || surface_[v] != surface_[ids[0]]) return;
        fixed = fixed && pinned_[v];
    }
    std::vector<int>& table = groups_[fixed][kind].ids;
    table.insert(table.end(), ids.begin(), ids.end());
}

void PairSearch::mayMeet(Kind a, Kind b, Self self) {
    bool any = false;
    for (int s = 0; s < std::ssize(surfaces_) && !any; ++s)
        for (int t = 0; t < std::ssize(surfaces_) && !any; ++t) any = accepts(self, s, t);
    for (const auto& [i, j] : {std::pair{0, 0}, {0, 1}, {1, 0}}) {
        const Group &first = groups_[i][a], &second = groups_[j][b];
        if (!any || (a == b && i > j) || first.count() == 0 || second.count() == 0) continue;
        meetings_.push_back({.a = &first, .b = &second, .self = self, .found = {}});
    }
}

bool PairSearch::accepts(Self self, int surface, int other) const {
    if (!ignored_.empty() && ignored_[surface * surfaces_.size() + other]) return false;
    if (surface != other) return self != Self::vertex;
    const Self own = surfaces_[surface].self;
    return own >= self && (own == Self::vertex) == (self == Self::vertex);
}

// Meetings that no surfaces make are not there.
bool PairSearch::accepts(const Meeting& meeting, std::span<const int> a,
                         std::span<const int> b) const {
    for (const int v : a)
        for (const int u : b)
            if (whole_.empty() ? u == v : whole_[u] == whole_[v]) return false;
    return surfaces_.size() == 1 || accepts(meeting.self, surface_[a[0]], surface_[b[0]]);
}

// How far from a vertex its skin is at most, whatever it meets.
double PairSearch::reachOf(int vertex) const {
    const Surface& of = surfaces_[surface_[vertex]];
    return std::max(thickness_[vertex], of.halfWidth) *
           (of.self == Self::none ? 1 : std::max(1.0, of.selfWidth));
}

bool PairSearch::cover(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                       double slack, Workers& workers) {
    const bool same = known(start, end, workers) || redirect(start, end, slack, workers);
    if (!same) search(start, end, slack, workers);
    place(start, end, workers);
    follow(start, end, workers);
    return !same;
}

void PairSearch::place(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                       Workers& workers) {
    const auto spot = [](const Vec<double>& x) {
        return Spot{static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z), 0};
    };
    at_.resize(start.size());
    way_.resize(start.size());
    workers.forBlocks(static_cast<int>(members_.size()), 1024, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const int v = members_[i];
            at_[v] = spot(start[v] - start[0]);
            way_[v] = spot(end[v] - start[v]);
        }
    });
}

void PairSearch::follow(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                        Workers& workers) {
    strayed_.resize(from_.size());
    const Foreseen at = foreseen(passed_), next = foreseen(passed_ + 1);
    workers.forBlocks(static_cast<int>(members_.size()), 1024, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const int v = members_[i];
            const double strayed = std::max(length(start[v] - at(v)), length(end[v] - next(v)));
            strayed_[v] = static_cast<float>((1 + 1e-6) * strayed + 1e-12);
        }
    });
    for (auto& side : groups_)
        for (Group& group : side) {
            group.strayed.resize(static_cast<std::size_t>(group.count()));
            workers.forBlocks(group.count(), 1024, [&](int first, int last) {
                for (int i = first; i < last; ++i) group.strayed[i] = strayed(group.at(i));
            });
        }
}

float PairSearch::strayed(std::span<const int> ids) const {
    float most = 0;
    for (const int v : ids) most = std::max(most, strayed_[v]);
    return most;
}

// Which simplices have a corner that has moved.
void PairSearch::mark(std::span<const std::uint8_t> moved, Workers& workers) {
    for (auto& side : groups_)
        for (Group& group : side) {
            group.moved.resize(static_cast<std::size_t>(group.count()));
            workers.forBlocks(group.count(), 1024, [&](int first, int last) {
                for (int i = first; i < last; ++i) {
                    group.moved[i] = 0;
                    for (const int v : group.at(i)) group.moved[i] |= moved[v];
                }
            });
        }
}

// Adds parts of what was found by its bounds and is near enough.
void PairSearch::sift(Meeting& m, Workers& workers) {
    const auto pairs = m.found.pairs();
    const std::size_t before = m.kept.size();
    const int parts = static_cast<int>((pairs.size() + part - 1) / part);
    m.near.resize(before * part + pairs.size());
    m.kept.resize(before + static_cast<std::size_t>(parts));
    workers.forBlocks(parts, 1, [&](int begin, int end) {
        for (int b = begin; b < end; ++b) {
            const std::size_t first = std::size_t(b) * part;
            std::size_t to = before * part + first;
            const auto block =
                pairs.subspan(first, std::min(pairs.size() - first, std::size_t(part)));
            for (std::size_t i = 0; i < block.size(); i += 4) {
                std::array<Listed, 4> four;
                for (std::size_t k = 0; k < 4; ++k) {
                    const Candidate& c = block[std::min(i + k, block.size() - 1)];
                    four[k] = {c.a, c.b, 0};
                }
                const std::array<float, 4> apart = nearing(m, four);
                for (std::size_t k = 0; k < 4 && i + k < block.size(); ++k) {
                    if (apart[k] > m.a->reach[four[k].a] + m.b->reach[four[k].b]) continue;
                    m.near[to] = four[k];
                    m.near[to++].apart = apart[k];
                }
            }
            m.kept[before + b] = static_cast<int>(to - before * part - first);
        }
    });
}

FourPairs PairSearch::fourOf(const Meeting& m, std::span<const Listed, 4> four) {
    FourPairs pairs{{}, m.a->arity, m.b->arity};
    for (std::size_t lane = 0; lane < 4; ++lane) {
        std::size_t n = 0;
        for (const int v : m.a->at(four[lane].a)) pairs.vertices[n++][lane] = v;
        for (const int v : m.b->at(four[lane].b)) pairs.vertices[n++][lane] = v;
    }
    return pairs;
}

std::array<float, 4> PairSearch::nearing(const Meeting& m, std::span<const Listed, 4> four) const {
    const FourPairs pairs = fourOf(m, four);
    std::array<float, 4> apart = apartAtLeast(pairs, at_);
    const std::array<float, 4> less = goApart(pairs, way_);
    for (std::size_t i = 0; i < 4; ++i) apart[i] -= less[i];
    return apart;
}

PairSearch::Bounds PairSearch::boundsOf(std::span<const int> ids) const {
    auto bounds = Bounds::nothing();
    for (const int v : ids) bounds.include(swept_[v].bounds);
    return bounds;
}

void PairSearch::search(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                        double slack, Workers& workers) {
    for (auto* const x : {&from_, &to_, &due_}) x->resize(start.size());
    swept_.resize(start.size());
    astray_.resize(start.size());
    origin_ = start[0];
    passed_ = 0;
    redirected_ = 0;
    moved_ = {};
    workers.forBlocks(static_cast<int>(members_.size()), 256, [&](int first, int last) {
        for (int i = first; i < last; ++i) {
            const int v = members_[i];
            foresee(v, start[v], start[v] + double(foresight) * (end[v] - start[v]), slack);
        }
    });
    place(from_, to_, workers);
    for (auto& side : groups_)
        for (Group& group : side) {
            if (group.count() == 0) continue;
            group.reach.resize(static_cast<std::size_t>(group.count()));
            const auto bound = [&](int i) {
                float reach = 0;
                for (const int v : group.at(i)) reach = std::max(reach, swept_[v].reach);
                group.reach[i] = reach;
                return boundsOf(group.at(i));
            };
            if (group.tree)
                group.tree->refit(bound, workers);
            else
                group.tree = std::make_unique<Tree>(group.count(), bound, workers);
        }
    for (Meeting& m : meetings_) {
        const auto accept = [&](int i, int j) { return accepts(m, m.a->at(i), m.b->at(j)); };
        if (m.a == m.b)
            m.a->tree->selfPairs(m.found, workers, accept);
        else
            m.a->tree->pairs(*m.b->tree, m.found, workers, accept);
        m.kept.clear();
        sift(m, workers);
    }
}

Pairing PairSearch::pairing(const Meeting& meeting, const Listed& listed) {
    const auto a = meeting.a->at(listed.a), b = meeting.b->at(listed.b);
    Pairing pair{{}, meeting.a->arity, meeting.b->arity};
    int n = 0;
    for (const int v : a) pair.vertices[n++] = v;
    for (const int v : b) pair.vertices[n++] = v;
    for (; n < 4; ++n) pair.vertices[n] = b.back();
    return pair;
}

long PairSearch::size() const {
    long sum = 0;
    for (const Meeting& m : meetings_)
        for (const int kept : m.kept) sum += kept;
    return sum;
}

}  // namespace plait
