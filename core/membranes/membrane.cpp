#include "membrane.h"

#include "../measure/surfaces/geometry.h"
#include "membrane_set.h"

#include <span>
#include <stdexcept>

namespace plait {
namespace {

// The gas that is there when the hole opens, by the area of matter at rest.
void ride(World& world, Membrane::Filling& filling) {
    const LeakOptions& leak = filling.leak;
    const std::span skin = std::span(filling.enclosure.triangles).first(filling.enclosure.skin);
    const double amount = filling.amount ? filling.amount(leak.opens) : filling.gas.amount,
                 mass = amount * leak.density / filling.gas.outside, whole = area(world.rest, skin);
    filling.riding.assign(world.mass.size(), 0);
    for (const auto& t : skin)
        for (const int v : t)
            filling.riding[v] += mass / 3 * area(world.rest, std::span(&t, 1)) / whole;
    for (std::size_t v = 0; v < world.mass.size(); ++v) world.mass[v] += filling.riding[v];
}

}  // namespace

void holdMembrane(World& world, Membrane membrane, SetOptions options) {
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument(options.name + ": " + what);
    };
    checkRows(options.name, membrane.springs, world.start.size());
    for (const auto& row : membrane.springs.rows)
        if (!(row.compliance > 0 && row.compression > 0)) refuse("a spring has no compliance");
    for (const Membrane::Rubber& rubber : membrane.rubber) {
        const std::size_t n = rubber.triangles.size() / 3;
        checkStencils(options.name, rubber.triangles, 3, n, {}, world.start.size());
        checkNumbers(options.name, rubber.thickness);
        if (rubber.thickness.size() != 1 && rubber.thickness.size() != n)
            refuse("rubber has one thickness for all triangles, or one for each");
    }
    for (Membrane::Filling& filling : membrane.gases) {
        if (!(volume(filling.enclosure, world.start) > 0))
            refuse("what a gas is in has no volume, or is inside out");
        const bool leaks = !filling.leak.hole.empty();
        if (leaks && filling.bursts) refuse("what bursts does not leak before");
        if ((leaks || filling.bursts) &&
            (filling.gas.law != GasLaw::isothermal || !(filling.gas.outside > 0)))
            refuse("what leaks or bursts is isothermal, and goes into a gas");
        if (leaks) ride(world, filling);
    }
    const auto make = [membrane]<class Real>(const World& w,
                                             KernelChoice) -> std::unique_ptr<Constraint<Real>> {
        return std::make_unique<MembraneSet<Real>>(w, membrane);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
