#include "chain_plan.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

// Where a row lies among the vertices of its curve.
struct Placed {
    int curve, low, high;
    ChainPlace place;
};

class Planner {
public:
    Planner(std::span<const ChainStencils> parts, std::span<const std::vector<int>> curves,
            std::span<const unsigned char> pinned)
        : parts_(parts), pinned_(pinned), at_(pinned.size(), {-1, -1}), moving_(curves.size()) {
        for (int c = 0; c < static_cast<int>(curves.size()); ++c)
            for (int k = 0; k < static_cast<int>(curves[c].size()); ++k) {
                const int v = curves[c][k];
                if (pinned[v]) continue;
                if (at_[v][0] >= 0)
                    throw std::invalid_argument("vertex " + std::to_string(v) +
                                                " lies on two curves, or twice on one");
                at_[v] = {c, static_cast<int>(moving_[c].size())};
                moving_[c].push_back(v);
            }
    }

    std::vector<ChainCurve> plan() const {
        std::vector<std::vector<Placed>> placed(moving_.size());
        for (int p = 0; p < static_cast<int>(parts_.size()); ++p) {
            const int rows = static_cast<int>(parts_[p].ids.size()) / parts_[p].arity;
            for (int i = 0; i < rows; ++i)
                if (const Placed row = place(p, i); row.curve >= 0)
                    placed[row.curve].push_back(row);
        }
        std::vector<ChainCurve> all;
        for (std::size_t c = 0; c < placed.size(); ++c)
            if (!placed[c].empty()) all.push_back(curve(placed[c], static_cast<int>(c)));
        return all;
    }

private:
    Placed place(int part, int row) const {
        const ChainStencils& all = parts_[part];
        Placed placed{-1, 0, 0, {part, row, 0, all.arity, {}}};
        for (int a = 0; a < all.arity; ++a) {
            const int v = all.ids[row * all.arity + a];
            placed.place.at[a] = pinned_[v] ? -1 : at_[v][1];
            if (pinned_[v]) continue;
            const auto [curve, k] = at_[v];
            if (curve < 0 || (placed.curve >= 0 && curve != placed.curve))
                throw std::invalid_argument("vertex " + std::to_string(v) +
                                            " is not on the curve of its row");
            placed.low = placed.curve < 0 ? k : std::min(placed.low, k);
            placed.high = placed.curve < 0 ? k : std::max(placed.high, k);
            placed.curve = curve;
        }
        return placed;
    }

    ChainCurve curve(std::vector<Placed>& rows, int number) const {
        const int vertices = static_cast<int>(moving_[number].size());
        const auto closes = [&](const Placed& row) {
            return 2 * (row.high - row.low) > std::max(vertices, 16);
        };
        const auto key = [&](const Placed& row) {
            return std::array{static_cast<int>(closes(row)), row.high, row.low, row.place.part,
                              row.place.row};
        };
        std::ranges::sort(rows, {}, key);
        ChainCurve curve;
        curve.vertices = moving_[number];
        curve.moving = vertices;
        for (Placed& row : rows) {
            addPinned(row.place, curve.vertices, vertices);
            for (int value = 0; value < parts_[row.place.part].values; ++value) {
                curve.places.push_back(row.place);
                curve.places.back().value = value;
                curve.border += closes(row);
            }
        }
        measure(curve);
        return curve;
    }

    // Those that do not move stand behind the `moving`, each once.
    void addPinned(ChainPlace& place, std::vector<int>& vertices, int moving) const {
        for (int a = 0; a < place.arity; ++a) {
            if (place.at[a] >= 0) continue;
            const int v = parts_[place.part].ids[place.row * place.arity + a];
            const auto known = std::find(vertices.begin() + moving, vertices.end(), v);
            place.at[a] = static_cast<int>(known - vertices.begin());
            if (known == vertices.end()) vertices.push_back(v);
        }
    }

    // How far apart rows of the band are that share a vertex.
    static void measure(ChainCurve& curve) {
        std::vector<int> first(curve.moving, -1);
        const int band = static_cast<int>(curve.places.size()) - curve.border;
        for (int j = 0; j < band; ++j)
            for (int a = 0; a < curve.places[j].arity; ++a) {
                const int v = curve.places[j].at[a];
                if (v >= curve.moving) continue;
                if (first[v] < 0) first[v] = j;
                curve.halfWidth = std::max(curve.halfWidth, j - first[v]);
            }
    }

    std::span<const ChainStencils> parts_;
    std::span<const unsigned char> pinned_;
    std::vector<std::array<int, 2>> at_;    // by vertex: curve and place among what moves on it
    std::vector<std::vector<int>> moving_;  // by curve
};

}  // namespace

std::vector<ChainCurve> planChains(std::span<const ChainStencils> parts,
                                   std::span<const std::vector<int>> curves,
                                   std::span<const unsigned char> pinned) {
    return Planner(parts, curves, pinned).plan();
}

bool samePlan(const ChainCurve& a, const ChainCurve& b) {
    const auto same = [](const ChainPlace& x, const ChainPlace& y) {
        return x.part == y.part && x.value == y.value && x.at == y.at;
    };
    return a.moving == b.moving && a.vertices.size() == b.vertices.size() && a.border == b.border &&
           std::ranges::equal(a.places, b.places, same);
}

}  // namespace plait
