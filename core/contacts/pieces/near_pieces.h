// Which pieces come near each other on their ways, by their bounds.
#pragma once

#include "../../numbers/math.h"

#include <algorithm>
#include <span>
#include <vector>

namespace plait {

class NearPieces {
public:
    // Hold a piece on its way, and what it reaches beyond.
    struct Bounds {
        Vec<double> low, high;  // m

        bool holds(const Bounds& other) const {
            return low.x <= other.low.x && low.y <= other.low.y && low.z <= other.low.z &&
                   high.x >= other.high.x && high.y >= other.high.y && high.z >= other.high.z;
        }
        void extend(const Bounds& other) {
            low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y),
                   std::min(low.z, other.low.z)};
            high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y),
                    std::max(high.z, other.high.z)};
        }
    };
    // Two that come near each other.
    struct Near {
        int first, second;
        int pair = -1;          // their contact last found; -1: none
        bool away = false;      // farther apart than contacts reach, all their way as foreseen
        bool crosses = false;   // as they were last looked at
        Vec<double> between{};  // of unit length, to the first: what parted them last; 0: unknown
    };

    explicit NearPieces(int pieces);

    std::vector<Bounds> bounds;  // by piece
    std::vector<Near> pairs;     // in the order of (first, second)

    // Pairs of which one moves at least, by sweep and prune along x. What is known of a pair stays.
    void find(std::span<const unsigned char> moves);

private:
    std::vector<int> order_;  // pieces by where their bounds begin
    std::vector<Near> known_;
};

}  // namespace plait
