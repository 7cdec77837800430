#include "shards.h"

#include <plait/numbers/rotation.h>

#include <algorithm>
#include <numeric>

namespace plait {

Shards::Shards(const World& world, std::vector<Weld> welds, std::vector<int> cells)
    : welds_(std::move(welds)),
      cells_(std::move(cells)),
      pieces_(world.pieces),
      start_(world.start),
      mass_(world.pieces.size()),
      pinned_(world.pieces.size()) {
    for (std::size_t p = 0; p < pieces_.size(); ++p)
        for (int v = pieces_[p].first; v < pieces_[p].last; ++v) {
            mass_[p] += world.mass[v];
            pinned_[p] |= world.pinned[v];
        }
}

bool Shards::together(const Weld& weld, const std::vector<Vec<double>>& positions) const {
    // A piece's last vertices span a solid.
    const int a = pieces_[weld.first].last - 1;
    const auto frame = [&](const std::vector<Vec<double>>& x) {
        return frameOf(x[a - 1] - x[a], x[a - 2] - x[a]);
    };
    const Rotation turn = frame(positions) * frame(start_).inverse();
    const Range& second = pieces_[weld.second];
    constexpr double apart = 1e-4;  // m
    for (const int v : {second.last - 1, second.last - 2, second.last - 3})
        if (length(positions[a] + turn * (start_[v] - start_[a]) - positions[v]) > apart)
            return false;
    return true;
}

std::vector<int> Shards::groups(const std::vector<Vec<double>>& positions) const {
    std::vector<int> leader(pieces_.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto leaderOf = [&](int p) {
        while (leader[p] != p) p = leader[p] = leader[leader[p]];
        return p;
    };
    for (const Weld& weld : welds_) {
        if (!together(weld, positions)) continue;
        const int a = leaderOf(weld.first), b = leaderOf(weld.second);
        leader[std::max(a, b)] = std::min(a, b);
    }
    for (int p = 0; p < std::ssize(leader); ++p) leader[p] = leaderOf(p);
    return leader;
}

Metric Shards::count(Band band) const {
    return {.name = "shards",
            .unit = "",
            .measure =
                [*this](const Snapshot& at) {
                    std::vector<int> own, all = groups(at.positions);
                    for (const int p : cells_) own.push_back(all[p]);
                    std::ranges::sort(own);
                    return static_cast<double>(std::unique(own.begin(), own.end()) - own.begin());
                },
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

Metric Shards::hanging(Band band) const {
    return {.name = "hanging",
            .unit = "%",
            .measure =
                [*this](const Snapshot& at) {
                    const std::vector<int> all = groups(at.positions);
                    std::vector<unsigned char> held(pieces_.size());
                    for (std::size_t p = 0; p < pieces_.size(); ++p) held[all[p]] |= pinned_[p];
                    double hangs = 0, sum = 0;
                    for (const int p : cells_) {
                        sum += mass_[p];
                        if (held[all[p]]) hangs += mass_[p];
                    }
                    return 100 * hangs / sum;
                },
            .low = band.low,
            .high = band.high,
            .from = band.from,
            .caption = true};
}

}  // namespace plait
