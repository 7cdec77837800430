#include "party_balloon.h"

#include <plait/constraints/constants.h>
#include <plait/numbers/elementary.h>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr double air = 101325;  // Pa
constexpr int pieces = 2000;    // of a profile

// Along the balloon's skin, from the end of the neck: radius and depth (m).
using Profile = std::vector<std::array<double, 2>>;

double smoothStep(double s) {
    s = std::clamp(s, 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

// The end of the neck is closed by a half ball; where it meets the ball it widens smoothly.
Profile profileOf(const PartyBalloon& balloon) {
    const double r = balloon.neck, length = balloon.neckLength, big = balloon.radius;
    const double middle = length + std::sqrt(big * big - r * r);
    Profile profile;
    for (int i = 0; i <= pieces; ++i) {
        const double s = double(i) / pieces, y = s * (middle + big);
        double ball = 0, neck = 0;
        if (std::fabs(y - middle) < big) ball = std::sqrt(big * big - (y - middle) * (y - middle));
        if (y < middle) neck = y < r ? std::sqrt(r * r - (r - y) * (r - y)) : r;
        // The larger of the two, its corner rounded.
        const double blend = y < middle ? 0.25 * r * smoothStep(y / length) : 0;
        const double apart = ball - neck;
        profile.push_back({0.5 * (ball + neck + std::sqrt(apart * apart + 4 * blend * blend)) -
                               (y < middle ? blend : 0),
                           y});
    }
    profile.front()[0] = profile.back()[0] = 0;
    return profile;
}

// A sphere of equal triangles, its vertices where as much area of the profile lies below them; the
// end of the neck at the origin, all else below.
Shape shapeOf(const PartyBalloon& balloon, int subdivisions) {
    const Profile profile = profileOf(balloon);
    std::vector<double> below{0};
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const auto& [r0, y0] = profile[i - 1];
        const auto& [r1, y1] = profile[i];
        below.push_back(below.back() + (r0 + r1) * std::hypot(r1 - r0, y1 - y0));
    }
    Shape shape = sphere({.subdivisions = subdivisions, .radius = 1});
    for (Vec<double>& x : shape.positions) {
        const double part = 0.5 * (1 - x.y) * below.back();
        const auto next = std::clamp<std::ptrdiff_t>(
            std::ranges::lower_bound(below, part) - below.begin(), 1, pieces);
        const double s =
            std::clamp((part - below[next - 1]) / (below[next] - below[next - 1]), 0.0, 1.0);
        const double r = profile[next - 1][0] + s * (profile[next][0] - profile[next - 1][0]),
                     y = profile[next - 1][1] + s * (profile[next][1] - profile[next - 1][1]),
                     across = std::sqrt(x.x * x.x + x.z * x.z);
        x = across > 0 ? Vec<double>{r * x.x / across, -y, r * x.z / across}
                       : Vec<double>{0, -y, 0};
    }
    return shape;
}

}  // namespace

double PartyBalloon::pressure(double stretch) const {
    const PrincipalEnergy e = rubber.at(stretch, stretch);
    return wall * (e.a + e.b) / (radius * stretch * stretch);
}

Range addBalloon(World& world, const PartyBalloon& balloon, int subdivisions,
                 const Vec<double>& top, int spare) {
    Shape shape = shapeOf(balloon, subdivisions);
    for (Vec<double>& x : shape.positions) x += top;
    return world.add(shape, {.density = balloon.density * balloon.wall, .spare = spare});
}

// Cut off where the half ball ends that closes the neck.
OpenBalloon addOpenBalloon(World& world, const PartyBalloon& balloon, int subdivisions,
                           const Vec<double>& mouth, const Vec<double>& out) {
    const Shape whole = shapeOf(balloon, subdivisions);
    const double cut = balloon.neck;
    std::vector<int> place(whole.positions.size(), -1);
    OpenBalloon open;
    std::vector<Vec<double>> positions;
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (-whole.positions[v].y < cut) continue;
        place[v] = static_cast<int>(positions.size());
        positions.push_back(whole.positions[v]);
    }
    Simplices kept;
    for (int t = 0; t < whole.complex.count(2); ++t) {
        const auto [a, b, c] = whole.complex.triangle(t);
        const std::array<int, 3> at{place[a], place[b], place[c]};
        if (std::ranges::min(at) >= 0) kept.triangles.push_back(at);
    }
    Shape shape{SimplicialComplex(static_cast<int>(positions.size()), kept), positions};
    for (const int e : shape.complex.boundary(1))
        for (const int v : shape.complex.edge(e)) {
            Vec<double>& x = shape.positions[v];
            const double part = balloon.neck / std::hypot(x.x, x.z);
            x = {part * x.x, -cut, part * x.z};
        }
    const Vec<double> side = std::fabs(out.x) < 0.9 ? Vec<double>{1, 0, 0} : Vec<double>{0, 0, 1};
    Vec<double> across = cross(side, out);
    across = (1 / length(across)) * across;
    const Vec<double> third = cross(out, across);
    for (Vec<double>& x : shape.positions) {
        open.depths.push_back(-cut - x.y);
        x = mouth + x.x * third + (x.y + cut) * out + x.z * across;
    }
    open.skin = world.add(shape, {.density = balloon.density * balloon.wall});
    return open;
}

Membrane::Rubber rubberOf(const Enclosure& enclosure, const PartyBalloon& balloon, double wall) {
    Membrane::Rubber rubber{{}, {wall}, balloon.rubber};
    for (const auto& t : enclosure.triangles)
        rubber.triangles.insert(rubber.triangles.end(), t.begin(), t.end());
    return rubber;
}

double amountFor(const PartyBalloon& balloon, double rest, double stretch) {
    return (air + balloon.pressure(stretch)) * rest * stretch * stretch * stretch;
}

}  // namespace plait
