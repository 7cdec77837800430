#include "welds.h"

#include "weld_set.h"

#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

void check(const World& world, const std::vector<Weld>& welds, const WeldOptions& options) {
    const auto need = [&](bool met, const std::string& what) {
        if (!met) throw std::invalid_argument(options.name + ": " + what);
    };
    const WeldMatter& m = options.matter;
    const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
    need(world.clusters < 0, "the world has welds");
    need(positive(m.stiffness), "their stiffness must be positive");
    need(m.strength > 0, "their strength must be positive");
    need(m.scatter >= 0 && m.scatter < 1, "the scatter must be in [0, 1)");
    need(m.toughness >= 0 && std::isfinite(m.toughness), "their toughness must not be negative");
    need(positive(m.contactStiffness), "the contacts' stiffness must be positive");
    need(m.plate >= 0 && positive(m.density), "the plate must have a thickness and a density");
    const int pieces = static_cast<int>(world.pieces.size());
    for (const Weld& weld : welds) {
        for (const int p : {weld.first, weld.second})
            need(p >= 0 && p < pieces, "a weld of a piece that is not there");
        need(weld.first != weld.second, "a weld of a piece with itself");
        need(positive(weld.length) && positive(weld.height) && positive(weld.span),
             "a weld must have an area and a length");
        need(std::fabs(dot(weld.normal, weld.along)) < 1e-6 &&
                 std::fabs(dot(weld.normal, weld.normal) - 1) < 1e-6 &&
                 std::fabs(dot(weld.along, weld.along) - 1) < 1e-6,
             "a weld's directions must be perpendicular and of unit length");
    }
}

}  // namespace

void weldPieces(World& world, std::vector<Weld> welds, const WeldOptions& options) {
    check(world, welds, options);
    const auto make = [welds, matter = options.matter]<class Real>(const World& made,
                                                                   KernelChoice) {
        return std::make_unique<WeldSet<Real>>(made, welds, matter);
    };
    world.clusters = static_cast<int>(world.sets.size());
    world.constrain(
        recipeOf<Constraint>(make),
        {.name = options.name, .order = options.order, .importance = options.importance}, true);
}

std::vector<Weld> weldsOf(const Pattern& pattern, const Vec<double>& corner,
                          std::span<const int> pieces, const std::array<int, 4>& sides) {
    std::vector<Weld> welds;
    for (const Seam& seam : pattern.seams) {
        const int second =
            seam.onBorder() ? sides[Seam::border - 1 - seam.second] : pieces[seam.second];
        if (second < 0) continue;
        const Vec<double> way{seam.to.x - seam.from.x, seam.to.y - seam.from.y, 0};
        const Vec<double> along = (1 / length(way)) * way, normal{along.y, -along.x, 0};
        const PlanePoint& site = pattern.cells[seam.first].site;
        const double half = (seam.from.x - site.x) * normal.x + (seam.from.y - site.y) * normal.y;
        const Vec<double> from{site.x, site.y, 0};
        // A border does not bend: its spring reaches from the site to it, and no farther.
        const double part = seam.onBorder() ? 0.5 : 1;
        welds.push_back({.first = pieces[seam.first],
                         .second = second,
                         .at = corner + from + part * half * normal,
                         .normal = normal,
                         .along = along,
                         .length = length(way),
                         .height = pattern.pane.thickness,
                         .span = 2 * part * half});
    }
    return welds;
}

std::vector<Weld> weldsOf(const SolidPattern& pattern, std::span<const int> pieces) {
    std::vector<Weld> welds;
    for (const SolidSeam& seam : pattern.seams) {
        const Vec<double>&a = pattern.sites[seam.first], &b = pattern.sites[seam.second];
        const double span = length(b - a);
        welds.push_back({.first = pieces[seam.first],
                         .second = pieces[seam.second],
                         .at = 0.5 * (a + b),
                         .normal = (1 / span) * (b - a),
                         .along = seam.along,
                         .length = seam.length,
                         .height = seam.height,
                         .span = span});
    }
    return welds;
}

template <class Real>
std::vector<std::int32_t> holdingOf(const World& world, const State<Real>& state) {
    if (world.clusters < 0) return {};
    const std::vector<std::int32_t>& kept = state.kept[world.clusters].integers;
    return {kept.begin() + std::ssize(world.pieces), kept.end()};
}

template std::vector<std::int32_t> holdingOf(const World&, const State<float>&);
template std::vector<std::int32_t> holdingOf(const World&, const State<double>&);

}  // namespace plait
