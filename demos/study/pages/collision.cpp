#include "collision.h"

#include "demos/study/tables.h"
#include "demos/tools/files.h"
#include "demos/tools/web_page.h"

#include <plait/collision/polynomials.h>
#include <plait/collision/query.h>
#include <plait/collision/roots.h>
#include <plait/constraints/constants.h>
#include <plait/numbers/elementary.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

MovingVertex onLine(const LineParticle& p) { return {{p.start, 0, 0}, {p.end, 0, 0}}; }

double at(const LineParticle& p, double t) { return p.start + t * (p.end - p.start); }

constexpr LineParticle left{0.1, 0.8}, right{0.9, 0.4};
const std::vector<LineParticle> trio{{0.08, 0.75}, {0.5, 0.42}, {0.93, 0.3}};

Chart lineChart(const std::string& title) {
    return {.title = title,
            .x = {.label = "place on the line", .low = 0, .high = 1},
            .y = {.label = "time / step", .low = 0, .high = 1}};
}

// Paths of particles, each in its style, with marks where they begin and end.
void addPaths(Chart& chart, const std::vector<LineParticle>& particles) {
    for (std::size_t i = 0; i < particles.size(); ++i)
        chart.curves.push_back({.points = {{particles[i].start, 0}, {particles[i].end, 1}},
                                .style = curveStyle(static_cast<int>(i))});
}

double timeOfMeeting() {
    const Impact impact = thinPointPoint(onLine(left), onLine(right));
    if (!impact) throw std::logic_error("collision: left and right meet");
    return *impact;
}

Chart meetingChart() {
    Chart chart = lineChart("V₀ V₁ < 0: met at t = V₀ / (V₀ − V₁)");
    addPaths(chart, {left, right});
    const double t = timeOfMeeting();
    chart.curves.push_back(
        {.points = {{at(left, t), t}}, .style = {.color = 3, .marker = Marker::diamond}});
    return chart;
}

// The paths as they are after the meeting: a corner where it is.
Chart bounceChart(const std::string& title, double restitution) {
    Chart chart = lineChart(title);
    const double t = timeOfMeeting();
    const std::vector<LineParticle> after = resolveOnLine({left, right}, restitution, 1).back();
    addPaths(chart, {left, right});
    for (std::size_t i = 0; i < 2; ++i)
        chart.curves[i].points = {
            {at(i ? right : left, 0), 0}, {at(left, t), t}, {after[i].end, 1}};
    return chart;
}

struct Case {
    const char *name, *figure;
    int degree;
    std::vector<double> coefficients;  // Bernstein
    std::vector<double> roots;
    Impact impact;
};

template <int n>
Case caseOf(const char* name, const char* figure, const Bernstein<n>& p, Impact impact) {
    Case made{name, figure, n, {p.c, p.c + n + 1}, {}, impact};
    for (const auto& bracket : isolateRoots(p))
        made.roots.push_back((bracket.low + bracket.high) / 2);
    return made;
}

double value(std::vector<double> c, double t) {  // de Casteljau
    for (std::size_t n = c.size(); n-- > 1;)
        for (std::size_t i = 0; i < n; ++i) c[i] += t * (c[i + 1] - c[i]);
    return c[0];
}

// One of each, that pass: closer than 0.3 for a while, the last two twice.
std::vector<Case> thickCases() {
    constexpr double h = 0.3;
    const auto turning = [](double length, double from, double to, double z) {
        return MovingVertex{{length * cosine(from), length * sine(from), z},
                            {length * cosine(to), length * sine(to), z}};
    };
    const MovingVertex still{{0, 0, 0}, {0, 0, 0}};
    const MovingVertex passing{{-1.2, 0.1, 0.1}, {1, 0.1, 0.1}};
    const MovingVertex up{{-0.9, -0.9, 0.1}, {0.9, 0.2, -0.1}};
    const MovingVertex a = turning(0.9, -0.6, 2.6, 0), b = turning(-0.9, -0.6, 2.6, 0);
    const MovingVertex p{{0.1, 0.05, 0.9}, {0.05, 0.1, -0.8}};
    const MovingVertex u{{-1, -0.7, -0.2}, {-1, -0.7, 0.3}}, v{{1, -0.7, 0.4}, {1, -0.7, -0.4}},
        w{{0, 1, 0.3}, {0, 1, -0.2}};
    const MovingVertex c{{-0.8, 0.3, 0.8}, {-0.8, -0.3, -0.9}},
        d{{0.8, 0.2, 0.7}, {0.8, 0.3, -0.7}};
    const MovingVertex e{{0.1, -0.8, 0.2}, {0.3, -0.8, -0.2}}, f{{-0.2, 0.8, -0.2}, {0, 0.8, 0.3}};
    const auto one = pointPoint<double>(still, passing, h);
    const auto two = pointEdge<double>(up, a, b, h);
    const auto three = pointTriangle<double>(p, u, v, w, h);
    const auto four = edgeEdge<double>(c, d, e, f, h);
    return {caseOf("point and point", "quadratic", pointPolynomial(one.corner[0], one.thickness),
                   thickPointPoint(still, passing, h)),
            caseOf("point and edge", "quartic",
                   linePolynomial(two.corner[0], two.side[0], two.thickness),
                   thickPointEdge(up, a, b, h)),
            caseOf("point and triangle", "sextic",
                   planePolynomial(three.corner[0], three.side[0], three.side[1], three.thickness),
                   thickPointTriangle(p, u, v, w, h)),
            caseOf("edge and edge", "sextic",
                   planePolynomial(four.corner[0], four.side[0], four.side[1], four.thickness),
                   thickEdgeEdge(c, d, e, f, h))};
}

Chart polynomialChart(const Case& of) {
    Chart chart{.title = std::string(of.name) + ": " + of.figure,
                .x = {.label = "time / step", .low = 0, .high = 1},
                .y = {.label = "p / greatest, signed square root"}};
    Curve curve{.name = "p: 0 where line or plane is h away",
                .style = {.color = 0, .marker = Marker::none, .dash = Dash::solid}};
    double most = 0;
    for (int i = 0; i <= 400; ++i) {
        curve.points.push_back({i / 400.0, value(of.coefficients, i / 400.0)});
        most = std::max(most, std::fabs(curve.points.back().y));
    }
    for (ChartPoint& point : curve.points)
        point.y = std::copysign(std::sqrt(std::fabs(point.y) / most), point.y);
    chart.curves.push_back(std::move(curve));
    Curve roots{.name = "roots, isolated",
                .style = {.color = 1, .marker = Marker::disc, .dash = Dash::none}};
    for (const double root : of.roots) roots.points.push_back({root, 0});
    chart.curves.push_back(std::move(roots));
    if (of.impact)
        chart.curves.push_back(
            {.name = "the query's answer",
             .points = {{*of.impact, 0}},
             .style = {.color = 3, .marker = Marker::square, .dash = Dash::none, .open = true}});
    chart.curves.push_back({.points = {{0, 0}, {1, 0}}, .style = theoryStyle});
    return chart;
}

Table caseTable() {
    Table table{{"pair", "degree", "roots in the step", "answer"}};
    for (const Case& of : thickCases()) {
        char answer[32] = "never";
        if (of.impact) std::snprintf(answer, sizeof answer, "%.6f", *of.impact);
        table.push_back(
            {of.name, std::to_string(of.degree), std::to_string(of.roots.size()), answer});
    }
    return table;
}

}  // namespace

std::vector<std::vector<LineParticle>> resolveOnLine(std::vector<LineParticle> particles,
                                                     double restitution, int most) {
    std::vector<std::vector<LineParticle>> stages{particles};
    while (static_cast<int>(stages.size()) <= most) {
        Impact first;
        std::size_t which = 0;
        for (std::size_t i = 0; i + 1 < particles.size(); ++i) {
            // Those that end where they met do not meet again.
            if (particles[i].end <= particles[i + 1].end) continue;
            const Impact t = thinPointPoint(onLine(particles[i]), onLine(particles[i + 1]));
            if (t && (!first || *t < *first)) first = t, which = i;
        }
        if (!first) break;
        LineParticle &a = particles[which], &b = particles[which + 1];
        const double u = a.end - a.start, v = b.end - b.start, mean = (u + v) / 2;
        const double apart = restitution * (u - v) / 2, rest = 1 - *first;
        const double met = (at(a, *first) + at(b, *first)) / 2;
        a.end = met + rest * (mean - apart);
        b.end = met + rest * (mean + apart);
        stages.push_back(particles);
    }
    return stages;
}

Found foundBullets(double length, int count) {
    constexpr double thickness = 1e-3, golden = 0.61803398874989485;
    constexpr MovingVertex a{{-1, -1, 0}, {-1, -1, 0}}, b{{1, -1, 0}, {1, -1, 0}},
        c{{0, 1, 0}, {0, 1, 0}};
    const auto part = [](double x) { return x - std::floor(x); };
    Found found{0, 0};
    for (int i = 0; i < count; ++i) {
        const double passed = part(golden * i), angle = 2 * pi * part(std::sqrt(2.0) * i);
        const double tilt = part(std::sqrt(3.0) * i);
        const Vec<double> slant{tilt * cosine(angle), tilt * sine(angle), -1};
        const Vec<double> step = length * thickness / plait::length(slant) * slant;
        const Vec<double> hole{0.2 * cosine(3 * angle), 0.2 * sine(3 * angle), 0};
        const MovingVertex bullet{hole - passed * step, hole + (1 - passed) * step};
        found.atEnd += std::fabs(bullet.end.z) <= thickness;
        found.onTheWay += thickPointTriangle(bullet, a, b, c, thickness).has_value();
    }
    return {found.atEnd / count, found.onTheWay / count};
}

Figure spaceTimeFigure() {
    const auto stages = resolveOnLine(trio, 1, 16);
    Chart predicted = lineChart("Three, as predicted"), once = lineChart("After the first meeting"),
          last = lineChart("All of them: " + std::to_string(stages.size() - 1) + " meetings");
    addPaths(predicted, stages.front());
    addPaths(once, stages[1]);
    addPaths(last, stages.back());
    return {.title = "On a line: two that met, and three in a fixed step",
            .note =
                "after Stam 2009, figures 15, 16 and 20: paths are changed, earliest meeting "
                "first, nothing is moved to the time of the meeting",
            .charts = {meetingChart(), bounceChart("Elastic", 1), bounceChart("Inelastic", 0),
                       predicted, once, last},
            .columns = 3};
}

Figure bulletFigure() {
    Curve way{.name = "on the way, in space and time", .style = curveStyle(0)};
    Curve end{.name = "where they are at the end of the step", .style = curveStyle(1)};
    for (double length = 1; length < 2e5; length *= std::sqrt(10.0)) {
        const Found found = foundBullets(length, 2000);
        way.points.push_back({length, found.onTheWay});
        end.points.push_back({length, found.atEnd});
    }
    return {.title = "2,000 bullets at a sheet",
            .note = "after Stam 2009, figure 14; all of them hit, at slants of up to 45 degrees",
            .charts = {{.x = {.label = "thicknesses a step", .logarithmic = true},
                        .y = {.label = "part that is found", .low = 0, .high = 1.05},
                        .curves = {way, end}}},
            .legendBelow = true};
}

Figure thickFigure() {
    Figure figure{.title = "Closer than the thickness: degrees 2, 4, 6 and 6",
                  .note =
                      "after Stam 2009, figure 19; a root is an impact only where what is "
                      "nearest lies within both",
                  .columns = 2};
    for (const Case& of : thickCases()) figure.charts.push_back(polynomialChart(of));
    return figure;
}

void writeCollision(const std::filesystem::path& folder, bool quiet) {
    makeFolder(folder);
    std::string body;
    const auto add = [&](const char* name, const Figure& figure) {
        writeFigure(folder / name, figure);
        body += "<p>" + escaped(figure.note) + "</p>\n" + pictureLine(name, figure.title);
    };
    add("space-time", spaceTimeFigure());
    add("bullet", bulletFigure());
    add("thick", thickFigure());
    writeWhole(folder / "index.html",
               webPage(collisionTitle,
                       body + htmlOf(caseTable()) + commandLines("build/plait study collision")));
    if (!quiet) std::printf("%s\n", (folder / "index.html").c_str());
}

}  // namespace plait
