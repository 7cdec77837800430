// Strips of rubber with a notch, clamped above and below, which are drawn apart: the pure shear
// test, whose tear sets free what a strip that is stretched bears a length.
#pragma once

#include "tests/random.h"

#include <plait/membranes/membrane.h>
#include <plait/solver.h>
#include <plait/stencils.h>
#include <plait/tearing/tear.h>
#include <plait/tearing/tearing.h>

#include <cmath>
#include <memory>

namespace plait::test {

// Where the sheet comes apart along its middle from x = 0 to `notch`: rows must be odd.
inline Shape notched(const GridParameters& size, double notch, double jitter = 0,
                     std::uint64_t seed = 1) {
    Shape shape = grid(size);
    Random random(seed);
    const double dx = size.width / (size.columns - 1), dy = size.height / (size.rows - 1);
    const int middle = size.rows / 2;
    for (int r = 0; r < size.rows; ++r)
        for (int c = 0; c < size.columns; ++c) {
            Vec<double>& x = shape.positions[r * size.columns + c];
            const bool edge = r == 0 || c == 0 || r == size.rows - 1 || c == size.columns - 1;
            const double a = jitter * random.uniform(-dx, dx), b = jitter * random.uniform(-dy, dy);
            if (edge || (r == middle && x.x < notch + 1e-9)) continue;
            x.x += a, x.y += b;
        }
    const Range all{0, shape.complex.count(0)};
    SimplicialComplex withSpare = shape.complex;
    const Range spare = withSpare.append(SimplicialComplex(size.columns));
    Cuts cuts(withSpare, {{all, spare}}, std::vector<unsigned char>(spare.last));
    for (int e = 0; e < withSpare.count(1); ++e) {
        const auto ends = withSpare.vertices(1, e);
        const auto on = [&](int v) {
            return v / size.columns == middle && shape.positions[v].x < notch + 1e-9;
        };
        if (on(ends[0]) && on(ends[1])) cuts.cut(e);
    }
    const int count = all.last + static_cast<int>(cuts.splits().size());
    for (const VertexSplit& split : cuts.splits())
        shape.positions.push_back(shape.positions[cuts.original(split.copy)]);
    Simplices given;
    for (int t = 0; t < cuts.torn().count(2); ++t)
        given.triangles.push_back(cuts.torn().triangle(t));
    return {SimplicialComplex(count, given), shape.positions};
}

struct Strip {
    GridParameters size;
    double notch, thickness = 1e-3, density = 1000;
    Ogden law = neoHookean(0.4e6);
    World world{};
    Range cloth{};
    Membrane::Rubber rubber{};
    double drawn = 1;  // how far apart the clamps are

    Strip(const GridParameters& of, double notchLength, double jitter = 0, int spare = 0,
          std::uint64_t seed = 1)
        : size(of), notch(notchLength) {
        cloth = world.add(notched(size, notch, jitter, seed),
                          {.density = density * thickness, .spare = spare});
        rubber = {triangleStencils(world.complex, cloth), {thickness}, law};
    }

    // J/m, of a strip without a notch that is drawn out as much.
    double driveAt(double stretch) const {
        return law.at(stretch, 1).value * size.height * thickness;
    }

    // Drawn apart from `from` to `to` in so many seconds; it begins stretched evenly.
    void draw(double from, double to, double seconds) {
        const double middle = 0.5 * size.height;
        for (Vec<double>& x : world.start) x.y = middle + from * (x.y - middle);
        std::vector<int> clamped = world.select(cloth, [&](const Vec<double>& x) {
            return std::fabs(x.y - middle) > 0.499 * from * size.height;
        });
        std::erase_if(clamped, [&](int v) { return world.isSpare(v); });
        world.pin(clamped, Motion([=](const Vec<double>& start, double t) {
                      const double stretch = from + (to - from) * std::min(1.0, t / seconds);
                      return Vec<double>{start.x, middle + (start.y - middle) * stretch / from,
                                         start.z};
                  }));
    }

    Membrane membrane() const {
        Membrane membrane;
        membrane.rubber = {rubber};
        membrane.iterations = 60;
        return membrane;
    }
    void hold() { holdMembrane(world, membrane(), {.name = "rubber", .importance = 1}); }
    void holdTearing(Tearing tearing) {
        tearing.cloth = cloth;
        plait::holdTearing(world, membrane(), tearing, {.name = "rubber", .importance = 1});
    }
};

}  // namespace plait::test
