#include "broadphase_sets.h"

#include <plait/complex/shapes.h>

#include <cmath>
#include <cstdint>

namespace plait {
namespace {

constexpr double cell = 0.01, motion = 0.002;  // m: the length of an edge, the way of a vertex

// SplitMix64 (Steele, Lea & Flood 2014).
class Random {
public:
    // In [-size, size] along each axis.
    Vec<double> point(double size) { return {uniform(size), uniform(size), uniform(size)}; }

private:
    double uniform(double size) {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return size * (static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1);
    }

    std::uint64_t state_ = 1;
};

// In a cube with room of `cell` a side for each; in clusters of a thousand around places of it,
// about 30 times as dense.
void scatter(BroadPhaseSet& set, int count, bool clustered) {
    Random random;
    const double half = std::cbrt(count) * cell / 2, spread = 10 * cell / 6;
    Vec<double> centre{};
    for (int i = 0; i < count; ++i) {
        if (clustered && i % 1000 == 0) centre = random.point(half);
        Vec<double> at = clustered ? centre : random.point(half);
        for (int k = 0; clustered && k < 3; ++k) at += random.point(spread);
        const Vec<double> by = random.point(motion), along = random.point(cell / 2);
        for (int end = 0; end < set.arity; ++end) {
            const Vec<double> x = set.arity == 1 ? at : end ? at + along : at - along;
            set.vertices.push_back(static_cast<int>(set.start.size()));
            set.start.push_back(x);
            set.end.push_back(x + by + random.point(motion / 10));
        }
    }
}

// Four sheets of so many vertices a side, half a cell apart, in folds four cells high.
FoldedSheets folded(int side) {
    constexpr int layers = 4;
    constexpr double wave = 2 * cell;
    const double width = side * cell;
    Random random;
    Simplices cells;
    FoldedSheets sheets{.radius = cell / 20, .margin = cell / 4};
    for (int layer = 0; layer < layers; ++layer) {
        const Shape sheet = grid({.columns = side, .rows = side, .width = width, .height = width});
        const int first = static_cast<int>(sheets.start.size());
        for (const Vec<double>& p : sheet.positions) {
            const double u = p.x / cell, v = p.y / cell;
            const double z =
                layer * cell / 2 + wave * (std::sin(0.7 * u) + std::cos(0.4 * v + 0.3 * u));
            sheets.start.push_back(p + Vec<double>{0, 0, z} + random.point(cell / 20));
            sheets.end.push_back(sheets.start.back() + random.point(motion));
        }
        for (int t = 0; t < sheet.complex.count(2); ++t) {
            const auto [a, b, c] = sheet.complex.triangle(t);
            cells.triangles.push_back({first + a, first + b, first + c});
        }
    }
    sheets.complex = SimplicialComplex(static_cast<int>(sheets.start.size()), cells);
    return sheets;
}

void pile(BroadPhaseSet& set, int count) {
    const FoldedSheets sheets = folded(static_cast<int>(std::sqrt(count / 12.0)));
    set.start = sheets.start;
    set.end = sheets.end;
    for (int e = 0; e < sheets.complex.count(1); ++e)
        for (const int v : sheets.complex.vertices(1, e)) set.vertices.push_back(v);
}

}  // namespace

FoldedSheets foldedSheets(int triangles) {
    return folded(static_cast<int>(std::lround(std::sqrt(triangles / 8.0))) + 1);
}

BroadPhaseSet broadPhaseSet(int which, int count) {
    BroadPhaseSet sets[broadPhaseSets]{
        {.name = "edges, uniform", .radius = cell / 20},
        {.name = "edges, clustered", .radius = cell / 20},
        {.name = "edges of sheets", .radius = cell / 20},
        {.name = "particles, uniform", .arity = 1, .radius = cell / 2},
        {.name = "particles, clustered", .arity = 1, .radius = cell / 5},
    };
    BroadPhaseSet set = sets[which];
    if (which == 2)
        pile(set, count);
    else
        scatter(set, count, which == 1 || which == 4);
    return set;
}

}  // namespace plait
