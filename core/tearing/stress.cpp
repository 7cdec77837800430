#include "stress.h"

#include <algorithm>
#include <stdexcept>

namespace plait {
namespace {

std::array<int, 3> sorted(const int* v) {
    std::array<int, 3> corners{v[0], v[1], v[2]};
    std::ranges::sort(corners);
    return corners;
}

}  // namespace

SheetStress::SheetStress(const Cuts& cuts, const std::vector<Membrane::Rubber>& rubber,
                         std::span<const Vec<double>> rest)
    : place_(static_cast<std::size_t>(cuts.whole().count(2)), -1) {
    const SimplicialComplex& whole = cuts.whole();
    for (const Membrane::Rubber& part : rubber) {
        const int law = static_cast<int>(laws_.size());
        laws_.push_back({part.law, part.relaxed});
        for (std::size_t n = 0; n < part.triangles.size() / 3; ++n) {
            const std::array<int, 3> wanted = sorted(&part.triangles[3 * n]);
            const auto near = cuts.around(wanted[0]);
            const auto found = std::ranges::find_if(
                near, [&](int t) { return std::ranges::equal(whole.vertices(2, t), wanted); });
            if (found == near.end())
                throw std::invalid_argument("what tears has a triangle that is not in the world");
            const int t = *found;
            const auto v = whole.vertices(2, t);
            const Vec<double>&x0 = rest[v[0]], &x1 = rest[v[1]], &x2 = rest[v[2]];
            const double thickness = part.thickness[part.thickness.size() == 1 ? 0 : n];
            const Vec<double> normal = cross(x1 - x0, x2 - x0);
            const double doubled = length(normal);
            Element element{
                Patch(x0, x1, x2, thickness), law, 0.5 * doubled, thickness, {}, {}, {}};
            const Vec<double> unit = divide(1.0, doubled) * normal;
            element.along = divide(1.0, length(x1 - x0)) * (x1 - x0);
            element.across = cross(unit, element.along);
            element.slopes = {divide(1.0, doubled) * cross(unit, x2 - x1),
                              divide(1.0, doubled) * cross(unit, x0 - x2),
                              divide(1.0, doubled) * cross(unit, x1 - x0)};
            place_[t] = static_cast<int>(elements_.size());
            elements_.push_back(element);
        }
    }
}

SheetStress::Borne SheetStress::borne(int triangle,
                                      const std::array<Vec<double>, 3>& positions) const {
    const Element& element = elementOf(triangle);
    const Law& law = laws_[element.law];
    const Principal p =
        principal(element.patch, positions[1] - positions[0], positions[2] - positions[0]);
    const PrincipalEnergy e = law.relaxed ? law.ogden.relaxedAt(p.a, p.b) : law.ogden.at(p.a, p.b);
    return {e.value,
            {p.a, p.b},
            {e.a, e.b},
            {p.cosine * element.along + p.sine * element.across,
             p.cosine * element.across - p.sine * element.along},
            {p.u1, p.u2}};
}

std::array<Vec<double>, 3> SheetStress::forces(int triangle,
                                               const std::array<Vec<double>, 3>& positions) const {
    const Element& element = elementOf(triangle);
    const Law& law = laws_[element.law];
    std::array<Vec<double>, 3> forces;
    std::array<Block, 6> blocks;
    element.patch.forces(law.ogden, law.relaxed, positions[1] - positions[0],
                         positions[2] - positions[0], forces, blocks);
    return forces;
}

double SheetStress::shearModulus(int triangle) const {
    double sum = 0;
    for (const Ogden::Term& term : laws_[elementOf(triangle).law].ogden.terms)
        sum += term.modulus * term.exponent;
    return 0.5 * sum;
}

Vec<double> SheetStress::gradient(int triangle, const std::array<double, 3>& q) const {
    const auto& slopes = elementOf(triangle).slopes;
    return q[0] * slopes[0] + q[1] * slopes[1] + q[2] * slopes[2];
}

}  // namespace plait
