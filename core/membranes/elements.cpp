#include "elements.h"

#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

Vec<double> anyAcross(const Vec<double>& u) {
    const Vec<double> axis = std::abs(u.x) < 0.6 ? Vec<double>{1, 0, 0} : Vec<double>{0, 1, 0};
    const Vec<double> v = cross(u, axis);
    return divide(1.0, length(v)) * v;
}

}  // namespace

Principal principal(const Patch& patch, const Vec<double>& d1, const Vec<double>& d2) {
    const Vec<double> f1 = patch.inverse[0] * d1,
                      f2 = patch.inverse[1] * d1 + patch.inverse[2] * d2;
    const double c11 = dot(f1, f1), c22 = dot(f2, f2), c12 = dot(f1, f2);
    const double mean = 0.5 * (c11 + c22), half = 0.5 * (c11 - c22),
                 r = squareRoot(half * half + c12 * c12);
    Principal p{};
    // The larger of two forms of the same direction; 1, 0 where all are principal.
    const double x = half > 0 ? r + half : c12, y = half > 0 ? c12 : r - half,
                 l = squareRoot(x * x + y * y);
    p.cosine = l > 0 ? x / l : 1;
    p.sine = l > 0 ? y / l : 0;
    const Vec<double> g1 = p.cosine * f1 + p.sine * f2;
    p.a = squareRoot(mean + r);
    const Vec<double> n = cross(f1, f2);
    const double area = length(n);
    p.b = divide(area, p.a);
    p.u1 = p.a > 0 ? divide(1.0, length(g1)) * g1 : Vec<double>{1, 0, 0};
    p.normal = area > 1e-9 * p.a * p.a ? divide(1.0, area) * n : anyAcross(p.u1);
    p.u2 = cross(p.normal, p.u1);
    return p;
}

double Spring::energy(const Vec<double>& d) const {
    const double longer = length(d) - rest;
    return 0.5 * (longer > 0 ? stiffness : compression) * longer * longer;
}

Vec<double> Spring::force(const Vec<double>& d, Block& block) const {
    const double l = length(d), longer = l - rest, k = longer > 0 ? stiffness : compression;
    const Vec<double> u = divide(1.0, l) * d;
    // Along, k; across, what tension holds.
    const double across = k * (longer > 0 ? divide(longer, l) : 0);
    block = {};
    block.addOuter(k - across, u, u);
    block.column[0].x += across;
    block.column[1].y += across;
    block.column[2].z += across;
    return (k * longer) * u;
}

Patch::Patch(const Vec<double>& x0, const Vec<double>& x1, const Vec<double>& x2, double t) {
    const Vec<double> d1 = x1 - x0, d2 = x2 - x0;
    const double l = length(d1), doubled = length(cross(d1, d2));
    if (!(l > 0 && doubled > 0) || !std::isfinite(doubled) || !(t > 0) || !std::isfinite(t))
        throw std::invalid_argument("a triangle of rubber has no area or no thickness");
    const double along = dot(d1, d2) / l, up = doubled / l;
    inverse[0] = 1 / l;
    inverse[1] = -along / (l * up);
    inverse[2] = 1 / up;
    volume = 0.5 * doubled * t;
}

double Patch::energy(const Ogden& law, bool relaxed, const Vec<double>& d1,
                     const Vec<double>& d2) const {
    const Principal p = principal(*this, d1, d2);
    return volume * (relaxed ? law.relaxedAt(p.a, p.b) : law.at(p.a, p.b)).value;
}

// The six eigenvectors of the second derivative by F, and their eigenvalues, are closed forms of
// stretches and their directions: two scale, one twists, one flips, two lean out of the plane
// (Smith, de Goes, Kim, "Analytic eigensystems for isotropic distortion energies", 2019, here of a
// matrix 3 x 2).
double Patch::forces(const Ogden& law, bool relaxed, const Vec<double>& d1, const Vec<double>& d2,
                     std::array<Vec<double>, 3>& forces, std::array<Block, 6>& blocks) const {
    const Principal p = principal(*this, d1, d2);
    const PrincipalEnergy e = relaxed ? law.relaxedAt(p.a, p.b) : law.at(p.a, p.b);
    // How F follows vertices: dF = sum of dx_i b_i^T, b_i here along v1 and v2.
    double along[3], across[3];
    const double b1[2] = {inverse[0], inverse[1]}, b2[2] = {0, inverse[2]};
    along[1] = p.cosine * b1[0] + p.sine * b1[1];
    across[1] = p.cosine * b1[1] - p.sine * b1[0];
    along[2] = p.cosine * b2[0] + p.sine * b2[1];
    across[2] = p.cosine * b2[1] - p.sine * b2[0];
    along[0] = -(along[1] + along[2]);
    across[0] = -(across[1] + across[2]);
    for (int i = 0; i < 3; ++i)
        forces[i] = (-volume * e.a * along[i]) * p.u1 + (-volume * e.b * across[i]) * p.u2;

    blocks = {};
    const auto add = [&](double eigenvalue, const std::array<Vec<double>, 3>& mode) {
        if (!(eigenvalue > 0)) return;
        const double s = volume * eigenvalue;
        for (int i = 0; i < 3; ++i) blocks[i].addOuter(s, mode[i], mode[i]);
        blocks[3].addOuter(s, mode[0], mode[1]);
        blocks[4].addOuter(s, mode[0], mode[2]);
        blocks[5].addOuter(s, mode[1], mode[2]);
    };
    const auto mode = [&](const Vec<double>& u, const Vec<double>& v) {
        return std::array<Vec<double>, 3>{along[0] * u + across[0] * v,
                                          along[1] * u + across[1] * v,
                                          along[2] * u + across[2] * v};
    };
    const Vec<double> none{0, 0, 0};
    const double middle = 0.5 * (e.aa + e.bb), half = 0.5 * (e.aa - e.bb),
                 r = squareRoot(half * half + e.ab * e.ab);
    const double x = half > 0 ? r + half : e.ab, y = half > 0 ? e.ab : r - half,
                 l = squareRoot(x * x + y * y), c = l > 0 ? x / l : 1, s = l > 0 ? y / l : 0;
    add(middle + r, mode(c * p.u1, s * p.u2));
    add(middle - r, mode(-s * p.u1, c * p.u2));
    const double root = squareRoot(0.5), a = p.a > Ogden::least ? p.a : Ogden::least,
                 b = p.b > Ogden::least ? p.b : Ogden::least;
    add((e.a + e.b) / (a + b), mode(-root * p.u2, root * p.u1));
    const double flip = a - b > 1e-6 * a ? (e.a - e.b) / (a - b) : e.aa - e.ab;
    add(flip, mode(root * p.u2, root * p.u1));
    add(e.a / a, mode(p.normal, none));
    add(e.b / b, mode(none, p.normal));
    return volume * e.value;
}

}  // namespace plait
