// The few vertices that have strayed are foreseen anew, and their pairs looked for again.
#include "pair_search.h"

#include <algorithm>

namespace plait {

// False, and nothing is known any more, where too many have, one cannot be foreseen, or this has
// been done so often since all were looked for that by now it has cost as much.
bool PairSearch::redirect(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                          double slack, Workers& workers) {
    constexpr int share = 8;  // of all: beyond, looking for all pairs is no dearer
    constexpr int most = 3;   // times, likewise
    if (from_.empty() || redirected_ == most ||
        share * findAstray(start, end, workers) > std::ssize(members_) ||
        !foreseeAstray(start, end, slack))
        return false;
    ++redirected_;
    place(from_, to_, workers);
    for (auto& side : groups_)
        for (Group& group : side) {
            if (group.count() == 0) continue;
            group.isAstray.assign(static_cast<std::size_t>(group.count()), 0);
            group.astray.clear();
            for (int i = 0; i < group.count(); ++i) {
                for (const int v : group.at(i)) group.isAstray[i] |= astray_[v];
                if (group.isAstray[i]) group.astray.push_back(i);
            }
            const auto bound = [&](int i) { return boundsOf(group.at(i)); };
            if (!group.astray.empty()) group.tree->refit(group.astray, bound, workers);
        }
    for (Meeting& m : meetings_) {
        if (m.a->astray.empty() && m.b->astray.empty()) continue;
        dropAstray(m, workers);
        findAnew(m, workers);
    }
    return true;
}

// On straight ways that have them where they are now at the time that has passed. Once all stay,
// one that does not stray from its middle may stay as well.
bool PairSearch::foreseeAstray(std::span<const Vec<double>> start, std::span<const Vec<double>> end,
                               double slack) {
    for (const int v : members_) {
        if (!astray_[v]) continue;
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
