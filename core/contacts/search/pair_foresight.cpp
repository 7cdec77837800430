// Where vertices are to be: whether they are there, and what is done about the few that are not.
// They are foreseen anew, and their pairs looked for again.
#include "pair_search.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace plait {

// Which vertices are not where they were to be; how many.
long PairSearch::findAstray(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                            Workers& workers) {
    const Foreseen at = foreseen(passed_), next = foreseen(passed_ + 1);
    const double most = margin_ * margin_;
    std::atomic<long> sum{0};
    workers.forBlocks(static_cast<int>(members_.size()), 1024, [&](int first, int last) {
        long count = 0;
        for (int i = first; i < last; ++i) {
            const int v = members_[i];
            const Vec<double> a = start[v] - at(v), b = end[v] - next(v);
            astray_[v] = !(dot(a, a) <= most && dot(b, b) <= most);
            count += astray_[v];
        }
        sum += count;
    });
    return sum;
}

// Bounds of a vertex where it is and where it is to be: those of a simplex are all of its
// vertices'. A thousandth wider, since impacts may be told a little early.
void PairSearch::foresee(int v, const Vec<double>& from, const Vec<double>& to, double slack) {
    from_[v] = from;
    to_[v] = to;
    const double radius = 1.001 * (reachOf(v) + 0.5 * slack + margin_);
    const auto boundsAt = [&](const std::vector<Vec<double>>& x) {
        return sweptBounds<slabs>(std::span(&v, 1), {x, x, radius, origin_});
    };
    swept_[v] = {{boundsAt(from_), boundsAt(to_)}, static_cast<float>((1 + 1e-6) * radius + 1e-12)};
}

// All must be where they were to be at one and the same time, in the next substep, in this one, or
// once all stay: of two of which one is on its way and the other was stopped nothing is known.
// Distances are the same after any rigid motion, so any serves; what stands on a wide floor may
// stay within the margin of none. If it is none of these, one that fits most, or nearly all, is
// left.
bool PairSearch::known(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                       Workers& workers) {
    if (from_.empty()) return false;
    long fewest = std::ssize(members_) + 1;
    int passed = 0;
    Rigid moved;
    const auto fits = [&] {
        const long count = findAstray(start, end, workers);
        if (count < fewest) fewest = count, passed = passed_, moved = moved_;
        return 16 * fewest <= std::ssize(members_);
    };
    for (const int time : {passed_ + 1, passed_, foresight}) {
        passed_ = std::min(time, foresight);
        moved_ = {};
        if (fits()) break;
        workers.forBlocks(static_cast<int>(members_.size()), 1024, [&](int first, int last) {
            const Foreseen at = foreseen(passed_);
            for (int i = first; i < last; ++i) due_[members_[i]] = at(members_[i]);
        });
        moved_ = rigidMotion(due_, start, members_);
        if (fits()) break;
    }
    passed_ = passed;
    moved_ = moved;
    return fewest == 0;
}

// False, and nothing is known any more, where one cannot be foreseen, or where this would by now
// have cost as much as looking for all pairs.
bool PairSearch::redirect(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                          double slack, Workers& workers) {
    if (from_.empty()) return false;
    // In vertices, as measured on sheets of 16,000: each time as many as this, and those that are
    // astray. Looking for all pairs costs as much as an eighth to a quarter of the vertices.
    const long all = std::ssize(members_);
    redirected_ += findAstray(start, end, workers) + all / 256;
    if (4 * redirected_ > all) return false;
    std::vector<int> astray;
    for (const int v : members_)
        if (astray_[v]) astray.push_back(v);
    if (!foreseeAstray(astray, start, end, slack)) return false;
    place(from_, to_, workers);
    gatherAstray(astray);
    for (auto& side : groups_)
        for (Group& group : side)
            if (!group.astray.empty())
                group.tree->refit(
                    group.astray, [&](int i) { return boundsOf(group.at(i)); }, workers);
    for (Meeting& m : meetings_) {
        if (m.a->astray.empty() && m.b->astray.empty()) continue;
        dropAstray(m, workers);
        findAnew(m, workers);
    }
    return true;
}

// Which simplices have a corner among these.
void PairSearch::gatherAstray(std::span<const int> vertices) {
    for (auto& side : groups_)
        for (Group& group : side) {
            group.isAstray.resize(static_cast<std::size_t>(group.count()));
            for (const int i : group.astray) group.isAstray[i] = 0;
            group.astray.clear();
            if (group.count() == 0) continue;
            for (const int v : vertices)
                for (const int i : group.around[v])
                    if (!std::exchange(group.isAstray[i], std::uint8_t{1}))
                        group.astray.push_back(i);
        }
}

// On straight ways that have them where they are now at the time that has passed. Once all stay,
// one that does not stray from its middle may stay as well.
bool PairSearch::foreseeAstray(std::span<const int> vertices, std::span<const Vec<double>> start,
                               std::span<const Vec<double>> end, double slack) {
    for (const int v : vertices) {
        const Vec<double> a = moved_.back(start[v]), b = moved_.back(end[v]), way = b - a;
        if (passed_ < foresight) {
            foresee(v, a - double(passed_) * way, a + double(foresight - passed_) * way, slack);
            continue;
        }
        if (!(length(way) < 1.9 * margin_)) return false;
        foresee(v, a + 0.5 * way, a + 0.5 * way, slack);
    }
    return true;
}

// They are foreseen for this once, and asked of trees that have them elsewhere: among each other,
// all with all. Once all others stay, they are at the end of their ways: what is clear of them
// there, and was on the same side of where they came from, is told from where it is by bounds of
// its way.
std::optional<std::vector<Pairing>> PairSearch::around(std::span<const int> vertices,
                                                       std::span<const Vec<double>> start,
                                                       std::span<const Vec<double>> end,
                                                       double slack, Workers& workers) {
    if (from_.empty() || !(margin_ >= 0.5 * slack)) return {};
    struct Was {
        Vec<double> from, to;
        Swept swept;
    };
    std::vector<Was> was;
    for (const int v : vertices) {
        was.push_back({from_[v], to_[v], swept_[v]});
        const Vec<double> a = moved_.back(start[v]), b = moved_.back(end[v]), way = b - a;
        if (passed_ < foresight) {
            foresee(v, a - double(passed_) * way, a + double(foresight - passed_) * way, slack);
            continue;
        }
        foresee(v, a, b, slack);
        Bounds& bounds = swept_[v].bounds;
        bounds.start.include(bounds.end);
        bounds.end = bounds.start;
    }
    gatherAstray(vertices);
    std::vector<Pairing> found;
    for (Meeting& m : meetings_) {
        findAround(m, workers);
        for (const Candidate& c : m.found.pairs()) found.push_back(pairing(m, {c.a, c.b, 0}));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const int v = vertices[i];
        from_[v] = was[i].from, to_[v] = was[i].to, swept_[v] = was[i].swept;
    }
    return found;
}

void PairSearch::findAround(Meeting& m, Workers& workers) {
    m.found.collect(1, workers, [&](int, Candidates::List& list) {
        const auto add = [&](int a, int b) {
            if (m.a == m.b && b < a) std::swap(a, b);
            if (accepts(m, m.a->at(a), m.b->at(b))) list.push_back({a, b});
        };
        for (const int i : m.a->astray) {
            const Bounds bounds = boundsOf(m.a->at(i));
            m.b->tree->overlapping(bounds, [&](int j) {
                if (!m.b->isAstray[j]) add(i, j);
            });
            for (const int j : m.b->astray)
                if ((m.a != m.b || i < j) && boundsOf(m.b->at(j)).overlaps(bounds)) add(i, j);
        }
        if (m.a == m.b) return;
        for (const int j : m.b->astray)
            m.a->tree->overlapping(boundsOf(m.b->at(j)), [&](int i) {
                if (!m.a->isAstray[i]) add(i, j);
            });
    });
}

void PairSearch::dropAstray(Meeting& m, Workers& workers) const {
    workers.forBlocks(static_cast<int>(m.kept.size()), 4, [&](int begin, int end) {
        for (int b = begin; b < end; ++b) {
            const auto first = m.near.begin() + std::ptrdiff_t(b) * part;
            const auto last = std::remove_if(first, first + m.kept[b], [&](const Listed& l) {
                return m.a->isAstray[l.a] || m.b->isAstray[l.b];
            });
            m.kept[b] = static_cast<int>(last - first);
        }
    });
}

// Each pair once: of two that are astray, that of the first.
void PairSearch::findAnew(Meeting& m, Workers& workers) {
    constexpr int block = 64;  // simplices to a part
    const int firsts = static_cast<int>(m.a->astray.size()),
              all = m.a == m.b ? firsts : firsts + static_cast<int>(m.b->astray.size());
    const auto of = [&](int n, Candidates::List& list) {
        const bool isFirst = n < firsts;
        const Group& own = isFirst ? *m.a : *m.b;
        const Group& others = isFirst ? *m.b : *m.a;
        const int i = own.astray[isFirst ? n : n - firsts];
        others.tree->overlapping(boundsOf(own.at(i)), [&](int j) {
            if (m.a == m.b ? j == i || (others.isAstray[j] && j < i)
                           : !isFirst && others.isAstray[j])
                return;
            const Candidate pair = m.a == m.b ? Candidate{std::min(i, j), std::max(i, j)}
                                   : isFirst  ? Candidate{i, j}
                                              : Candidate{j, i};
            if (accepts(m, m.a->at(pair.a), m.b->at(pair.b))) list.push_back(pair);
        });
    };
    m.found.collect((all + block - 1) / block, workers, [&](int p, Candidates::List& list) {
        for (int n = block * p; n < std::min(all, block * (p + 1)); ++n) of(n, list);
    });
    sift(m, workers);
}

}  // namespace plait
