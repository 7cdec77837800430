#include "phase_plane.h"

#include "demos/study/tables.h"
#include "demos/tools/files.h"
#include "demos/tools/web_page.h"
#include "scenes/scene.h"

#include <plait/numbers/elementary.h>
#include <plait/solver.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plait {
namespace {

constexpr double spiralStep = 0.1, ellipseStep = 0.5;
constexpr int spiralSteps = 189, bandSteps = 75;  // three turns, six
constexpr int polygons[] = {3, 4, 6, 12};

std::vector<ChartPoint> pointsOf(const std::vector<PhasePoint>& orbit) {
    std::vector<ChartPoint> points;
    for (const PhasePoint& z : orbit) points.push_back({z.x, z.v});
    return points;
}

std::vector<ChartPoint> circle() {
    std::vector<ChartPoint> points;
    for (int i = 0; i < 180; ++i) {
        const double angle = i * std::numbers::pi / 90;
        points.push_back({std::cos(angle), std::sin(angle)});
    }
    return points;
}

Chart phaseChart(const std::string& title, double size) {
    const Axis x{.label = "displacement x [m]", .low = -size, .high = size};
    const Axis v{.label = "velocity v [m/s]", .low = -size, .high = size};
    return {.title = title, .x = x, .y = v, .equalScale = true};
}

// Three turns of each, with a mark where it ends.
Chart spiralChart() {
    Chart chart = phaseChart("Steps of 0.1 s, three turns", 2.7);
    const auto add = [&](const std::string& name, Method method, CurveStyle style) {
        const auto points = pointsOf(springOrbit(method, spiralStep, spiralSteps));
        chart.curves.push_back({.points = {points.back()}, .style = style});
        style.marker = Marker::none;
        chart.curves.push_back({.name = name, .points = points, .style = style});
    };
    add("explicit: spirals out", Method::explicitEuler, {1, Marker::square, Dash::solid});
    add("implicit: spirals in", Method::implicit, {2, Marker::triangle, Dash::dashed});
    add("symplectic: closes", Method::symplectic, {0, Marker::disc, Dash::solid});
    return chart;
}

Chart polygonChart() {
    Chart chart = phaseChart("Symplectic: n-gons at h = 2 sin(π/n)", 2.3);
    int i = 1;
    for (const int n : polygons) {
        CurveStyle style = curveStyle(i++);
        style.dash = Dash::solid;
        char name[64];
        std::snprintf(name, sizeof name, "n = %d, h = %.4f s", n, polygonStep(n));
        chart.curves.push_back(
            {.name = name,
             .points = pointsOf(springOrbit(Method::symplectic, polygonStep(n), n - 1)),
             .style = style,
             .closed = true});
    }
    return chart;
}

Chart ellipseChart() {
    Chart chart = phaseChart("Symplectic, h = 1/2: bands between two ellipses", 1.4);
    const auto first = springOrbit(Method::symplectic, ellipseStep, bandSteps);
    const auto second = positionFirstOrbit(ellipseStep, bandSteps);
    chart.curves = {{.name = "velocity first",
                     .points = pointsOf(first),
                     .style = {1, Marker::none, Dash::solid}},
                    {.name = "position first",
                     .points = pointsOf(second),
                     .style = {4, Marker::none, Dash::solid}},
                    {.name = "exact", .points = circle(), .style = theoryStyle, .closed = true}};
    return chart;
}

std::string figure(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", value);
    return text;
}

Table spiralTable() {
    Table table{{"spiral, 189 steps", "h [s]", "radius a step, exact", "greatest error / radius"}};
    const auto add = [&](const std::string& name, Method method, int sign) {
        for (const double h : {0.01, 0.1, 0.5}) {
            char step[16], growth[32];
            std::snprintf(step, sizeof step, "%g", h);
            std::snprintf(growth, sizeof growth, "%.8f", std::pow(1 + h * h, sign / 2.0));
            table.push_back({name, step, growth,
                             figure(spiralError(springOrbit(method, h, spiralSteps), h, sign))});
        }
    };
    add("explicit", Method::explicitEuler, 1);
    add("implicit", Method::implicit, -1);
    return table;
}

Table polygonTable() {
    Table table{{"n-gon", "h = 2 sin(π/n) [s]", "distance after n steps"}};
    for (int n = 3; n <= 24; ++n) {
        char step[32];
        std::snprintf(step, sizeof step, "%.16f", polygonStep(n));
        const PhasePoint end = springOrbit(Method::symplectic, polygonStep(n), n).back();
        table.push_back({std::to_string(n), step, figure(std::hypot(end.x - 1, end.v))});
    }
    return table;
}

Table energyTable() {
    Table table{{"modified energy, 20,000 steps", "h [s]", "greatest change [J]"}};
    for (const double h : {0.5, 1.0, std::numbers::sqrt2, 1.9}) {
        char step[16];
        std::snprintf(step, sizeof step, "%g", h);
        table.push_back({"velocity first", step,
                         figure(energyDrift(springOrbit(Method::symplectic, h, 20000), h))});
        table.push_back(
            {"position first", step, figure(energyDrift(positionFirstOrbit(h, 20000), -h))});
    }
    return table;
}

}  // namespace

std::vector<PhasePoint> springOrbit(Method method, double h, int steps) {
    Scene scene = build(findScene("unit-spring"));
    scene.options.method = method;
    scene.options.integrator = Integrator::first;
    scene.options.schedule = {.substeps = 1, .frameRate = {1, 1}, .iterations = 1};
    scene.options.timeScale = h;
    Solver<double> solver(scene.world, scene.options);
    std::vector<PhasePoint> orbit{{1, 0}};
    for (int i = 0; i < steps; ++i) {
        solver.frame();
        orbit.push_back({solver.positions()[0].x, solver.velocities()[0].x});
    }
    return orbit;
}

std::vector<PhasePoint> positionFirstOrbit(double h, int steps) {
    std::vector<PhasePoint> orbit{{1, 0}};
    for (int i = 0; i < steps; ++i) {
        auto [x, v] = orbit.back();
        x += h * v;
        v -= h * x;
        orbit.push_back({x, v});
    }
    return orbit;
}

double polygonStep(int n) { return 2 * sine(std::numbers::pi / n); }

double modifiedEnergy(PhasePoint z, double h) {
    return (z.x * z.x + z.v * z.v - h * z.x * z.v) / 2;
}

double spiralError(const std::vector<PhasePoint>& orbit, double h, int sign) {
    double worst = 0;
    for (std::size_t n = 0; n < orbit.size(); ++n) {
        const double steps = static_cast<double>(n), angle = -steps * std::atan(h);
        const double radius = std::pow(1 + h * h, sign * steps / 2);
        const double off = std::hypot(orbit[n].x - radius * std::cos(angle),
                                      orbit[n].v - radius * std::sin(angle));
        worst = std::max(worst, off / radius);
    }
    return worst;
}

double energyDrift(const std::vector<PhasePoint>& orbit, double h) {
    double worst = 0;
    for (const PhasePoint& z : orbit)
        worst = std::max(worst, std::abs(modifiedEnergy(z, h) - modifiedEnergy(orbit[0], h)));
    return worst;
}

Figure phasePlaneFigure() {
    return {.title = phasePlaneTitle,
            .note =
                "from x = 1 m at rest, clockwise; explicit gains √(1 + h²) a step, implicit "
                "loses it, symplectic stays on x² + v² − h x v = 1 up to h = 2",
            .charts = {spiralChart(), polygonChart(), ellipseChart()},
            .columns = 3,
            .legendBelow = true};
}

void writePhasePlane(const std::filesystem::path& folder, bool quiet) {
    makeFolder(folder);
    const Figure figure = phasePlaneFigure();
    writeFigure(folder / "chart", figure);
    writeWhole(
        folder / "index.html",
        webPage(figure.title, "<p>" + escaped(figure.note) + "</p>\n" +
                                  pictureLine("chart", figure.title) + htmlOf(spiralTable()) +
                                  htmlOf(energyTable()) + htmlOf(polygonTable()) +
                                  commandLines("build/plait study phase-plane")));
    if (!quiet) std::printf("%s\n", (folder / "index.html").c_str());
}

}  // namespace plait
