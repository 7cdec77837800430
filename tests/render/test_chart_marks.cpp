#include "drawn.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

TEST_CASE("Points land where the axes say", "[chart]") {
    const std::vector<ChartPoint> points{{1, 1e-4}, {4, 0.03}, {9, 1}};
    for (const bool open : {false, true}) {
        const Figure figure =
            figureOf({.x = anyX,
                      .y = errorAxis,
                      .curves = {{.name = "c", .points = points, .style = {.open = open}}}});
        const Drawing drawing = figureDrawing(figure);
        std::vector<Disc> discs = every<Disc>(drawing);
        std::erase_if(discs, [](const Disc& disc) { return disc.radius < 6; });
        REQUIRE(discs.size() == points.size() + 1);  // and the sample in the legend
        for (const ChartPoint& point : points) {
            const double x = across(drawing, "2", "8", (point.x - 2) / 6);
            const double y = up(drawing, "0.001", "0.1", (std::log10(point.y) + 3) / 2);
            CAPTURE(point.x, point.y, x, y);
            CHECK(std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
                return std::hypot(disc.center.x - x, disc.center.y - y) < 1e-6;
            }));
        }
    }
}

TEST_CASE("Failures are marks above the top edge, a row a curve", "[chart]") {
    const auto method = [](int i) {
        return Curve{.name = "m" + std::to_string(i),
                     .points = {{1, 1e-3}, {100, 1e-4}},
                     .style = {i, Marker::disc, Dash::none},
                     .failures = {10}};
    };
    const Drawing drawing =
        figureDrawing(figureOf({.x = workAxis, .y = errorAxis, .curves = {method(1), method(2)}}));
    const double top = up(drawing, "0.0001", "0.001", 1);  // of the points
    const double x = across(drawing, "1", "100", 0.5);
    std::vector<PagePoint> marks;
    for (const Disc& disc : every<Disc>(drawing))
        if (std::abs(disc.center.x - x) < 1e-6 && same(disc.color, ink))
            marks.push_back(disc.center);
    REQUIRE(marks.size() == 2);
    CHECK(marks[0].y < top);
    CHECK(marks[1].y < top);
    CHECK(std::abs(marks[0].y - marks[1].y) > 12);
    const PageBox failed = boxOf(wordOf(drawing, "failed"));
    CHECK((failed.top > marks[0].y - 12 && failed.bottom < marks[1].y + 12));
}

TEST_CASE("The default is ringed, and the front is a staircase beneath the curves", "[chart]") {
    const Curve curve{.name = "m",
                      .points = {{1, 8}, {2, 4}, {4, 2}},
                      .style = {1, Marker::none},
                      .highlighted = 1};
    const Figure figure = figureOf({.x = {.low = 0, .high = 5},
                                    .y = {.low = -10, .high = 20},
                                    .curves = {curve},
                                    .front = {{1, 8}, {2, 4}, {4, 2}}});
    const Drawing drawing = figureDrawing(figure);
    const auto at = [&](double x, double y) {
        return PagePoint{across(drawing, "0", "5", x / 5), up(drawing, "−10", "20", (y + 10) / 30)};
    };
    const auto near = [](PagePoint a, PagePoint b) { return std::hypot(a.x - b.x, a.y - b.y); };
    bool ringed = false;
    std::vector<PagePoint> stairs;
    for (const Stroke& stroke : every<Stroke>(drawing)) {
        if (stroke.closed && same(stroke.color, ink))
            ringed = std::all_of(stroke.points.begin(), stroke.points.end(), [&](PagePoint p) {
                return std::abs(near(p, at(2, 4)) - 13) < 1e-6;
            });
        if (stroke.points.size() > 2 && same(stroke.color, frontColor)) stairs = stroke.points;
        if (stroke.points.size() == 3 && same(stroke.color, curveColor(1)))
            REQUIRE(!stairs.empty());
    }
    CHECK(ringed);
    const PageBox word = boxOf(wordOf(drawing, "default"));
    CHECK(near({(word.left + word.right) / 2, (word.top + word.bottom) / 2}, at(2, 4)) < 80);
    const std::vector<PagePoint> corners{at(1, 20), at(1, 8), at(2, 8), at(2, 4),
                                         at(4, 4),  at(4, 2), at(5, 2)};
    for (const PagePoint corner : corners)
        CHECK(std::any_of(stairs.begin(), stairs.end(),
                          [&](PagePoint p) { return near(p, corner) < 1e-6; }));
    const Picture picture = figurePicture(figure, 1);
    CHECK(same(pixel(picture, at(1, 20).x, at(1, 20).y + 2), frontColor));
    CHECK(same(pixel(picture, at(1, 20).x, at(1, 20).y - 2), chartGround));
}

TEST_CASE("The word default covers no marker, and a line leads to it from afar", "[chart]") {
    Curve around{.style = {2, Marker::square, Dash::none}};
    for (const double reach : {0.25, 0.4})
        for (int i = 0; i < 8; ++i)
            around.points.push_back(
                {5 + reach * std::cos(i * 0.7854), 25 + 2 * reach * std::sin(i * 0.7854)});
    const Drawing drawing =
        figureDrawing(figureOf({.x = {.low = 0, .high = 10},
                                .y = {.low = 20, .high = 30},
                                .curves = {{.points = {{5, 25}}, .highlighted = 0}, around}}));
    const auto at = [&](ChartPoint p) {
        return PagePoint{across(drawing, "0", "10", p.x / 10),
                         up(drawing, "20", "30", p.y / 10 - 2)};
    };
    const PageBox word = boxOf(wordOf(drawing, "default"));
    const auto away = [&](PagePoint p) {
        return std::hypot(p.x - std::clamp(p.x, word.left, word.right),
                          p.y - std::clamp(p.y, word.top, word.bottom));
    };
    for (const ChartPoint& point : around.points) CHECK(away(at(point)) > 6);
    const PagePoint center = at({5, 25});
    bool led = false;
    for (const Stroke& stroke : every<Stroke>(drawing))
        led = led ||
              (stroke.points.size() == 2 && same(stroke.color, ink) &&
               std::abs(std::hypot(stroke.points[0].x - center.x, stroke.points[0].y - center.y) -
                        15) < 1e-6 &&
               away(stroke.points[1]) < 8);
    CHECK(led);
}

TEST_CASE("A picture has curves, bands and ground where the drawing says", "[chart]") {
    Curve band{.name = "flat", .points = {{0, 25}, {10, 25}}, .style = {1, Marker::none}};
    band.low = {23, 23};
    band.high = {27, 27};
    const Figure figure =
        figureOf({.x = {.low = 0, .high = 10},
                  .y = {.low = 20, .high = 30},
                  .curves = {band, {.points = {{2, 21}, {8, 29}}, .style = {2, Marker::square}}}});
    const Drawing drawing = figureDrawing(figure);
    const double scale = GENERATE(1.0, 1.5, 2.0);
    const Picture picture = figurePicture(figure, scale);
    REQUIRE(picture.width == 1280 * scale);
    const auto at = [&](double x, double y) {
        return pixel(picture, scale * across(drawing, "0", "10", x / 10),
                     scale * up(drawing, "20", "30", y / 10 - 2));
    };
    CHECK(same(at(2.5, 25), curveColor(1)));
    CHECK(same(at(2, 21), curveColor(2)));
    CHECK(same(at(8, 29), curveColor(2)));
    CHECK(same(at(3.5, 23), curveColor(2)));
    CHECK(same(at(5.5, 28.5), chartGround));
    const Color shaded = at(1.5, 26.5), ground = chartGround, full = curveColor(1);
    CHECK(std::abs(shaded.g - (ground.g + 0.2 * (full.g - ground.g))) < 1.5);
    CHECK(same(at(1.5, 27.5), chartGround));
}

TEST_CASE("Strokes, discs and areas cover as much as they are large", "[chart]") {
    const auto covered = [](const auto& item) {
        Drawing drawing{200, 100, "", {255, 255, 255}, {item}};
        const Picture picture = drawingPicture(drawing, 1);
        double sum = 0;
        for (std::size_t i = 0; i < picture.rgb.size(); i += 3) sum += 255 - picture.rgb[i];
        return sum / 255;
    };
    constexpr Color black{0, 0, 0};
    const auto off = [&](double measured, double exact) { return std::abs(measured / exact - 1); };
    const PagePoint a{20.3, 15.7}, b{170.6, 80.2};
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    CHECK(report("area of a stroke", off(covered(Stroke{{a, b}, false, black, 3, {}}), 3 * length),
                 2e-3));
    Stroke ring{{}, true, black, 3, {}};
    for (int i = 0; i < 300; ++i)
        ring.points.push_back(
            {100 + 40 * std::cos(i * 0.02094395102), 50 + 40 * std::sin(i * 0.02094395102)});
    // Where pixels are covered in part, the wedges that neighbours share inside count twice: at
    // most a quarter of width over diameter, of the ring's area.
    CHECK(report("area of a ring of 300 strokes", off(covered(ring), 3 * 80 * 3.14159265), 1e-2));
    // Two rectangles that share a quarter of a square, and a quarter of a disc outside.
    CHECK(report("area of a corner",
                 off(covered(Stroke{{{20, 20}, {80, 20}, {80, 90}}, false, black, 8, {}}),
                     480 + 560 - 16 + 4 * 3.14159265),
                 2e-3));
    const Stroke dashed{{{10, 50}, {70, 50}, {190, 50}}, false, black, 2, {10, 6, 3, 5}};
    // Seven and a half times 24: 13 on in each, and 10 in the half.
    CHECK(report("area of a dashed stroke", off(covered(dashed), 2 * (7 * 13 + 10)), 2e-3));
    CHECK(report("area of a disc", off(covered(Disc{{60.4, 50.1}, 30, black}), 900 * 3.14159265),
                 2e-3));
    CHECK(report("area of a triangle",
                 off(covered(Area{{{10.5, 10}, {90, 20.25}, {40, 90}}, black}),
                     ((90 - 10.5) * 80 - (40 - 10.5) * 10.25) / 2),
                 2e-3));
    // Partly, and wholly, outside of the page.
    CHECK(covered(Area{{{-50, -50}, {10, -50}, {10, 20}, {-50, 20}}, black}) == Approx(200));
    CHECK(covered(Disc{{-80, 40}, 30, black}) == 0);
    CHECK(covered(Stroke{{{50, 150}, {90, 400}}, false, black, 3, {}}) == 0);
}

TEST_CASE("What lies outside of a given range leaves no mark outside of the plot", "[chart]") {
    Curve wild{.name = "", .points = {}, .style = curveStyle(1)};
    Random random(3);
    for (int i = 0; i < 60; ++i)
        wild.points.push_back({random.uniform(-10, 20), random.uniform(10, 40)});
    for (const ChartPoint& p : wild.points) {
        wild.low.push_back(p.y - 2);
        wild.high.push_back(p.y + 2);
    }
    const Drawing drawing = figureDrawing(
        figureOf({.x = {.low = 0, .high = 10}, .y = {.low = 20, .high = 30}, .curves = {wild}}));
    const double left = across(drawing, "0", "10", 0), right = across(drawing, "0", "10", 1);
    const double bottom = up(drawing, "20", "30", 0), top = up(drawing, "20", "30", 1);
    int marks = 0;
    const auto inside = [&](const std::vector<PagePoint>& points, double reach) {
        ++marks;
        for (const PagePoint& p : points)
            CHECK((p.x >= left - reach && p.x <= right + reach && p.y >= top - reach &&
                   p.y <= bottom + reach));
    };
    for (const Stroke& stroke : every<Stroke>(drawing))
        if (same(stroke.color, curveColor(1))) inside(stroke.points, 1e-6);
    for (const Area& area : every<Area>(drawing))
        if (same(area.color, curveColor(1))) inside(area.points, area.alpha < 1 ? 1e-6 : 8);
    CHECK(marks > 20);
}

TEST_CASE("Cells of a map meet half way between their values", "[chart]") {
    HeatMap map{.x = {1, 10, 1000}, .y = {0, 1}, .cells = {0, 1, 2, 3, 1, 0}};
    Figure figure = figureOf({.x = {.logarithmic = true}, .map = map});
    const Drawing drawing = figureDrawing(figure);
    const Picture picture = figurePicture(figure, 1);
    const auto at = [&](double x, double y) {
        return pixel(picture, across(drawing, "1", "1000", std::log10(x) / 3),
                     up(drawing, "0.0", "1.0", y));
    };
    const double half = std::sqrt(10);  // between 1 and 10
    CHECK(same(at(1, 0), categoryColor(0)));
    CHECK(same(at(half * 0.98, 0.48), categoryColor(0)));
    CHECK(same(at(half * 1.02, 0.48), categoryColor(1)));
    CHECK(same(at(half * 0.98, 0.52), categoryColor(3)));
    CHECK(same(at(1000, 0), categoryColor(2)));
    CHECK(same(at(1000, 1.4), categoryColor(0)));
    // A dark marker on a dark cell stands out by its edge.
    figure.charts[0].curves = {{.points = {{1, 1}}, .style = {0, Marker::disc, Dash::none}}};
    const Picture marked = figurePicture(figure, 1);
    const double x = across(drawing, "1", "1000", 0), y = up(drawing, "0.0", "1.0", 1);
    CHECK(same(pixel(marked, x, y), ink));
    CHECK(same(pixel(marked, x + 7.5, y), chartGround));
    CHECK(same(pixel(marked, x + 11, y), categoryColor(3)));
    CHECK_NOTHROW(wordOf(drawing, "drifting"));
}
