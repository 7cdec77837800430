#include "exposure.h"

#include <cstddef>
#include <utility>

namespace plait {
namespace {

// Where everything was; copies that came since are where their vertices were, and have come.
void bringBack(const World& world, const RunFrame& frame, std::vector<Vec<double>>& from,
               std::vector<std::int32_t>& ids) {
    const World torn = world.tornBy(frame.cuts);
    for (const VertexSplit& split : torn.torn->splits()) {
        if (ids[split.copy] >= 0) continue;
        from[split.copy] = from[split.vertex];
        ids[split.copy] = frame.ids[split.copy];
    }
}

}  // namespace

Moment momentOf(const RunFrame& frame) {
    return {frame.positions, frame.time, frame.ids, frame.ages, frame.velocities, frame.cuts};
}

Exposure::Exposure(const World& world, const RunFrame& before, const RunFrame& frame, int moments) {
    constexpr double open = 0.5;
    std::vector<Vec<double>> from = before.positions;
    std::vector<std::int32_t> ids = before.ids;
    if (frame.cuts.size() > before.cuts.size()) bringBack(world, frame, from, ids);
    positions.reserve(static_cast<std::size_t>(moments));
    for (int i = 0; i < moments; ++i) {
        const double s = 1 - open * (moments - 1 - i) / moments;
        std::vector<Vec<double>> x = frame.positions;
        for (std::size_t v = 0; v < x.size(); ++v)
            if (ids.empty() || ids[v] == frame.ids[v])
                x[v] = (1 - s) * from[v] + s * frame.positions[v];
            else
                x[v] -= (1 - s) * (frame.time - before.time) * frame.velocities[v];
        positions.push_back(std::move(x));
        all.push_back(momentOf(frame));
        all.back().positions = positions.back();
        all.back().time = (1 - s) * before.time + s * frame.time;
    }
}

}  // namespace plait
