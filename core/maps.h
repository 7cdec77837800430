// A number a vertex, painted or by texture, that multiplies what rows are made with, or by which a
// rest shape is displaced (M 8).
#pragma once

#include "constraints/rows.h"
#include "world.h"

#include <functional>
#include <string>
#include <vector>

namespace plait {

struct Map {
    Range vertices;
    std::vector<double> values;  // one a vertex of the range
};

// By vertex. It is of one mesh: std::invalid_argument, naming it, for another count than the range
// has, or what is no number or below 0. Above 1 it makes what it multiplies stiffer than that was
// said to be, and is warned of, once (World::warnings) [FH15].
Map paintedMap(World& world, const std::string& name, Range vertices, std::vector<double> values);

// By texture: asked at each vertex of the rest shape (m), and so the same on any mesh [UN8].
Map texturedMap(World& world, const std::string& name, Range vertices,
                const std::function<double(const Vec<double>& rest)>& texture);

// A row's part: the mean over its vertices. Throws std::out_of_range for a vertex outside the map.
double meanOf(const Map& map, std::span<const int> vertices);

// Divides the compliance of each row by its part of the map: what is rigid stays so, and what has
// no stiffness has none. Where the part is 0, or the compliance no number that a step could use,
// the row is taken out; others cost what they did [UN7].
template <class Kind>
void multiplyStiffness(Rows<Kind>& set, const Map& map) {
    Rows<Kind> kept{{}, {}, {}, set.animate};
    for (int i = 0; i < set.size(); ++i) {
        const auto ids =
            std::span(set.ids).subspan(static_cast<std::size_t>(i) * Kind::arity, Kind::arity);
        auto row = set.rows[static_cast<std::size_t>(i)];
        const double part = meanOf(map, ids);
        row.compliance /= part;
        bool acts = part > 0 && row.compliance < infinity;
        if constexpr (requires { row.compression; }) {
            row.compression /= part;
            acts = acts || (part > 0 && row.compression < infinity);
        }
        if (!acts) continue;
        kept.ids.insert(kept.ids.end(), ids.begin(), ids.end());
        kept.rows.push_back(row);
        if (!set.colors.empty()) kept.colors.push_back(set.colors[static_cast<std::size_t>(i)]);
    }
    set = std::move(kept);
}

// A shape whose vertices stand off by as much (m) along their normals, the mean of their triangles'
// by area; below 0 it goes in. As a rest shape it wrinkles what begins smooth [DC18]. Throws
// std::invalid_argument for another count than the shape has vertices.
Shape displaced(const Shape& shape, std::span<const double> along);

}  // namespace plait
