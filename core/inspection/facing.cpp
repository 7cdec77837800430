#include "facing.h"

#include "../measure/surfaces/geometry.h"

#include <algorithm>
#include <utility>

namespace plait {
namespace {

// A side of a triangle; those of one edge stand together when sorted.
struct Side {
    int low, high;  // vertices
    int triangle;
    bool up;  // runs from low to high
    auto operator<=>(const Side&) const = default;
    bool isBeside(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sidesOf(std::span<const std::array<int, 3>> triangles) {
    std::vector<Side> sides;
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
        for (int j = 0; j < 3; ++j) {
            const int a = triangles[t][j], b = triangles[t][(j + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
        }
    std::ranges::sort(sides);
    return sides;
}

// body(first, last) of the sides of each edge.
template <class Body>
void forEdges(const std::vector<Side>& sides, const Body& body) {
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last =
            std::find_if_not(first, sides.end(), [&](const Side& s) { return s.isBeside(*first); });
        body(first, last);
        first = last;
    }
}

struct Neighbour {
    int triangle;
    bool agrees;
};

std::vector<std::vector<Neighbour>> neighboursOf(std::span<const std::array<int, 3>> triangles) {
    std::vector<std::vector<Neighbour>> neighbours(triangles.size());
    forEdges(sidesOf(triangles), [&](auto first, auto last) {
        if (last - first != 2) return;
        const Side &a = first[0], &b = first[1];
        neighbours[a.triangle].push_back({b.triangle, a.up != b.up});
        neighbours[b.triangle].push_back({a.triangle, a.up != b.up});
    });
    return neighbours;
}

}  // namespace

int faceOutward(std::span<const Vec<double>> positions,
                std::vector<std::array<int, 3>>& triangles) {
    const auto neighbours = neighboursOf(triangles);
    std::vector<bool> seen(triangles.size(), false);
    const auto turn = [&](int t) { std::swap(triangles[t][1], triangles[t][2]); };
    int turned = 0;
    for (int start = 0; start < static_cast<int>(triangles.size()); ++start) {
        if (seen[start]) continue;
        std::vector<std::pair<int, bool>> part{{start, false}};  // a triangle, was it turned
        std::vector<std::array<int, 3>> surface;
        seen[start] = true;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const auto [t, isTurned] = part[i];
            if (isTurned) turn(t);
            surface.push_back(triangles[t]);
            for (const auto& [next, agrees] : neighbours[t]) {
                if (seen[next]) continue;
                seen[next] = true;
                part.emplace_back(next, isTurned == agrees);
            }
        }
        const bool inward = volume(positions, surface) < 0;
        for (const auto& [t, isTurned] : part) {
            if (inward) turn(t);
            turned += isTurned != inward;
        }
    }
    return turned;
}

std::optional<Opening> openingOf(std::span<const std::array<int, 3>> triangles) {
    std::optional<Opening> opening;
    forEdges(sidesOf(triangles), [&](auto first, auto last) {
        const auto up = std::count_if(first, last, [](const Side& s) { return s.up; });
        if (2 * up == last - first) return;
        if (!opening) opening = {{first->low, first->high}, 0, last - first == 1};
        ++opening->count;
    });
    return opening;
}

}  // namespace plait
