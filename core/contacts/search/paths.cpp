#include "paths.h"

#include <algorithm>

namespace plait {

bool movesBy(double distance, const Pairing& pair, const PairPoints& start, const PairPoints& end) {
    if (distance <= 0) return true;
    const auto far = [&](std::size_t i, std::size_t j) {
        const Vec<double> d = (end[i] - start[i]) - (end[j] - start[j]);
        return !(dot(d, d) < distance * distance);
    };
    if (pair.first == 2) return far(0, 2) || far(0, 3) || far(1, 2) || far(1, 3);
    return far(0, 1) || (pair.second > 1 && far(0, 2)) || (pair.second > 2 && far(0, 3));
}

bool mayMeet(const Pairing& pair, const PairPoints& start, const PairPoints& end, double reach) {
    const auto apart = [&](double Vec<double>::* axis) {
        double low[2], high[2];
        for (int side = 0; side < 2; ++side) {
            const int begin = side ? pair.first : 0;
            const int last = side ? pair.first + pair.second : pair.first;
            low[side] = high[side] = start[begin].*axis;
            for (int i = begin; i < last; ++i) {
                low[side] = std::min({low[side], start[i].*axis, end[i].*axis});
                high[side] = std::max({high[side], start[i].*axis, end[i].*axis});
            }
        }
        return low[0] - high[1] > reach || low[1] - high[0] > reach;
    };
    return !apart(&Vec<double>::x) && !apart(&Vec<double>::y) && !apart(&Vec<double>::z);
}

// What is further apart than `reach` at both ends, seen along the shortest way between them at the
// start, is so in between: seen thus distances are concave in time.
bool comesWithin(double reach, const Pairing& pair, const Nearest& now, const PairPoints& start,
                 const PairPoints& end) {
    const double distance = length(now.apart);
    if (distance <= reach) return true;
    const auto height = [&](std::size_t i) { return dot(now.apart, end[i]); };
    double low = height(0), high = height(static_cast<std::size_t>(pair.first));
    for (int i = 1; i < pair.first; ++i) low = std::min(low, height(i));
    for (int i = pair.first + 1; i < pair.first + pair.second; ++i)
        high = std::max(high, height(i));
    if (low - high > reach * distance) return false;
    if (length(nearest(pair, end).apart) <= reach) return true;
    return impactOf(pair, start, end, reach).has_value();
}

Impact impactOf(const Pairing& pair, const PairPoints& start, const PairPoints& end,
                double thickness) {
    const auto path = [&](int i) { return MovingVertex{start[i], end[i]}; };
    if (pair.first == 2) return thickEdgeEdge(path(0), path(1), path(2), path(3), thickness);
    if (pair.second == 3) return thickPointTriangle(path(0), path(1), path(2), path(3), thickness);
    if (pair.second == 2) return thickPointEdge(path(0), path(1), path(2), thickness);
    return thickPointPoint(path(0), path(1), thickness);
}

}  // namespace plait
