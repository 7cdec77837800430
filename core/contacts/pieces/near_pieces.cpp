#include "near_pieces.h"

#include <algorithm>
#include <numeric>

namespace plait {

NearPieces::NearPieces(int pieces)
    : bounds(static_cast<std::size_t>(pieces)), order_(static_cast<std::size_t>(pieces)) {
    std::iota(order_.begin(), order_.end(), 0);
}

void NearPieces::find(std::span<const unsigned char> moves) {
    std::ranges::sort(order_, {}, [&](int p) { return std::pair(bounds[p].low.x, p); });
    std::swap(known_, pairs);
    pairs.clear();
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const int p = order_[i];
        const Bounds& a = bounds[p];
        for (std::size_t j = i + 1; j < order_.size(); ++j) {
            const int q = order_[j];
            const Bounds& b = bounds[q];
            if (b.low.x > a.high.x) break;
            if (b.low.y > a.high.y || a.low.y > b.high.y || b.low.z > a.high.z ||
                a.low.z > b.high.z || (!moves[p] && !moves[q]))
                continue;
            pairs.push_back({std::min(p, q), std::max(p, q)});
        }
    }
    const auto place = [](const Near& near) { return std::pair(near.first, near.second); };
    std::ranges::sort(pairs, {}, place);
    auto known = known_.begin();
    for (Near& near : pairs) {
        while (known != known_.end() && place(*known) < place(near)) ++known;
        if (known != known_.end() && place(*known) == place(near)) near = *known;
    }
}

}  // namespace plait
