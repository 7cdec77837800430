#include "setting.h"

#include <plait/contacts/pieces/piece_contacts.h>
#include <plait/contacts/surface.h>

#include <algorithm>
#include <numeric>

namespace plait {

int addPinned(World& world, const Shape& shape) {
    const Piece piece = addPiece(world, shape, {.density = glassDensity});
    std::vector<int> all(piece.vertices.size());
    std::iota(all.begin(), all.end(), piece.vertices.first);
    world.pin(std::move(all));
    return static_cast<int>(world.pieces.size()) - 1;
}

int addShard(World& world, const Shape& shape, const Vec<double>& velocity) {
    addPiece(world, shape, {.density = glassDensity, .velocity = velocity}, "shard");
    return static_cast<int>(world.pieces.size()) - 1;
}

void meetAll(World& world, double thickness, const std::vector<double>& friction) {
    std::vector<Surface> surfaces;
    constexpr int spare = 4;
    for (std::size_t p = 0; p < world.pieces.size(); ++p) {
        const double f = friction[std::min(p, friction.size() - 1)];
        surfaces.push_back({.vertices = {world.pieces[p].first, world.pieces[p].last - spare},
                            .thickness = thickness,
                            .staticFriction = f,
                            .dynamicFriction = f});
    }
    meetPieces(world, surfaces);
}

Metric lowestOf(const World& world, const std::vector<int>& shards) {
    return {.name = "lowest",
            .unit = "mm",
            .measure =
                [first = world.pieces[shards.front()].first,
                 last = world.pieces[shards.back()].last](const Snapshot& at) {
                    double least = 1;
                    for (int v = first; v < last; ++v) least = std::min(least, at.positions[v].y);
                    return 1e3 * least;
                },
            .low = -0.1};
}

}  // namespace plait
