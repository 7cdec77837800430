// The phase plane of the unit spring (Stam 2009, figures 3 to 6) against closed forms (validation
// A0).
#include "demos/study/pages/phase_plane.h"
#include "demos/tools/files.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace plait;
using namespace plait::test;

TEST_CASE("phase plane: explicit spirals out and implicit in, by the formula",
          "[phase][IN2][IN3][FX35]") {
    double out = 0, in = 0;
    for (const double h : {0.01, 0.1, 0.5}) {
        out = std::max(out, spiralError(springOrbit(Method::explicitEuler, h, 189), h, 1));
        in = std::max(in, spiralError(springOrbit(Method::implicit, h, 189), h, -1));
    }
    CHECK(report("growth, 189 steps, over the radius", out, 1e-12));
    CHECK(report("decay, 189 steps, over the radius", in, 1e-12));
    // The error is one: a circle is no spiral, and the other spiral is not this one.
    CHECK(spiralError(springOrbit(Method::symplectic, 0.1, 189), 0.1, 1) > 0.1);
    CHECK(spiralError(springOrbit(Method::implicit, 0.1, 189), 0.1, 1) > 0.1);
    CHECK(spiralError({{1, 0}, {1, -0.5}}, 0.5, 1) < 1e-15);
}

TEST_CASE("phase plane: n-gons close, and not before", "[phase][IN5][FX35]") {
    double worst = 0;
    for (int n = 3; n <= 24; ++n) {
        const auto orbit = springOrbit(Method::symplectic, polygonStep(n), n);
        REQUIRE(orbit.size() == static_cast<std::size_t>(n) + 1);
        for (int i = 1; i <= n; ++i) {
            const auto [x, v] = orbit[static_cast<std::size_t>(i)];
            const double off = std::hypot(x - 1, v);
            REQUIRE(std::isfinite(off));
            if (i < n) CHECK(off > 0.1);
            if (i == n) worst = std::max(worst, off);
        }
        CHECK(std::abs(polygonStep(n) - 2 * std::sin(std::numbers::pi / n)) < 1e-15);
    }
    CHECK(report("closure of the n-gons, n = 3 to 24", worst, 1e-12));
}

TEST_CASE("phase plane: symplectic orbits stay on their ellipses", "[phase][IN5]") {
    double velocity = 0, position = 0;
    for (const double h : {0.5, 1.0, std::numbers::sqrt2, 1.9}) {
        velocity = std::max(velocity, energyDrift(springOrbit(Method::symplectic, h, 20000), h));
        position = std::max(position, energyDrift(positionFirstOrbit(h, 20000), -h));
    }
    CHECK(report("modified energy, velocity first, 20,000 steps", velocity, 1e-13));
    CHECK(report("modified energy, position first, 20,000 steps", position, 1e-13));
    // Either one's ellipse is not the other's.
    CHECK(energyDrift(springOrbit(Method::symplectic, 0.5, 100), -0.5) > 0.1);
    CHECK(energyDrift(positionFirstOrbit(0.5, 100), 0.5) > 0.1);
}

// A step turns by 2 asin(h/2) of the ellipse made round, so that its chord comes to cos asin(h/2)
// of the radius in the middle: what steps of 1/2 s fill lies between two ellipses.
TEST_CASE("phase plane: chords touch the inner ellipse", "[phase][IN5]") {
    const double h = 0.5;
    double worst = 0;
    const auto orbit = springOrbit(Method::symplectic, h, 1000);
    for (std::size_t i = 1; i < orbit.size(); ++i) {
        const PhasePoint middle{(orbit[i - 1].x + orbit[i].x) / 2,
                                (orbit[i - 1].v + orbit[i].v) / 2};
        worst = std::max(worst, std::abs(modifiedEnergy(middle, h) - (1 - h * h / 4) / 2));
    }
    CHECK(report("modified energy in the middle of steps", worst, 1e-13));
}

TEST_CASE("phase plane: a slide and its page", "[phase]") {
    const Figure figure = phasePlaneFigure();
    REQUIRE(figure.charts.size() == 3);
    for (const Chart& chart : figure.charts) {
        CHECK(chart.equalScale);
        for (const Curve& curve : chart.curves) {
            CAPTURE(chart.title, curve.name);
            REQUIRE(!curve.points.empty());
            for (const auto& [x, y] : curve.points)  // nothing is cut off
                REQUIRE((std::abs(x) < *chart.x.high && std::abs(y) < *chart.y.high));
        }
    }
    const ScratchFolder folder;
    writePhasePlane(folder / "phase-plane", true);
    CHECK(folder.count() == 1);
    for (const char* name : {"chart.svg", "chart.png", "index.html"})
        CHECK(std::filesystem::file_size(folder / "phase-plane" / name) > 1000);
    const std::string page = readWhole(folder / "phase-plane" / "index.html");
    for (const char* words :
         {"<h1>One spring", "src=\"chart.svg\"", "1.7320508075688772", "0.2610523844401031",
          "<td>explicit</td><td>0.1</td><td>1.00498756</td>", "plait study phase-plane"})
        CHECK(page.find(words) != std::string::npos);
    CHECK(page.find("nan") == std::string::npos);
}
