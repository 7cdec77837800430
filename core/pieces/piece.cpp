#include "piece.h"

#include "../gas/enclosure.h"
#include "../measure/surfaces/geometry.h"
#include "../measure/surfaces/solid.h"
#include "piece_set.h"

#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

constexpr int spareCount = 4;

using Triangles = std::vector<std::array<int, 3>>;

SolidMoments checkedMoments(const Shape& solid, const Triangles& triangles,
                            const std::string& name) {
    enclose(solid.positions, triangles, {.name = name});
    const SolidMoments moments = solidMoments(solid.positions, triangles);
    const double area = plait::area(solid.positions, triangles);
    constexpr double flat = 1e-9;  // volume over area^1.5, 0.09 for a ball
    if (std::fabs(moments.volume) <= flat * area * std::sqrt(area))
        throw std::invalid_argument(name + ": it is flat and has no volume");
    if (moments.volume < 0) throw std::invalid_argument(name + ": it is inside out");
    return moments;
}

// The lower factor of a = L L^T by columns. Returns whether a is positive definite.
bool factor(const Symmetric<double>& a, std::array<Vec<double>, 3>& columns) {
    const double xx = std::sqrt(a.xx), xy = a.xy / xx, xz = a.xz / xx;
    const double yy = std::sqrt(a.yy - xy * xy), yz = (a.yz - xy * xz) / yy;
    const double zz = std::sqrt(a.zz - xz * xz - yz * yz);
    columns = {{{xx, xy, xz}, {0, yy, yz}, {0, 0, zz}}};
    return xx > 0 && yy > 0 && zz > 0;  // of what is not, a root is no number
}

// Point masses that add up to a solid of mass 1: `part` on its corners, the rest on four spare
// ones. All about its centre.
struct Share {
    double part;
    Vec<double> centre;               // of the spare ones
    std::array<Vec<double>, 3> axes;  // L: they are at centre + L s, s = (+-1, +-1, +-1)
};

// Corners get as much as leaves the spare ones a moment above 0, since what hangs on a corner feels
// that corner's mass first.
Share shareOf(const Symmetric<double>& solid, const Vec<double>& corner,
              const Symmetric<double>& corners) {
    Share share{};
    const auto works = [&](double part) {
        const double rest = 1 / (1 - part);
        Symmetric<double> left{};
        constexpr double least = 0.1;  // of the solid's, in every direction
        left.add(rest - least, solid);
        left.add(-rest * part, corners);
        const Vec<double> centre = -(rest * part) * corner;
        left.addOuter(-1, centre);
        std::array<Vec<double>, 3> axes;
        if (!factor(left, axes)) return false;
        left.add(least, solid);
        factor(left, axes);
        share = {part, centre, axes};
        return true;
    };
    works(0);
    double low = 0, high = 0.99;
    for (int i = 0; i < 30; ++i) (works((low + high) / 2) ? low : high) = (low + high) / 2;
    return share;
}

}  // namespace

Piece addPiece(World& world, const Shape& solid, const PieceMatter& matter,
               const std::string& name) {
    if (!(matter.density > 0) || !std::isfinite(matter.density))
        throw std::invalid_argument(name + ": its density must be positive");
    Triangles triangles;
    for (int t = 0; t < solid.complex.count(2); ++t) triangles.push_back(solid.complex.triangle(t));
    const SolidMoments moments = checkedMoments(solid, triangles, name);
    const int corners = static_cast<int>(solid.positions.size());

    Shape shape{SimplicialComplex(corners + spareCount,
                                  {.edges = {}, .triangles = triangles, .tetrahedra = {}}),
                solid.positions};
    shape.positions.resize(corners + spareCount, moments.centre);
    const Range range = world.add(shape, {});
    double sum = 0;
    for (int v = 0; v < corners; ++v) sum += world.mass[range.first + v];
    Vec<double> centre{};
    Symmetric<double> second{}, own{};
    for (int v = 0; v < corners; ++v) {
        const Vec<double> arm = solid.positions[v] - moments.centre;
        centre += world.mass[range.first + v] / sum * arm;
        second.addOuter(world.mass[range.first + v] / sum, arm);
    }
    own.add(1 / moments.volume, moments.second);
    const Share share = shareOf(own, centre, second);

    const double mass = matter.density * moments.volume;
    for (int v = 0; v < corners; ++v) world.mass[range.first + v] *= share.part * mass / sum;
    constexpr int signs[spareCount][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (int i = 0; i < spareCount; ++i) {
        const int v = range.first + corners + i;
        world.mass[v] = (1 - share.part) * mass / spareCount;
        world.rest[v] = moments.centre + share.centre + double(signs[i][0]) * share.axes[0] +
                        double(signs[i][1]) * share.axes[1] + double(signs[i][2]) * share.axes[2];
    }
    for (int v = range.first; v < range.last; ++v) {
        const Vec<double> arm = matter.turn * (world.rest[v] - moments.centre);
        world.start[v] = moments.centre + matter.shift + arm;
        world.velocity[v] = matter.velocity + cross(matter.spin, arm);
    }
    world.pieces.push_back(range);
    return {range, corners};
}

void holdPieces(World& world, SetOptions options) {
    const auto make = []<class Real>(const World& made, KernelChoice) {
        return std::make_unique<PieceSet<Real>>(Pieces(made));
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
