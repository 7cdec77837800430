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
                                  double t, std::span<const std::int32_t> ids) {
    Workers alone(1);
    Cells<double> cells;
    const Range range = liquid.particles;
    const double radius = kernelRadius(liquid);
    Walls walls(liquid.walls, radius, "walls", liquid.shades);
    walls.beginFrame(t, t);
    walls.begin({0, 0});
    std::vector<int> here;
    for (int v = range.first; v < range.last; ++v)
        if (ids.empty() || ids[v] >= 0) here.push_back(v);
    cells.sort(
        static_cast<int>(here.size()), radius, [&](int i) { return positions[here[i]]; }, alone);
    std::vector<double> ratios(static_cast<std::size_t>(range.size()));
    for (int s = 0; s < cells.count(); ++s) {
        const Vec<double> at = cells.point(s);
        double sum = 0;
        cells.around(at, [&](int other) {
            sum += CubicSpline::value(length(cells.point(other) - at) / radius);
        });
        ratios[here[cells.order()[s]] - range.first] = sum / restSum + walls.at(at).part;
    }
    return ratios;
}

void checkLiquid(const World& world, const Liquid& liquid, const std::string& who) {
    const auto refuse = [&](bool bad, const char* what) {
        if (bad) throw std::invalid_argument(who + ": " + what);
    };
    const Range range = liquid.particles;
    refuse(!(0 <= range.first && range.first < range.last &&
             range.last <= static_cast<int>(world.start.size())),
           "its particles are not in the world");
    refuse(!(liquid.spacing > 0) || !std::isfinite(liquid.spacing), "spacing is above 0");
    refuse(!(liquid.relaxation > 0 && liquid.relaxation < 1), "relaxation is in (0, 1)");
    [[maybe_unused]] const Walls refusesWhatIsWrong(liquid.walls, kernelRadius(liquid), who,
                                                    Shades(liquid.walls.size()));
}

void holdDensity(World& world, const Liquid& liquid, SetOptions options) {
    Liquid shaded = liquid;
    if (liquid.spacing > 0) shaded.shades = shadesOf(liquid);
    checkLiquid(world, shaded, options.name);
    const auto make = [shaded, name = options.name]<class Real>(
                          const World& made,
                          KernelChoice kernels) -> std::unique_ptr<Constraint<Real>> {
        return std::make_unique<LiquidSet<Real>>(made, shaded, name, kernels);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
