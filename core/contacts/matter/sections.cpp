#include "sections.h"

#include "../../world.h"
#include "../checks.h"

#include <cmath>

namespace plait {

Rounding::Rounding(const std::array<double, 6>& m) : flat_(true) {
    const double xx = std::sqrt(m[0]), xy = m[1] / xx, xz = m[2] / xx,
                 yy = std::sqrt(m[3] - xy * xy), yz = (m[4] - xz * xy) / yy;
    l_ = {xx, xy, yy, xz, yz, std::sqrt(m[5] - xz * xz - yz * yz)};
}

PairPoints Rounding::to(const PairPoints& x) const {
    if (!flat_) return x;
    PairPoints to;
    for (std::size_t i = 0; i < 4; ++i) {
        Vec<double>& p = to[i];
        p.x = x[i].x / l_[0];
        p.y = (x[i].y - l_[1] * p.x) / l_[2];
        p.z = (x[i].z - l_[3] * p.x - l_[4] * p.y) / l_[5];
    }
    return to;
}

Vec<double> Rounding::back(const Vec<double>& n) const {
    if (!flat_) return n;
    const double z = n.z / l_[5], y = (n.y - l_[4] * z) / l_[2];
    return {(n.x - l_[1] * y - l_[3] * z) / l_[0], y, z};
}

Sections::Sections(const World& world, const std::vector<Surface>& surfaces) {
    for (const Surface& s : surfaces) {
        if (s.directors.size() == 0) continue;
        const double thickness = thicknessAt(s, s.vertices.first);
        const double ratio = s.halfWidth / thickness;
        flats_.push_back({s.vertices, s.directors.first, thickness, ratio * ratio - 1});
    }
    if (flats_.empty()) return;
    thickness_.resize(world.rest.size());
    for (const Surface& s : surfaces)
        for (int v = s.vertices.first; v < s.vertices.last; ++v) thickness_[v] = thicknessAt(s, v);
    flatOf_.assign(world.rest.size(), -1);
    for (int f = 0; f < std::ssize(flats_); ++f)
        for (int v = flats_[f].vertices.first; v < flats_[f].vertices.last; ++v) flatOf_[v] = f;
    find(world.rest, atRest_);
    across_ = atRest_;
}

void Sections::turn(std::span<const Vec<double>> at) {
    if (!flats_.empty()) find(at, across_);
}

void Sections::find(std::span<const Vec<double>> at, std::vector<Vec<double>>& across) const {
    across.resize(at.size());
    const auto unit = [](const Vec<double>& v) { return divide(1.0, length(v)) * v; };
    for (const Flat& flat : flats_) {
        Vec<double> last{};
        for (int v = flat.vertices.first; v < flat.vertices.last - 1; ++v) {
            const int director = flat.directors + v - flat.vertices.first;
            const Vec<double> now = unit(at[director] - 0.5 * (at[v] + at[v + 1]));
            across[v] = unit(last + now);
            last = now;
        }
        across[flat.vertices.last - 1] = last;
    }
}

Rounding Sections::of(const Pairing& pair, std::span<const Vec<double>> across) const {
    if (flats_.empty()) return {};
    const std::size_t side[2]{0, static_cast<std::size_t>(pair.first)};
    const int flat[2]{flatOf_[pair.vertices[side[0]]], flatOf_[pair.vertices[side[1]]]};
    if (flat[0] < 0 && flat[1] < 0) return {};
    const double whole = thickness_[pair.vertices[side[0]]] + thickness_[pair.vertices[side[1]]];
    std::array<double, 6> sum{1, 0, 0, 1, 0, 1};
    for (std::size_t s = 0; s < 2; ++s) {
        if (flat[s] < 0) continue;
        const Flat& of = flats_[flat[s]];
        const int size = s == 0 ? pair.first : pair.second;
        Vec<double> u = across[pair.vertices[side[s]]];
        if (size == 2) u += across[pair.vertices[side[s] + 1]];
        const double c = of.excess * of.thickness / whole / dot(u, u);
        if (!std::isfinite(c)) continue;
        const std::array<double, 6> uu{u.x * u.x, u.x * u.y, u.x * u.z,
                                       u.y * u.y, u.y * u.z, u.z * u.z};
        for (std::size_t i = 0; i < 6; ++i) sum[i] += c * uu[i];
    }
    return Rounding(sum);
}

}  // namespace plait
