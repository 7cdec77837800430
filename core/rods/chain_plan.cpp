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
            placed.place.at[a] = at_[v][1];
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
        for (const Placed& row : rows)
            for (int value = 0; value < parts_[row.place.part].values; ++value) {
                curve.places.push_back(row.place);
                curve.places.back().value = value;
                curve.border += closes(row);
            }
        couple(curve);
        link(curve);
        return curve;
    }

    static void couple(ChainCurve& curve) {
        std::vector<std::vector<std::array<int, 2>>> rowsAt(curve.vertices.size());
        const int rows = static_cast<int>(curve.places.size()), band = rows - curve.border;
        for (int j = 0; j < rows; ++j) {
            const ChainPlace& place = curve.places[j];
            for (int b = 0; b < place.arity; ++b) {
                if (place.at[b] < 0) continue;
                auto& before = rowsAt[place.at[b]];
                before.push_back({j, b});
                for (const auto& [i, a] : before) {
                    curve.couplings.push_back({i, j, a, b});
                    if (j < band) curve.halfWidth = std::max(curve.halfWidth, j - i);
                }
            }
        }
        std::ranges::sort(curve.couplings, [](const ChainCoupling& x, const ChainCoupling& y) {
            return std::array{x.i, x.j, x.a} < std::array{y.i, y.j, y.a};
        });
    }

    void link(ChainCurve& curve) const {
        const int vertices = static_cast<int>(curve.vertices.size());
        for (int i = 0; i < static_cast<int>(curve.places.size()); ++i) {
            const ChainPlace& place = curve.places[i];
            if (!parts_[place.part].links) continue;
            const auto [a, b] = std::minmax(place.at[0], place.at[1]);
            curve.links.push_back({i, place.at[0], place.at[1]});
            if (a < 0) continue;
            if (2 * (b - a) > std::max(vertices, 16))
                curve.linkBorder = std::max(curve.linkBorder, vertices - b);
            else
                curve.linkWidth = std::max(curve.linkWidth, b - a);
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

}  // namespace plait
