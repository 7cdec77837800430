#include "strands.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

namespace plait {
namespace {

struct End {
    int link, side;  // the link's vertex 0 or 1
};

// The pairs of ends around a vertex that make the most and straightest strands: those of the
// greatest sum of 1 - cosine, of pairs within 60 degrees of straight. Pairing the straightest first
// would leave others without a partner, and strands of irregular meshes half as long. Found by
// going through the sets of ends; of more than 12 ends, the straightest pairs go first.
std::vector<std::pair<int, int>> pairedAt(std::span<const Vec<double>> directions) {
    const int count = static_cast<int>(directions.size());
    const auto worth = [&](int i, int j) {
        const double cosine = dot(directions[i], directions[j]);
        return cosine <= -0.5 ? 1 - cosine : 0;
    };
    std::vector<std::pair<int, int>> pairs;
    std::vector<int> ends(count);
    std::iota(ends.begin(), ends.end(), 0);
    while (ends.size() > 12) {
        std::pair<std::size_t, std::size_t> best{0, 1};
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = i + 1; j < ends.size(); ++j)
                if (worth(ends[i], ends[j]) > worth(ends[best.first], ends[best.second]))
                    best = {i, j};
        if (worth(ends[best.first], ends[best.second]) > 0)
            pairs.emplace_back(ends[best.first], ends[best.second]);
        ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(best.second));
        ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(best.first));
    }
    // Of the ends in a set, its last stays alone or goes with another.
    const int n = static_cast<int>(ends.size());
    std::vector<double> most(std::size_t{1} << n, 0);
    std::vector<int> partner(most.size(), -1);
    for (std::size_t set = 1; set < most.size(); ++set) {
        const int last = 63 - std::countl_zero(set);
        const std::size_t others = set ^ std::size_t{1} << last;
        most[set] = most[others];
        for (int j = 0; j < last; ++j) {
            const double gain = worth(ends[last], ends[j]);
            if (!(others >> j & 1) || gain == 0) continue;
            const double sum = most[others ^ std::size_t{1} << j] + gain;
            if (sum > most[set] + 1e-9) most[set] = sum, partner[set] = j;  // alike: the first
        }
    }
    for (std::size_t set = most.size() - 1; set > 0;) {
        const int last = 63 - std::countl_zero(set), j = partner[set];
        set ^= std::size_t{1} << last;
        if (j < 0) continue;
        set ^= std::size_t{1} << j;
        pairs.emplace_back(ends[j], ends[last]);
    }
    return pairs;
}

// next[2 link + side]: the link that goes on beyond that end, -1 for none.
std::vector<int> continued(std::span<const int> links, std::span<const Vec<double>> rest) {
    std::vector<std::vector<End>> around(rest.size());
    for (int l = 0; l < static_cast<int>(links.size() / 2); ++l)
        for (const int side : {0, 1}) around[links[2 * l + side]].push_back({l, side});
    std::vector<int> next(links.size(), -1);
    std::vector<Vec<double>> directions;
    for (const std::vector<End>& ends : around) {
        directions.clear();
        for (const End& end : ends) {
            const Vec<double> d =
                rest[links[2 * end.link + 1 - end.side]] - rest[links[2 * end.link + end.side]];
            directions.push_back(divide(1.0, length(d)) * d);
        }
        for (const auto& [i, j] : pairedAt(directions)) {
            next[2 * ends[i].link + ends[i].side] = ends[j].link;
            next[2 * ends[j].link + ends[j].side] = ends[i].link;
        }
    }
    return next;
}

// Goes on from a link through its vertex `side` while there is a way that no strand has taken and
// that does not come back to itself. `last`, by vertex: the latest strand there, by its first link.
void extend(Strand& strand, int link, int side, std::span<const int> links,
            const std::vector<int>& next, std::vector<bool>& taken, std::vector<int>& last) {
    const int own = last[strand.vertices.front()];
    for (;;) {
        const int onward = next[2 * link + side];
        if (onward < 0 || taken[onward]) return;
        const int here = links[2 * link + side];
        const int far = links[2 * onward] == here ? 1 : 0;
        const int vertex = links[2 * onward + far];
        if (last[vertex] == own) return;
        last[vertex] = own;
        taken[onward] = true;
        strand.links.push_back(onward);
        strand.vertices.push_back(vertex);
        link = onward;
        side = far;
    }
}

// Each strand, in order, the lowest colour that none of its vertices has yet.
void color(std::vector<Strand>& strands, std::size_t vertices) {
    std::vector<std::vector<bool>> taken;  // by colour, by vertex
    for (Strand& strand : strands) {
        const auto meets = [&](const std::vector<bool>& of) {
            return std::any_of(strand.vertices.begin(), strand.vertices.end(),
                               [&](int v) { return of[v]; });
        };
        strand.color = 0;
        while (strand.color < static_cast<int>(taken.size()) && meets(taken[strand.color]))
            ++strand.color;
        if (strand.color == static_cast<int>(taken.size())) taken.emplace_back(vertices, false);
        for (const int v : strand.vertices) taken[strand.color][v] = true;
    }
}

// So that blocks of them are of nearly one length.
void putLongFirst(std::vector<Strand>& strands) {
    std::sort(strands.begin(), strands.end(), [](const Strand& a, const Strand& b) {
        return a.links.size() != b.links.size() ? a.links.size() > b.links.size()
                                                : a.links.front() < b.links.front();
    });
}

}  // namespace

std::vector<Strand> strandsOf(std::span<const int> links, std::span<const Vec<double>> rest) {
    const std::vector<int> next = continued(links, rest);
    std::vector<bool> taken(links.size() / 2, false);
    std::vector<int> last(rest.size(), -1);
    std::vector<Strand> strands;
    for (int l = 0; l < static_cast<int>(taken.size()); ++l) {
        if (taken[l]) continue;
        taken[l] = true;
        Strand strand{{links[2 * l + 1], links[2 * l]}, {l}};
        for (const int v : strand.vertices) last[v] = l;
        extend(strand, l, 0, links, next, taken, last);
        std::reverse(strand.vertices.begin(), strand.vertices.end());
        std::reverse(strand.links.begin(), strand.links.end());
        extend(strand, l, 1, links, next, taken, last);
        strands.push_back(std::move(strand));
    }
    putLongFirst(strands);
    color(strands, rest.size());
    return strands;
}

std::vector<Strand> partsOf(std::span<const Strand> strands, const std::vector<bool>& gone) {
    std::vector<int> number;
    int left = 0;
    for (const bool link : gone) number.push_back(link ? -1 : left++);
    std::vector<Strand> parts;
    for (const Strand& strand : strands)
        for (std::size_t k = 0; k < strand.links.size(); ++k) {
            if (gone[strand.links[k]]) continue;
            if (k == 0 || gone[strand.links[k - 1]])
                parts.push_back({{strand.vertices[k]}, {}, strand.color});
            parts.back().links.push_back(number[strand.links[k]]);
            parts.back().vertices.push_back(strand.vertices[k + 1]);
        }
    putLongFirst(parts);
    return parts;
}

}  // namespace plait
