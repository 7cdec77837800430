#include "liquid.h"

#include "cells.h"
#include "liquid_set.h"
#include "spline.h"
#include "walls.h"

#include <cmath>
#include <stdexcept>

namespace plait {

Surface surfaceOf(const Liquid& liquid) {
    return {.vertices = liquid.particles,
            .thickness = 0.05 * liquid.spacing,
            .staticFriction = 0,
            .dynamicFriction = 0,
            .self = Self::none};
}

double kernelRadius(const Liquid& liquid) { return radiusInSpacings * liquid.spacing; }

Shades shadesOf(const Liquid& liquid) {
    return Walls::shadesOf(liquid.walls, kernelRadius(liquid));
}

double restCompression(const Liquid& liquid, double depth, double gravity, double h) {
    return 0.475 * gravity * depth * h * h / (liquid.relaxation * liquid.spacing * liquid.spacing);
}

std::vector<double> densityRatios(const Liquid& liquid, std::span<const Vec<double>> positions,
                                  double t) {
    Workers alone(1);
    Cells<double> cells;
    const Range range = liquid.particles;
    const double radius = kernelRadius(liquid);
    Walls walls(liquid.walls, radius, "walls", liquid.shades);
    walls.beginFrame(t, t);
    walls.begin({0, 0});
    cells.sort(
        range.last - range.first, radius, [&](int i) { return positions[range.first + i]; }, alone);
    std::vector<double> ratios(static_cast<std::size_t>(cells.count()));
    for (int s = 0; s < cells.count(); ++s) {
        const Vec<double> at = cells.point(s);
        double sum = 0;
        cells.around(at, [&](int other) {
            sum += CubicSpline::value(length(cells.point(other) - at) / radius);
        });
        ratios[cells.order()[s]] = sum / restSum + walls.at(at).part;
    }
    return ratios;
}

void holdDensity(World& world, const Liquid& liquid, SetOptions options) {
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument(options.name + ": " + what);
    };
    const Range range = liquid.particles;
    if (!(0 <= range.first && range.first < range.last &&
          range.last <= static_cast<int>(world.start.size())))
        refuse("its particles are not in the world");
    if (!(liquid.spacing > 0) || !std::isfinite(liquid.spacing)) refuse("spacing is above 0");
    if (!(liquid.relaxation > 0 && liquid.relaxation < 1)) refuse("relaxation is in (0, 1)");
    Liquid shaded = liquid;
    shaded.shades = shadesOf(liquid);
    [[maybe_unused]] const Walls refusesWhatIsWrong(liquid.walls, kernelRadius(liquid),
                                                    options.name, shaded.shades);
    const auto make = [shaded, name = options.name]<class Real>(
                          const World& made,
                          KernelChoice kernels) -> std::unique_ptr<Constraint<Real>> {
        return std::make_unique<LiquidSet<Real>>(made, shaded, name, kernels);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
