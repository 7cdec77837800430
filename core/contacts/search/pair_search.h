// Which pairs of simplices are near enough to meet in a step. A list that is made once in a while
// and holds all that will come near until something has moved further than a margin.
#pragma once

#include "../../collision/candidates.h"
#include "../../collision/kdop_tree.h"
#include "../../complex/complex.h"
#include "../surface.h"
#include "apart.h"
#include "nearest.h"
#include "rigid.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace plait {

class PairSearch {
public:
    // What is pinned meets only what is not. `whole`, by vertex, of what may come apart: the vertex
    // that it is a copy of, or itself; -1 where it is not there; empty: nothing may. What shared a
    // vertex once does not meet, since it parts in one place.
    PairSearch(const SimplicialComplex& complex, std::vector<Surface> surfaces,
               std::span<const unsigned char> pinned, double margin,
               std::span<const int> whole = {});

    // Makes sure the list holds every pair that comes as near as its thicknesses and `slack` while
    // all vertices move from start to end (m, by vertex). When pairs are looked for, all are
    // foreseen to go on like this for some substeps, and then to stay. A vertex that has left the
    // margin round where it should be by now, moved as rigidly as all have since, is foreseen anew,
    // and its pairs are looked for again; where many have, all are: then true.
    bool cover(std::span<const Vec<double>> start, std::span<const Vec<double>> end, double slack,
               Workers& workers);

    // Calls visit(pair, list) for all pairs that may have come within `reach` (m, at most the
    // largest thickness twice, as wide as it counts, and the slack) between the start and end last
    // covered, in parts that are the same for any number of threads. How many it leaves out depends
    // on when pairs were looked for: visit must decide for itself. Given `moved` (by vertex), pairs
    // are left out of which no vertex has moved.
    template <class Item, class Visit>
    void collect(std::vector<std::vector<Item>>& parts, double reach, Workers& workers,
                 const Visit& visit, std::span<const std::uint8_t> moved = {});

    // All pairs that come as near as cover() has it, of simplices with one of these vertices, which
    // go elsewhere than it was told: from start to end, while the others end within half of `slack`
    // of where it was told. Far less work than to cover that as well, for a few. None: it cannot
    // tell.
    std::optional<std::vector<Pairing>> around(std::span<const int> vertices,
                                               std::span<const Vec<double>> start,
                                               std::span<const Vec<double>> end, double slack,
                                               Workers& workers);

    long size() const;  // pairs in the list
    const std::vector<Surface>& surfaces() const { return surfaces_; }
    // By vertex: place in surfaces(), -1 of none; and thickness, m.
    int surfaceOf(int vertex) const { return surface_[static_cast<std::size_t>(vertex)]; }
    double thickness(int vertex) const { return thickness_[static_cast<std::size_t>(vertex)]; }
    // Whether any pair is of what has no inside and no side: a particle and another or a curve.
    bool hasRound() const;
    // How often the thicknesses of two vertices count that meet each other.
    double width(int a, int b) const {
        return surfaceOf(a) == surfaceOf(b) ? surfaces_[std::size_t(surfaceOf(a))].selfWidth : 1;
    }

private:
    static constexpr int part = 2048;    // pairs to a part
    static constexpr int foresight = 4;  // substeps; what is longer ahead comes otherwise
    static constexpr int slabs = 6;
    using Bounds = MovingKDop<slabs>;
    using Tree = BoundsTree<Bounds>;

    // Simplices of one dimension, a table of `arity` vertices each, in a tree of their own.
    struct Group {
        int arity = 1;
        std::vector<int> ids;
        std::unique_ptr<Tree> tree{};
        std::vector<float> strayed{};  // m: how far each is off the way foreseen, at most
        std::vector<float> reach{};    // m: how near others must come to be listed with each
        Csr around{};                  // by vertex, those that have it
        std::vector<std::uint8_t> isAstray{};  // 1: a corner is
        std::vector<std::uint8_t> moved{};     // 1: a corner has
        std::vector<int> astray{};             // those
        int count() const { return static_cast<int>(ids.size()) / arity; }
        std::span<const int> at(int i) const {
            return std::span(ids).subspan(std::size_t(i) * arity, arity);
        }
    };
    enum Kind { points, edges, triangles, curves, grains, balls, kinds };
    struct Listed {
        int a, b;
        float apart;  // m, at least, on the way foreseen when pairs were looked for
    };
    // Two groups whose members may meet, and those that are near enough.
    struct Meeting {
        const Group *a, *b;
        Self self;                   // the least mode in which two of one surface do; balls do in
                                     // no other
        Candidates found;            // by their bounds
        std::vector<Listed> near{};  // of every part of those the first `kept`
        std::vector<int> kept{};     // by part
    };

    void addMatter(const SimplicialComplex& complex);
    void add(Kind kind, std::span<const int> ids);
    void mayMeet(Kind a, Kind b, Self self);
    bool accepts(const Meeting& meeting, std::span<const int> a, std::span<const int> b) const;
    bool accepts(Self self, int surface, int other) const;
    double reachOf(int vertex) const;
    // Where vertices were to be so many substeps after pairs were looked for.
    struct Foreseen {
        const PairSearch& search;
        double share;
        Vec<double> operator()(int v) const {
            const Vec<double>& from = search.from_[v];
            const Vec<double> at = from + share * (search.to_[v] - from);
            return search.moved_.isNone ? at : search.moved_(at);
        }
    };
    Foreseen foreseen(int substeps) const {
        return {*this, double(std::min(substeps, foresight)) / foresight};
    }
    long findAstray(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                    Workers& workers);
    bool known(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
               Workers& workers);
    void foresee(int vertex, const Vec<double>& from, const Vec<double>& to, double slack);
    bool redirect(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                  double slack, Workers& workers);
    bool foreseeAstray(std::span<const int> vertices, std::span<const Vec<double>> start,
                       std::span<const Vec<double>> end, double slack);
    void gatherAstray(std::span<const int> vertices);
    Bounds boundsOf(std::span<const int> ids) const;
    void dropAstray(Meeting& meeting, Workers& workers) const;
    void findAnew(Meeting& meeting, Workers& workers);
    void findAround(Meeting& meeting, Workers& workers);
    void search(std::span<const Vec<double>> start, std::span<const Vec<double>> end, double slack,
                Workers& workers);
    void sift(Meeting& meeting, Workers& workers);
    static FourPairs fourOf(const Meeting& meeting, std::span<const Listed, 4> four);
    // How far apart they are at least on their way to where they are heading, m.
    std::array<float, 4> nearing(const Meeting& meeting, std::span<const Listed, 4> four) const;
    float strayed(std::span<const int> ids) const;
    void mark(std::span<const std::uint8_t> moved, Workers& workers);
    void place(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
               Workers& workers);
    void follow(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                Workers& workers);
    static Pairing pairing(const Meeting& meeting, const Listed& listed);

    std::vector<Surface> surfaces_;
    std::vector<std::uint8_t> ignored_;  // by two surfaces, 1 where they meet not; empty: all do
    std::vector<int> surface_;
    std::vector<double> thickness_;
    std::vector<unsigned char> pinned_;
    std::vector<int> whole_;
    std::vector<int> members_;  // vertices of all surfaces
    double margin_;             // m
    Group groups_[2][kinds];    // what moves, and what is pinned throughout
    std::vector<Meeting> meetings_;
    // Where the vertices were when pairs were last looked for, and where they were to be after
    // `foresight` substeps; how many have passed, at most all of these, and how all have moved
    // rigidly against that.
    std::vector<Vec<double>> from_, to_, due_;
    int passed_ = 0;
    long redirected_ = 0;  // what that cost since all pairs were looked for, in vertices
    Rigid moved_;
    std::vector<std::uint8_t> astray_;  // by vertex: 1 where it was not to be
    Vec<double> origin_{};              // of bounds, m
    struct Swept {
        Bounds bounds;
        float reach;  // m, beyond its way
    };
    std::vector<Swept> swept_;    // by vertex
    std::vector<float> strayed_;  // m, of each from that way, at either end, rounded up
    std::vector<Spot> at_,
        way_;  // of the start last covered, from the first vertex's; and to its end
};

template <class Item, class Visit>
void PairSearch::collect(std::vector<std::vector<Item>>& parts, double reach, Workers& workers,
                         const Visit& visit, std::span<const std::uint8_t> moved) {
    const bool all = moved.empty();
    if (!all) mark(moved, workers);
    std::size_t count = 0;
    for (const Meeting& m : meetings_) {
        const std::size_t blocks = m.kept.size();
        if (parts.size() < count + blocks) parts.resize(count + blocks);
        workers.forBlocks(static_cast<int>(blocks), 1, [&](int begin, int end) {
            for (int b = begin; b < end; ++b) {
                std::vector<Item> list = std::move(parts[count + b]);
                list.clear();
                std::array<Listed, 4> four{};
                int waiting = 0;
                const auto ask = [&] {
                    std::fill(four.begin() + waiting, four.end(), four[0]);
                    const std::array<float, 4> gap = nearing(m, four);
                    for (int i = 0; i < waiting; ++i)
                        if (!(gap[i] > static_cast<float>(reach))) visit(pairing(m, four[i]), list);
                    waiting = 0;
                };
                for (const Listed& l :
                     std::span(m.near).subspan(std::size_t(b) * part, m.kept[b])) {
                    if (!all && !m.a->moved[l.a] && !m.b->moved[l.b]) continue;
                    const float way = m.a->strayed[l.a] + m.b->strayed[l.b];
                    if (l.apart > way + static_cast<float>(reach)) continue;
                    four[waiting++] = l;
                    if (waiting == 4) ask();
                }
                if (waiting > 0) ask();
                parts[count + b] = std::move(list);
            }
        });
        count += blocks;
    }
    for (std::size_t i = count; i < parts.size(); ++i) parts[i].clear();
}

}  // namespace plait
