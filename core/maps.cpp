#include "maps.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {

Map paintedMap(World& world, const std::string& name, Range vertices, std::vector<double> values) {
    if (static_cast<int>(values.size()) != vertices.size())
        throw std::invalid_argument(name + ": a map of " + std::to_string(values.size()) +
                                    " vertices for a mesh of " + std::to_string(vertices.size()));
    for (const double value : values)
        if (!(value >= 0 && value < infinity))
            throw std::invalid_argument(name + ": a map has numbers from 0 on, not " +
                                        std::to_string(value));
    if (!values.empty()) world.warnOutside(name, *std::ranges::max_element(values), 0, 1);
    return {vertices, std::move(values)};
}

Map texturedMap(World& world, const std::string& name, Range vertices,
                const std::function<double(const Vec<double>& rest)>& texture) {
    std::vector<double> values;
    for (int v = vertices.first; v < vertices.last; ++v)
        values.push_back(texture(world.rest[static_cast<std::size_t>(v)]));
    return paintedMap(world, name, vertices, std::move(values));
}

double meanOf(const Map& map, std::span<const int> vertices) {
    double sum = 0;
    for (const int v : vertices) {
        if (v < map.vertices.first || v >= map.vertices.last)
            throw std::out_of_range("a map ends before vertex " + std::to_string(v));
        sum += map.values[static_cast<std::size_t>(v - map.vertices.first)];
    }
    return sum / static_cast<double>(vertices.size());
}

Shape displaced(const Shape& shape, std::span<const double> along) {
    if (along.size() != shape.positions.size())
        throw std::invalid_argument("a displacement of " + std::to_string(along.size()) +
                                    " vertices for a shape of " +
                                    std::to_string(shape.positions.size()));
    const std::vector<Vec<double>>& x = shape.positions;
    std::vector<Vec<double>> normals(x.size());
    for (int t = 0; t < shape.complex.count(2); ++t) {
        const auto [a, b, c] = shape.complex.triangle(t);
        const Vec<double> normal =
            cross(x[static_cast<std::size_t>(b)] - x[static_cast<std::size_t>(a)],
                  x[static_cast<std::size_t>(c)] - x[static_cast<std::size_t>(a)]);
        for (const int v : {a, b, c}) normals[static_cast<std::size_t>(v)] += normal;
    }
    Shape result = shape;
    for (std::size_t v = 0; v < x.size(); ++v)
        if (const double l = length(normals[v]); l > 0)
            result.positions[v] += (along[v] / l) * normals[v];
    return result;
}

}  // namespace plait
