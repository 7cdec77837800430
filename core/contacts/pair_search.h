// Which pairs of simplices are near enough to meet in a step. A list that is made once in a while
// and holds all that will come near until something has moved further than a margin.
#pragma once

#include "../collision/candidates.h"
#include "../collision/kdop_tree.h"
#include "../complex.h"
#include "nearest.h"
#include "rigid.h"
#include "surface.h"

#include <memory>
#include <span>
#include <vector>

namespace plait {

class PairSearch {
public:
    // What is pinned meets only what is not.
    PairSearch(const SimplicialComplex& complex, std::vector<Surface> surfaces,
               std::span<const unsigned char> pinned, double margin);

    // Makes sure the list holds every pair that comes as near as its thicknesses and `slack` while
    // all vertices move from start to end (m, by vertex). Looks for pairs only where a vertex has
    // left the margin round where it was, or was heading for, when they were last looked for, moved
    // as rigidly as all have since; true if it did.
    bool cover(std::span<const Vec<double>> start, std::span<const Vec<double>> end, double slack,
               Workers& workers);

    // Calls visit(pair, list) for all pairs that may have come within `reach` (m, at most the
    // largest thickness twice and the slack) between the start and end last covered, in parts that
    // are the same for any number of threads. How many it leaves out depends on when pairs were
    // looked for: visit must decide for itself.
    template <class Item, class Visit>
    void collect(std::vector<std::vector<Item>>& parts, double reach, Workers& workers,
                 const Visit& visit) const;

    long size() const;  // pairs in the list
    const std::vector<Surface>& surfaces() const { return surfaces_; }
    // By vertex: place in surfaces(), -1 of none; and thickness, m.
    int surfaceOf(int vertex) const { return surface_[static_cast<std::size_t>(vertex)]; }
    double thickness(int vertex) const { return thickness_[static_cast<std::size_t>(vertex)]; }

private:
    static constexpr int slabs = 6;

    // Simplices of one dimension, a table of `arity` vertices each, in a tree of their own.
    struct Group {
        int arity = 1;
        std::vector<int> ids;
        std::unique_ptr<KDopTree<slabs>> tree{};
        std::vector<float> strayed{};  // m: by how much each may have come nearer to others
        int count() const { return static_cast<int>(ids.size()) / arity; }
        std::span<const int> at(int i) const {
            return std::span(ids).subspan(std::size_t(i) * arity, arity);
        }
    };
    enum Kind { points, edges, triangles, curves, grains, kinds };
    // Two groups whose members may meet, and which do.
    struct Meeting {
        const Group *a, *b;
        Candidates found;
        std::vector<float> apart{};  // m, by pair, when it was found; rounded down
    };

    void add(Kind kind, std::span<const int> ids);
    void mayMeet(Kind a, Kind b);
    bool accepts(std::span<const int> a, std::span<const int> b) const;
    bool inside(std::span<const Vec<double>> at, const Rigid& moved, Workers& workers) const;
    bool known(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
               Workers& workers);
    void search(std::span<const Vec<double>> start, std::span<const Vec<double>> end, double slack,
                Workers& workers);
    void measure(Workers& workers);
    float strayed(std::span<const int> ids) const;
    void follow(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                Workers& workers);
    static Pairing pairing(const Meeting& meeting, const Candidate& candidate);

    std::vector<Surface> surfaces_;
    std::vector<int> surface_;
    std::vector<double> thickness_;
    std::vector<unsigned char> pinned_;
    std::vector<int> members_;  // vertices of all surfaces
    double margin_, used_ = 0;  // m: at most, and now, by how fast things are
    Group groups_[2][kinds];    // what moves, and what is pinned throughout
    std::vector<Meeting> meetings_;
    // Where the vertices were, and were heading for, when pairs were last looked for, and how all
    // of them have moved since.
    std::vector<Vec<double>> from_, to_;
    Rigid moved_;
    // How far each has strayed since, against that motion, and how far it goes from there at
    // most; m, rounded up.
    struct Stray {
        float start, way;
    };
    std::vector<Stray> strayed_;
};

template <class Item, class Visit>
void PairSearch::collect(std::vector<std::vector<Item>>& parts, double reach, Workers& workers,
                         const Visit& visit) const {
    constexpr int part = 2048;
    std::size_t count = 0;
    for (const Meeting& m : meetings_) {
        const auto pairs = m.found.pairs();
        const int blocks = (static_cast<int>(pairs.size()) + part - 1) / part;
        if (parts.size() < count + blocks) parts.resize(count + blocks);
        workers.forBlocks(blocks, 1, [&](int begin, int end) {
            for (int b = begin; b < end; ++b) {
                std::vector<Item> list = std::move(parts[count + b]);
                list.clear();
                const std::size_t last = std::min(pairs.size(), std::size_t(b + 1) * part);
                for (std::size_t i = std::size_t(b) * part; i < last; ++i) {
                    const float way = m.a->strayed[pairs[i].a] + m.b->strayed[pairs[i].b];
                    if (m.apart[i] <= way + static_cast<float>(reach))
                        visit(pairing(m, pairs[i]), list);
                }
                parts[count + b] = std::move(list);
            }
        });
        count += blocks;
    }
    for (std::size_t i = count; i < parts.size(); ++i) parts[i].clear();
}

}  // namespace plait
