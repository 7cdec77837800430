#include "paths.h"

#include <algorithm>

namespace plait {

bool movesBy(double distance, const Pairing& pair, const PairPoints& start, const PairPoints& end) {
    if (distance <= 0) return true;
    for (int i = 0; i < pair.first; ++i)
        for (int j = pair.first; j < pair.first + pair.second; ++j) {
            const Vec<double> d = (end[i] - start[i]) - (end[j] - start[j]);
            if (!(dot(d, d) < distance * distance)) return true;
        }
    return false;
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

Impact impactOf(const Pairing& pair, const PairPoints& start, const PairPoints& end,
                double thickness) {
    const auto path = [&](int i) { return MovingVertex{start[i], end[i]}; };
    if (pair.first == 2) return thickEdgeEdge(path(0), path(1), path(2), path(3), thickness);
    if (pair.second == 3) return thickPointTriangle(path(0), path(1), path(2), path(3), thickness);
    if (pair.second == 2) return thickPointEdge(path(0), path(1), path(2), thickness);
    return thickPointPoint(path(0), path(1), thickness);
}

}  // namespace plait
