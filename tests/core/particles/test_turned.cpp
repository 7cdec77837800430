// Walls that are turned: glasses and jugs.
#include "pools.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/particles/spline.h>
#include <plait/particles/walls.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

// A tumbler, inside `radius` wide and a little wider above, from y = 0 to `height`; walls and
// bottom are `thick` (m).
Profile tumbler(double radius, double height, double thick) {
    const double above = 1.1 * radius;
    return Profile({{0, -thick},
                    {radius + thick, -thick},
                    {above + thick, height},
                    {above, height},
                    {radius, 0},
                    {0, 0}});
}

// The same with a lid.
Profile jar(double radius, double height, double thick) {
    const double above = 1.1 * radius;
    return Profile({{0, -thick},
                    {radius + thick, -thick},
                    {above + thick, height + thick},
                    {0, height + thick},
                    {0, height},
                    {above, height},
                    {radius, 0},
                    {0, 0}});
}

double distanceTo(const Profile& profile, double r, double y) {
    double least = infinity;
    const auto& corners = profile.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& a = corners[i];
        const auto& b = corners[(i + 1) % corners.size()];
        for (int k = 0; k <= 2000; ++k) {
            const double f = k / 2000.0;
            const double x = a[0] + f * (b[0] - a[0]), z = a[1] + f * (b[1] - a[1]);
            if (a[0] == 0 && b[0] == 0) continue;
            least = std::min(least, std::hypot(r - x, y - z));
        }
    }
    return least;
}

}  // namespace

TEST_CASE("turned: distances, ways out, and when a path comes near", "[liquid][colliders]") {
    const Profile profile = tumbler(0.3, 0.6, 0.05);
    const Solid solid = Solid::turned(profile);
    std::mt19937 random(3);
    const auto u = [&](double size) {
        return size * (static_cast<double>(random()) / 4294967296.0 - 0.5);
    };
    double worst = 0, off = 0, late = 0;
    int met = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec<double> p{u(1), u(1) + 0.25, u(1)};
        const Side side = sideOf(solid, p);
        const double exact = distanceTo(profile, std::hypot(p.x, p.z), p.y);
        worst = std::max(worst, std::fabs(std::fabs(side.distance) - exact));
        off = std::max({off, std::fabs(length(side.normal) - 1),
                        std::fabs(sideOf(solid, p - side.distance * side.normal).distance)});
        const Vec<double> q{u(1), u(1) + 0.25, u(1)};
        const double gap = 0.01;
        if (side.distance < gap) continue;
        const auto at = reaches(solid, p, q, gap);
        double first = 2;
        for (int k = 0; k <= 2000 && first > 1; ++k)
            if (sideOf(solid, p + k / 2000.0 * (q - p)).distance < gap) first = k / 2000.0;
        if (first > 1) continue;
        ++met;
        REQUIRE(at);
        late = std::max(late, std::fabs(*at - first));
    }
    REQUIRE(met > 50);
    REQUIRE(report("distance against points of the outline, m", worst, 2e-4));
    REQUIRE(report("the way out ends on it, m", off, 1e-12));
    REQUIRE(report("when it comes near, of the path", late, 6e-4));
    REQUIRE(sideOf(solid, {0, 0.2, 0}).distance == Approx(0.2));
    REQUIRE(sideOf(solid, {0, -0.02, 0}).distance == Approx(-0.02));
}

// Against marching along the ray to each of some thousand cubes.
TEST_CASE("turned: what is hidden at rims, in corners and on sides", "[liquid]") {
    const double reach = 0.08;
    const Profile profile = tumbler(0.3, 0.6, 0.05);
    const TurnedShade shade(profile, reach);
    const auto hidden = [&](const Vec<double>& p, const Vec<double>& q) {
        for (int k = 1; k <= 40; ++k) {
            const Vec<double> x = p + k / 40.0 * (q - p);
            if (profile.contains(std::hypot(x.x, x.z), x.y)) return true;
        }
        return false;
    };
    double worst = 0, byPlane = 0;
    for (const auto& [r, y] : {std::array{0.05, 0.02},
                               {0.28, 0.02},
                               {0.30, 0.3},
                               {0.27, 0.3},
                               {0.31, 0.58},
                               {0.32, 0.61},
                               {0.35, 0.62},
                               {0.41, 0.3},
                               {0.37, -0.06},
                               {0.2, -0.07},
                               {0.3, 0.6}}) {
        if (profile.contains(r, y)) continue;
        double all = 0, part = 0;
        constexpr int n = 24;
        for (int k = -n; k < n; ++k)
            for (int j = -n; j < n; ++j)
                for (int i = -n; i < n; ++i) {
                    const Vec<double> d{(i + 0.5) / n, (j + 0.5) / n, (k + 0.5) / n};
                    const double value = CubicSpline::value(length(d));
                    all += value;
                    if (value > 0 && hidden({r, y, 0}, Vec<double>{r, y, 0} + reach * d))
                        part += value;
                }
        worst = std::max(worst, std::fabs(shade.at(r, y).part - part / all));
        const double plane = CubicSpline::beyond(profile.nearest(r, y).distance / reach);
        byPlane = std::max(byPlane, std::fabs(plane - part / all));
    }
    REQUIRE(report("part, of the whole kernel", worst, 5e-3));
    note("by the plane that is nearest it would be off by", byPlane);
    REQUIRE(byPlane > 0.05);
}

// The grid's own points fall on its wall, its bottom and its corner.
TEST_CASE("turned: a straight beaker hides what planes do", "[liquid]") {
    const double reach = 0.075;
    const TurnedShade shade(
        Profile({{0, -0.1}, {0.4, -0.1}, {0.4, 0.6}, {0.3, 0.6}, {0.3, 0}, {0, 0}}), reach);
    double worst = 0;
    for (const double r : {0.1, 0.26, 0.28, 0.29, 0.295, 0.299})
        for (const double y : {0.001, 0.005, 0.01, 0.02, 0.05, 0.2}) {
            const double open =
                (1 - CubicSpline::beyond((0.3 - r) / reach)) * (1 - CubicSpline::beyond(y / reach));
            worst = std::max(worst, std::fabs(shade.at(r, y).part - (1 - open)));
        }
    // It is round, and its corner is no product.
    REQUIRE(report("part, of the whole kernel", worst, 0.03));
}

TEST_CASE("turned: water stands in a glass as high as it must, and nowhere else",
          "[liquid][figures]") {
    const double radius = 0.3, height = 0.6, spacing = 0.0375;
    auto positions = blockOf(11, 12, 11, spacing, 0.05);
    for (Vec<double>& p : positions) p += {-0.2, 0.03, -0.2};
    Collider glass{.solid = Solid::turned(tumbler(radius, height, 2 * spacing))};
    glass.staticFriction = glass.dynamicFriction = 0;
    Pool pool(std::move(positions), spacing, {glass});
    pool.fall();
    SolverOptions options = perSecond(1200);
    options.damping = 0.2;
    Solver<float> solver(pool.world, options);
    for (int frame = 0; frame < 150; ++frame) solver.frame();
    const std::vector<Vec<double>> x = solver.positions();
    double centre = 0, nearest = infinity;
    for (const Vec<double>& p : x) {
        centre += p.y / static_cast<double>(x.size());
        nearest = std::min(nearest, sideOf(glass.solid, p).distance);
        REQUIRE(std::hypot(p.x, p.z) < 1.1 * radius);
    }
    // The height of the centre of a frustum that holds as much.
    const double volume = static_cast<double>(x.size()) * std::pow(spacing, 3);
    double filled = 0, moment = 0, level = 0;
    for (const double step = 1e-5; filled < volume; level += step) {
        const double r = radius * (1 + 0.1 * level / height), slice = pi * r * r * step;
        filled += slice;
        moment += level * slice;
    }
    note("level, m", level);
    note("height of the centre", centre / (moment / volume));
    REQUIRE(report("height of the centre", std::fabs(centre / (moment / volume) - 1), 0.02));
    REQUIRE(nearest > 0);
    REQUIRE(solver.failures() == 0);
}

// Thrown about in a jar at 10 m/s: along its bottom, into its corners, against its lid.
TEST_CASE("turned: nothing is thrown out of a jar", "[liquid][colliders]") {
    const double spacing = 0.05;
    Collider glass{.solid = Solid::turned(jar(0.3, 0.6, 0.01))};
    for (const Vec<double>& speed :
         {Vec<double>{10, 0, 0}, {0, -10, 0}, {7, -7, 0}, {-6, 5, 6}, {0, 10, 1}}) {
        auto positions = blockOf(5, 5, 5, spacing, 0.05);
        for (Vec<double>& p : positions) p += {-0.12, 0.15, -0.12};
        Pool pool(std::move(positions), spacing, {glass});
        for (Vec<double>& v : pool.world.velocity) v = speed;
        pool.fall();
        Solver<float> solver(pool.world, perSecond(1000));
        for (int frame = 0; frame < 25; ++frame) {
            solver.frame();
            for (const Vec<double>& p : solver.positions()) {
                REQUIRE(sideOf(glass.solid, p).distance > 0);
                REQUIRE(std::hypot(p.x, p.z) < 0.33);
                REQUIRE(p.y > 0);
                REQUIRE(p.y < 0.6);
            }
            REQUIRE(solver.failures() == 0);
        }
    }
}
