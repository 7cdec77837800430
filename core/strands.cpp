#include "strands.h"

#include <algorithm>
#include <tuple>

namespace plait {
namespace {

struct End {
    int link, side;  // the link's vertex 0 or 1
};

// next[2 link + side]: the link that goes on beyond that end, -1 for none.
std::vector<int> continued(std::span<const int> links, std::span<const Vec<double>> rest) {
    std::vector<std::vector<End>> around(rest.size());
    for (int l = 0; l < static_cast<int>(links.size() / 2); ++l)
        for (const int side : {0, 1}) around[links[2 * l + side]].push_back({l, side});
    std::vector<int> next(links.size(), -1);
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (const std::vector<End>& ends : around) {
        pairs.clear();
        const auto direction = [&](const End& end) {
            const Vec<double> d =
                rest[links[2 * end.link + 1 - end.side]] - rest[links[2 * end.link + end.side]];
            return divide(1.0, length(d)) * d;
        };
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const double cosine = dot(direction(ends[i]), direction(ends[j]));
                if (cosine <= -0.5) pairs.emplace_back(cosine, i, j);
            }
        std::sort(pairs.begin(), pairs.end());
        for (const auto& [unused, i, j] : pairs) {
            int& from = next[2 * ends[i].link + ends[i].side];
            int& to = next[2 * ends[j].link + ends[j].side];
            if (from >= 0 || to >= 0) continue;
            from = ends[j].link;
            to = ends[i].link;
        }
    }
    return next;
}

// Goes on from a link through its vertex `side` while there is a way that no strand has taken and
// that does not come back to itself.
void extend(Strand& strand, int link, int side, std::span<const int> links,
            const std::vector<int>& next, std::vector<bool>& taken) {
    for (;;) {
        const int onward = next[2 * link + side];
        if (onward < 0 || taken[onward]) return;
        const int here = links[2 * link + side];
        const int far = links[2 * onward] == here ? 1 : 0;
        const int vertex = links[2 * onward + far];
        if (std::find(strand.vertices.begin(), strand.vertices.end(), vertex) !=
            strand.vertices.end())
            return;
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

}  // namespace

std::vector<Strand> strandsOf(std::span<const int> links, std::span<const Vec<double>> rest) {
    const std::vector<int> next = continued(links, rest);
    std::vector<bool> taken(links.size() / 2, false);
    std::vector<Strand> strands;
    for (int l = 0; l < static_cast<int>(taken.size()); ++l) {
        if (taken[l]) continue;
        taken[l] = true;
        Strand strand{{links[2 * l + 1], links[2 * l]}, {l}};
        extend(strand, l, 0, links, next, taken);
        std::reverse(strand.vertices.begin(), strand.vertices.end());
        std::reverse(strand.links.begin(), strand.links.end());
        extend(strand, l, 1, links, next, taken);
        strands.push_back(std::move(strand));
    }
    // Long ones first, so that blocks of them are of nearly one length.
    std::sort(strands.begin(), strands.end(), [](const Strand& a, const Strand& b) {
        return a.links.size() != b.links.size() ? a.links.size() > b.links.size()
                                                : a.links.front() < b.links.front();
    });
    color(strands, rest.size());
    return strands;
}

}  // namespace plait
