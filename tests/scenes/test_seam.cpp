// A seam lies where it is told to, evenly, and moves with its surface.
#include "scenes/parts/seam.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

// Ellipsoids of these half axes around these places, which move up by t.
MovingSurface ellipsoids(const std::vector<Vec<double>>& axes,
                         const std::vector<Vec<double>>& places) {
    const Shape ball = sphere({.subdivisions = 5});
    MovingSurface surface;
    std::vector<Vec<double>> all;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const int first = static_cast<int>(all.size());
        for (int t = 0; t < ball.complex.count(2); ++t) {
            const auto ids = ball.complex.triangle(t);
            surface.triangles.push_back({first + ids[0], first + ids[1], first + ids[2]});
        }
        for (const Vec<double>& x : ball.positions)
            all.push_back(places[i] +
                          Vec<double>{axes[i].x * x.x, axes[i].y * x.y, axes[i].z * x.z});
    }
    surface.positions = [all](double t) {
        std::vector<Vec<double>> x = all;
        for (Vec<double>& a : x) a.y += t;
        return x;
    };
    return surface;
}

}  // namespace

TEST_CASE("seam: around a ball it is a circle of even points", "[seam]") {
    const Seam seam(ellipsoids({{1, 1, 1}}, {{0, 0, 0}}), {}, 0.1, 0.3, 40);
    const std::vector<Vec<double>> x = seam.at(0.25);
    REQUIRE(x.size() == 40);
    double worst = 0;
    for (int i = 0; i < 40; ++i) {
        const double angle = 2 * 3.141592653589793 * i / 40;
        const Vec<double> out{std::cos(angle), 0, std::sin(angle)};
        worst = std::max(worst, length(x[i] - 1.1 * out - Vec<double>{0, 0.25, 0}));
        worst = std::max(worst, length(seam.outwards()[i] - out));
    }
    // The ball has flat faces: its edges are 0.04 long, and their middles 2e-4 inside.
    CHECK(report("off the circle, m", worst, 2e-3));
}

// On an ellipse of 2 : 1 equal steps of the seam itself would be a third apart further out.
TEST_CASE("seam: its points are even where they are told to be", "[seam]") {
    const double flare = 0.5;
    const Seam seam(ellipsoids({{1, 1, 0.5}}, {{0, 0, 0}}), {}, 0, flare, 64);
    const std::vector<Vec<double>> x = seam.at(0);
    double least = 1e300, most = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t j = (i + 1) % x.size();
        const double apart =
            length(x[j] + flare * seam.outwards()[j] - x[i] - flare * seam.outwards()[i]);
        least = std::min(least, apart), most = std::max(most, apart);
        CHECK(std::fabs(x[i].x * x[i].x + 4 * x[i].z * x[i].z - 1) < 2e-3);
    }
    CHECK(report("unevenness", most / least - 1, 0.05));
}

TEST_CASE("seam: it takes the line around the origin, and needs one", "[seam]") {
    const MovingSurface two = ellipsoids({{0.2, 0.2, 0.2}, {1, 1, 1}}, {{2, 0, 0}, {0, 0, 0}});
    for (const Vec<double>& x : Seam(two, {}, 0, 0, 16).at(0))
        CHECK(std::fabs(length(x) - 1) < 1e-3);
    CHECK_THROWS_WITH(Seam(two, {.origin = {0, 5, 0}}, 0, 0, 16),
                      Catch::Matchers::EndsWith("no closed line"));
}
