#include "solid.h"

namespace plait {

Symmetric<double> SolidMoments::inertia() const {
    const double trace = second.xx + second.yy + second.zz;
    Symmetric<double> inertia = Symmetric<double>::diagonal(trace);
    inertia.add(-1, second);
    return inertia;
}

// Of a tetrahedron from the origin the integral of r r^T is V / 20 (sum of x x^T + s s^T), s the
// sum of its corners.
SolidMoments solidMoments(std::span<const Vec<double>> positions,
                          std::span<const std::array<int, 3>> triangles) {
    SolidMoments solid{};
    if (triangles.empty()) return solid;
    const Vec<double> origin = positions[triangles[0][0]];
    Vec<double> first{};
    for (const auto& t : triangles) {
        const Vec<double> a = positions[t[0]] - origin, b = positions[t[1]] - origin,
                          c = positions[t[2]] - origin, sum = a + b + c;
        const double v = dot(a, cross(b, c)) / 6;
        solid.volume += v;
        first += v / 4 * sum;
        for (const Vec<double>& x : {a, b, c, sum}) solid.second.addOuter(v / 20, x);
    }
    if (solid.volume == 0) return solid;
    const Vec<double> centre = (1 / solid.volume) * first;
    solid.second.addOuter(-solid.volume, centre);
    solid.centre = origin + centre;
    return solid;
}

}  // namespace plait
