// The air on a plate, against closed forms.
#include "air_run.h"
#include "tests/catch.h"
#include "tests/report.h"

using namespace plait;
using namespace plait::test;

namespace {

// Force on a unit plate at rest whose normal is at the angle `tilt` to y, in a wind along y.
Vec<double> force(AirOptions options, double speed, double tilt) {
    options.wind.velocity = steady({0, speed, 0});
    constexpr double h = 1e-9;
    Run run(plate(tilt), options);
    run.blow(h);
    return (1 / h) * run.air.impulse();
}

double slope(const AirOptions& options, double tilt, const Vec<double>& direction) {
    const auto size = [&](double speed) { return dot(force(options, speed, tilt), direction); };
    return std::log2(size(16) / size(4)) / 2;
}

}  // namespace

TEMPLATE_TEST_CASE("A plate falls by the scheme's formula and converges to the exponential",
                   "[air]", float, double) {
    const double c = 1.2 * 2.5, end = sigma / c, vt = sigma * g / c;
    double last = 0;
    for (const int n : {20, 40, 80}) {
        const double h = end / n;
        Run<TestType> run(plate(0), {.form = legacy, .density = 1.2, .drag = 2.5});
        double v = 0, formula = 0;
        for (int s = 0; s < n; ++s) {
            run.fall(1, h);
            v = (v - h * g) / (1 + h * c / sigma);
            formula = std::max(formula, deviation(run.state, {0, v, 0}));
        }
        CHECK(report("against v' = (v + h g) / (1 + h c / sigma)", formula,
                     sizeof(TestType) == 4 ? 1e-6 : 1e-12));
        const double error = std::fabs(-v / vt - (1 - std::exp(-1.0)));
        CHECK(report("after tau, against 0.632121", error, 0.3 / n));
        if (last > 0) CHECK(std::log2(last / error) == Approx(1).margin(0.02));
        last = error;
    }
}

TEST_CASE("Terminal velocity is exact for any substep", "[air][AW8]") {
    const double c = 3, cq = 0.6 * 1.3, tau = 0.125;
    for (const double h : {1e-3, 0.1, 10.0}) {
        const int n = 200 + static_cast<int>(20 / h);
        const auto fallen = [&](const AirOptions& options, double tilt) {
            Run run(plate(tilt), options);
            run.fall(n, h);
            return run.velocity();
        };
        const AirOptions linear{.form = legacy, .density = 1.5, .drag = 2, .tangentialDrag = tau};
        const AirOptions square{.density = 1.2, .drag = 1.3, .tangentialDrag = tau};
        const double vt = sigma * g / c, vq = std::sqrt(sigma * g / cq);
        const auto error = [](const Vec<double>& v, double x, double y) {
            return length(v - Vec<double>{x, y, 0}) / std::hypot(x, y);
        };
        CHECK(report("legacy, broadside", error(fallen(linear, 0), 0, -vt), 1e-12));
        CHECK(report("legacy, edge-on", error(fallen(linear, edgeOn), 0, -vt / tau), 1e-12));
        CHECK(report("physical, broadside", error(fallen(square, 0), 0, -vq), 1e-12));
        CHECK(report("physical, edge-on", error(fallen(square, edgeOn), 0, -vq / std::sqrt(tau)),
                     1e-12));

        // Held at an angle it glides: along the normal and along the plate, each at its own speed.
        const double phi = 0.6, cosine = std::cos(phi), sine = std::sin(phi);
        const Vec<double> v = fallen(linear, phi), w = fallen(square, phi);
        const Vec<double> normal{-sine, cosine, 0}, along{cosine, sine, 0};
        const auto glide = [&](const Vec<double>& u, double un, double ut) {
            return std::hypot(dot(u, normal) + un, dot(u, along) + ut) / std::hypot(un, ut);
        };
        CHECK(report("legacy, gliding", glide(v, vt * cosine, vt * sine / tau), 1e-12));
        CHECK(report("physical, gliding",
                     glide(w, vq * std::sqrt(cosine), vq * std::sqrt(sine / tau)), 1e-12));
    }
}

TEST_CASE("Quadratic drag converges to tanh", "[air]") {
    const double c = 0.6 * 1.2, vt = std::sqrt(sigma * g / c);
    const double exact[] = {0.761594, 0.964028, 0.995055};
    for (int k = 0; k < 3; ++k) {
        double last = 0;
        for (const int n : {100, 200, 400}) {
            Run run(plate(0), {.density = 1.2, .drag = 1.2});
            run.fall(n, (k + 1) * vt / g / n);
            const double error = std::fabs(-run.velocity().y / vt - exact[k]);
            CHECK(report("v / v_t at t g / v_t = " + std::to_string(k + 1), error, 0.7 / n));
            if (last > 0) CHECK(std::log2(last / error) == Approx(1).margin(0.06));
            last = error;
        }
    }
}

TEST_CASE("An interval of three is one push of three substeps, and none between", "[air]") {
    constexpr double h = 0.01;
    AirOptions options{.lift = 0.5, .wind = {steady({3, 1, 2})}};
    Run every(plate(0.4), options);
    options.interval = 3;
    Run third(plate(0.4), options);
    for (long s = 0; s < 12; ++s) {
        third.state.substep = s;
        third.blow(h);
        if (s % 3 == 0) every.blow(3 * h);
        CHECK(third.velocity() == every.velocity());
    }
    CHECK(length(every.velocity()) > 0.1);
}

TEST_CASE("Drag grows with speed and speed squared, lift with speed squared",
          "[air][AW4][AW5][AW6]") {
    const Vec<double> x{1, 0, 0}, y{0, 1, 0};
    for (const AirForm form : {legacy, physical}) {
        const double power = form == legacy ? 1 : 2;
        const AirOptions drag{.form = form, .tangentialDrag = 0.25};
        const AirOptions lift{.form = form, .drag = 0, .tangentialDrag = 0, .lift = 0.5};
        CHECK(slope(drag, 0, y) == Approx(power).margin(1e-6));
        CHECK(slope(drag, edgeOn, y) == Approx(power).margin(1e-6));
        CHECK(slope(lift, 0.7, -x) == Approx(2).margin(1e-6));
        CHECK(slope(lift, -0.7, x) == Approx(2).margin(1e-6));
        // Broadside meets 1 / tau times the drag of edge-on.
        CHECK(force(drag, 3, 0).y / force(drag, 3, edgeOn).y == Approx(4).epsilon(1e-6));
    }
}

TEST_CASE("Forces on a plate are those of the formulas", "[air]") {
    const double rho = 1.2, cd = 0.9, tau = 0.3, cl = 0.4, u = 5;
    double worst = 0;
    for (const double a : {-1.3, -0.4, 0.0, 0.2, 0.8, 1.5}) {
        const double un = u * std::cos(a), ut = u * std::sin(a);
        const Vec<double> normal{-std::sin(a), std::cos(a), 0}, along{std::cos(a), std::sin(a), 0};
        const Vec<double> lift = (un * u) * (normal - (un / u) * Vec<double>{0, 1, 0});
        const Vec<double> one = (rho * cd) * (un * normal + tau * ut * along) + rho * cl * lift;
        const Vec<double> two =
            (rho * cd / 2) * (std::fabs(un) * un * normal + tau * std::fabs(ut) * ut * along) +
            rho * cl / 2 * lift;
        const AirOptions options{.density = rho, .drag = cd, .tangentialDrag = tau, .lift = cl};
        AirOptions old = options;
        old.form = legacy;
        worst = std::max(worst, length(force(old, u, a) - one) / length(one));
        worst = std::max(worst, length(force(options, u, a) - two) / length(two));
        CHECK(std::fabs(lift.y) < 1e-14);  // across the wind
    }
    CHECK(report("force of six angles, both forms", worst, 1e-6));
}

TEST_CASE("Without tangential drag a plate falls edge-on like a knife", "[air][AW8]") {
    for (const AirForm form : {legacy, physical}) {
        Run run(plate(edgeOn), {.form = form, .drag = 10, .tangentialDrag = 0});
        run.fall(1000, 0.01);
        CHECK(report("velocity after 10 s / g t", std::fabs(run.velocity().y / -98.1 - 1), 1e-12));
    }
}

TEST_CASE("A light plate without a preferred direction drifts with the wind", "[air][AW2]") {
    for (const AirForm form : {legacy, physical}) {
        const Vec<double> wind{3, 1, -4};
        Run run(plate(0.4, 1e-3), {.form = form, .tangentialDrag = 1, .wind = {steady(wind)}});
        for (int s = 0; s < 2000; ++s) run.blow(0.01);
        CHECK(report("distance from the wind's velocity", deviation(run.state, wind),
                     form == legacy ? 1e-12 : 1e-3));
    }
}

TEST_CASE("Air density stands for less mass, or for more drag and lift", "[air][AW1][AW7]") {
    for (const AirForm form : {legacy, physical}) {
        const auto after = [&](double mass, const AirOptions& options) {
            Run run(plate(0.7, mass), options);
            run.fall(100, 0.01);
            return run.velocity();
        };
        const Wind wind{steady({4, 2, -1})};
        const auto dense = after(0.5, {.form = form, .density = 2, .lift = 0.5, .wind = wind});
        CHECK(dense == after(0.25, {.form = form, .lift = 0.5, .wind = wind}));
        CHECK(dense == after(0.5, {.form = form, .drag = 2, .lift = 1, .wind = wind}));
        // More mass needs as much more drag and lift.
        CHECK(dense == after(2, {.form = form, .density = 2, .drag = 4, .lift = 2, .wind = wind}));
        CHECK(dense != after(0.5, {.form = form, .lift = 0.5, .wind = wind}));
    }
}

TEST_CASE("A hung sheet is balanced at tan phi = c U / sigma g, pinned row or not", "[air]") {
    // At its angle the normal velocity of every free vertex is 0 after gravity and air: only what
    // the constraints take is left. Pinned vertices bear none of it.
    for (const double ratio : {0.25, 0.5, 1.0, 2.0, 4.0})
        for (const AirForm form : {legacy, physical}) {
            const double u = 3, r = ratio;
            const double sine = (std::sqrt(1 + 4 * r * r) - 1) / (2 * r);  // sin = r cos^2
            const double phi = form == legacy ? std::atan(r) : std::asin(sine);
            World world;
            world.add(grid({.columns = 4, .rows = 9},
                           {.across = {0, 0, 1}, .up = {-std::sin(phi), std::cos(phi), 0}}),
                      {.density = sigma});
            world.pin(world.select(
                {0, 36}, [&](const Vec<double>& x) { return x.y > 0.999 * std::cos(phi); }));
            const double c = form == legacy ? r * sigma * g / u : 2 * r * sigma * g / (u * u);
            Run run(world, {.form = form, .drag = c, .wind = {steady({u, 0, 0})}});
            run.fall(1, 0.5);
            double worst = 0;
            for (const Padded<double>& v : run.state.velocity)
                worst = std::max(worst, std::fabs(v.v.x * std::cos(phi) + v.v.y * std::sin(phi)));
            CHECK(world.pins[0].vertices.size() == 4);
            CHECK(report("normal velocity after 0.5 s at " +
                             std::to_string(phi * 180 / std::numbers::pi) + " degrees",
                         worst, 1e-13));
        }
}

TEST_CASE("A curve meets the air across itself, with the area of its width", "[air]") {
    World world;
    world.add(chain({.links = 10, .to = {2, 0, 0}}), {.density = 0.03});
    const auto drag = [&](const Vec<double>& wind) {
        Run run(world, {.form = legacy,
                        .drag = 2,
                        .tangentialDrag = 0.25,
                        .width = 0.05,
                        .wind = {steady(wind)}});
        run.blow(1e-9);
        return 1e9 * run.air.impulse();
    };
    const double area = 0.1;
    CHECK(report("across", length(drag({0, 3, 4}) - Vec<double>{0, area * 6, area * 8}), 1e-6));
    CHECK(report("along", length(drag({3, 0, 0}) - Vec<double>{area * 1.5, 0, 0}), 1e-6));
    CHECK(report("slanted", length(drag({3, 4, 0}) - Vec<double>{area * 1.5, area * 8, 0}), 1e-6));
    // Edges of a sheet are no curves.
    Run sheet(plate(0), {.form = legacy, .width = 100, .wind = {steady({0, 1, 0})}});
    sheet.blow(1e-9);
    CHECK(report("sheet", std::fabs(1e9 * sheet.air.impulse().y - 1), 1e-6));
}
