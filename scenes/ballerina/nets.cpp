#include "surface.h"

#include <unordered_map>

namespace plait::dancer {
namespace {

constexpr int span = 1024;  // cells along each axis at most, a power of two
// What holds her.
constexpr Point lowest{-0.9, -0.15, -0.25}, highest{0.9, 1.75, 0.25};

using Cell = std::array<int, 3>;

int keyOf(const Cell& c) { return (c[2] * span + c[1]) * span + c[0]; }

class Nets {
public:
    explicit Nets(double cell) : cell_(cell) {
        // Blocks small enough that the field may leave out limbs that are far from them.
        constexpr int block = 8;
        const Point size = (1 / cell) * (highest - lowest);
        for (int z = 0; z < size.z; z += block)
            for (int y = 0; y < size.y; y += block)
                for (int x = 0; x < size.x; x += block) search({x, y, z}, block);
        for (const Cell& c : cells_) addQuads(c);
    }

    Surface surface;

private:
    Point at(const Cell& c) const {
        return lowest + cell_ * Point{1.0 * c[0], 1.0 * c[1], 1.0 * c[2]};
    }

    double value(const Cell& c) {
        const auto [entry, isNew] = values_.try_emplace(keyOf(c), 0.0);
        if (isNew) entry->second = field(at(c));
        return entry->second;
    }

    // Cells that the surface may cross. The field changes at most this much faster than distance,
    // but for flat parts, where it may jump inside.
    void search(const Cell& c, int size) {
        constexpr double steepest = 2.5, jump = 0.03;
        const double half = 0.5 * size * cell_;
        const double here = field(at(c) + Point{half, half, half});
        const double reach = steepest * 1.7321 * half;
        if (here > reach || here < -reach - (size > 2 ? jump : 0)) return;
        if (size == 1) return addVertex(c);
        for (int i = 0; i < 8; ++i)
            search({c[0] + (i & 1) * size / 2, c[1] + (i >> 1 & 1) * size / 2,
                    c[2] + (i >> 2) * size / 2},
                   size / 2);
    }

    // At the mean of where the cell's edges are crossed.
    void addVertex(const Cell& c) {
        Point sum{0, 0, 0};
        int crossings = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < 4; ++i) {
                Cell a = c;
                a[static_cast<std::size_t>((axis + 1) % 3)] += i & 1;
                a[static_cast<std::size_t>((axis + 2) % 3)] += i >> 1;
                Cell b = a;
                ++b[static_cast<std::size_t>(axis)];
                const double va = value(a), vb = value(b);
                if ((va < 0) == (vb < 0)) continue;
                sum += mix(at(a), at(b), va / (va - vb));
                ++crossings;
            }
        if (crossings == 0) return;
        vertices_[keyOf(c)] = static_cast<int>(surface.positions.size());
        surface.positions.push_back((1.0 / crossings) * sum);
        cells_.push_back(c);
    }

    // Around each crossed edge that starts at the cell's lowest corner.
    void addQuads(const Cell& c) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Cell end = c;
            ++end[axis];
            const bool inside = value(c) < 0;
            if (inside == (value(end) < 0)) continue;
            std::array<int, 4> quad{};
            for (std::size_t i = 0; i < 4; ++i) {
                Cell around = c;
                if (i == 1 || i == 2) --around[(axis + 1) % 3];
                if (i >= 2) --around[(axis + 2) % 3];
                quad[i] = vertices_.at(keyOf(around));
            }
            if (!inside) std::swap(quad[1], quad[3]);
            surface.triangles.push_back({quad[0], quad[1], quad[2]});
            surface.triangles.push_back({quad[0], quad[2], quad[3]});
        }
    }

    double cell_;
    std::unordered_map<int, double> values_;
    std::unordered_map<int, int> vertices_;
    std::vector<Cell> cells_;
};

}  // namespace

Surface surfaceNets(double cell) { return Nets(cell).surface; }

Surface bodySurface() {
    Surface surface = surfaceNets(0.0045);
    coarsen(surface);
    return surface;
}

}  // namespace plait::dancer
