#include "drawn.h"
#include "render/pictures/image.h"
#include "tests/catch.h"
#include "tests/scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace plait;
using namespace plait::test;

namespace {

Figure withPoint(ChartPoint point, bool logarithmic) {
    const Axis axis{.logarithmic = logarithmic};
    return figureOf({.x = axis, .y = axis, .curves = {{.name = "a", .points = {point, {1, 2}}}}});
}

std::string refusal(const Figure& figure) {
    try {
        figureSvg(figure);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

// Ten methods with failures, defaults and a front.
Figure crowded() {
    Chart chart{.title = "All methods", .x = workAxis, .y = errorAxis};
    std::vector<ChartPoint> all;
    for (int i = 0; i < 10; ++i) {
        Curve curve{.name = "method " + std::to_string(i), .style = curveStyle(i)};
        for (int j = 0; j < 8; ++j) {
            const ChartPoint p{0.02 * std::pow(2, j) * (1 + 0.35 * i),
                               0.3 * std::pow(0.5, (i % 3 == 2 ? 2 : 1) * j) * (1 + 3 * i % 5)};
            if (i < 7 && j < 3)
                curve.failures.push_back(p.x);
            else
                curve.points.push_back(p);
        }
        all.insert(all.end(), curve.points.begin(), curve.points.end());
        if (i % 4 == 1) curve.highlighted = 2;
        chart.curves.push_back(curve);
    }
    chart.front = paretoFront(all);
    return {.title =
                "A title that is far too long for the page, as titles of studies sometimes "
                "are when they name it all",
            .note = "a note",
            .charts = {chart}};
}

// Eight maps of 20 x 15 cells.
Figure atlas(int width = 1280) {
    HeatMap map;
    for (int i = 0; i < 20; ++i) map.x.push_back(std::pow(10, 0.3 * i));
    for (int i = 0; i < 15; ++i) map.y.push_back(1e-5 * std::pow(10, 0.25 * i));
    for (const double y : map.y)
        for (const double x : map.x) {
            const double s = y * std::sqrt(x);
            map.cells.push_back(s < 0.2 ? 0 : s < 0.4 ? 1 : s < 2 ? 2 : 3);
        }
    Curve theory{.name = "h = 2/ω", .style = theoryStyle};
    for (const double x : map.x) theory.points.push_back({x, 0.4 / std::sqrt(x)});
    Figure figure{.title = "Atlas", .columns = 4, .width = width};
    for (int i = 0; i < 8; ++i)
        figure.charts.push_back({.title = "method " + std::to_string(i),
                                 .x = {"stiffness [N/m]", true, {}, {}},
                                 .y = {"step [s]", true, {}, {}},
                                 .map = map,
                                 .curves = {theory}});
    return figure;
}

// Long numbers beneath narrow charts.
Figure narrow() {
    Figure figure{.title = "Narrow", .columns = 5};
    for (const double size : {1e-4, 1.0, 123.0, 9e4, 4e5})
        figure.charts.push_back({.title = "A title that is longer than the chart is wide",
                                 .x = anyX,
                                 .y = anyY,
                                 .curves = {{.points = {{-size, -size}, {size, size}}}}});
    return figure;
}

bool overlap(const PageBox& a, const PageBox& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

// What is wrong with the XML; empty: well formed, with elements and attributes as ours are.
std::string flaw(const std::string& xml) {
    std::vector<std::string> open;
    std::size_t at = 0;
    while (at < xml.size()) {
        const std::size_t next = std::min(xml.find('<', at), xml.size());
        for (std::size_t i = at; i < next; ++i)
            if (xml[i] == '>' || (open.empty() && !std::isspace(xml[i]))) return "stray text";
        if (next == xml.size()) break;
        const std::size_t end = xml.find('>', next);
        if (end == std::string::npos) return "an open tag";
        std::string tag = xml.substr(next + 1, end - next - 1);
        if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "an open quote";
        if (tag.find('<') != std::string::npos) return "a tag in a tag";
        if (tag[0] == '/') {
            if (open.empty() || open.back() != tag.substr(1)) return "a wrong end " + tag;
            open.pop_back();
        } else if (tag.back() != '/') {
            open.push_back(tag.substr(0, tag.find(' ')));
        }
        at = end + 1;
    }
    for (std::size_t i = xml.find('&'); i != std::string::npos; i = xml.find('&', i + 1)) {
        const std::string name = xml.substr(i + 1, xml.find(';', i) - i - 1);
        if (name != "amp" && name != "lt" && name != "gt" && name != "quot")
            return "entity " + name;
    }
    return open.empty() ? "" : "no end of " + open.back();
}

}  // namespace

TEST_CASE("No word of a crowded figure covers another or leaves the page", "[chart]") {
    for (const Figure& figure : {crowded(), atlas(), atlas(2080), narrow()}) {
        const Drawing drawing = figureDrawing(figure);
        const std::vector<Word> words = every<Word>(drawing);
        REQUIRE(words.size() > 25);
        for (std::size_t i = 0; i < words.size(); ++i) {
            const PageBox box = boxOf(words[i]);
            CAPTURE(words[i].text);
            CHECK((box.left >= 0 && box.top >= 0));
            CHECK((box.right <= drawing.width && box.bottom <= drawing.height));
            for (std::size_t j = 0; j < i; ++j) {
                CAPTURE(words[j].text);
                CHECK(!overlap(box, boxOf(words[j])));
            }
            CHECK(words[i].style.size >= 10);
        }
    }
}

TEST_CASE("A run of cells is one area", "[chart]") {
    CHECK(figureDrawing(atlas()).items.size() < 2500);
}

TEST_CASE("Curves and categories differ without colour", "[chart]") {
    std::set<std::pair<int, bool>> markers;
    std::set<std::tuple<int, bool, int>> looks;
    for (int i = 0; i < 60; ++i) {
        const CurveStyle style = curveStyle(i);
        const int marker = static_cast<int>(style.marker);
        if (i < 12) CHECK(markers.insert({marker, style.open}).second);
        CHECK(looks.insert({marker, style.open, static_cast<int>(style.dash)}).second);
    }
    const auto lightness = [](Color color) {
        const auto linear = [](double v) {
            return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        };
        const double y = 0.2126 * linear(color.r / 255.0) + 0.7152 * linear(color.g / 255.0) +
                         0.0722 * linear(color.b / 255.0);
        return 116 * std::cbrt(y) - 16;  // CIE L*
    };
    for (int i = 0; i < 3; ++i)
        CHECK(lightness(categoryColor(i)) > lightness(categoryColor(i + 1)) + 15);
}

TEST_CASE("SVG is well formed, whatever is written in it", "[chart]") {
    Figure figure = crowded();
    figure.title = "a < b && \"c\" > 'd'\x01\n";
    figure.charts[0].curves[0].name = "</text><script>";
    const std::string svg = figureSvg(figure);
    CHECK(flaw(svg).empty());
    CHECK(svg.find("<script") == std::string::npos);
    CHECK(svg.find(">&lt;/text&gt;&lt;script&gt;</text>") != std::string::npos);
    CHECK(svg.find("<title>a &lt; b &amp;&amp; &quot;c&quot; &gt; 'd'  </title>") !=
          std::string::npos);
    CHECK(flaw(figureSvg(atlas())).empty());
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    CHECK(figureSvg(figure) == svg);
}

TEST_CASE("Numbers that cannot be drawn are refused in one line", "[chart]") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = HUGE_VAL;
    CHECK(refusal(withPoint({1, nan}, false)) == "figure T: y of point 0 of curve a is not finite");
    CHECK(refusal(withPoint({-infinity, 1}, false)) ==
          "figure T: x of point 0 of curve a is not finite");
    CHECK(refusal(withPoint({0, 1}, true)) ==
          "figure T: x of point 0 of curve a is not positive on a logarithmic axis");
    CHECK(refusal({.title = "T"}) == "figure T: no charts");
    CHECK(refusal(figureOf({.title = "C"})) == "figure T: chart C has nothing to draw");
    const auto broken = [](auto change) {
        Figure figure = crowded();
        figure.title = "T";
        change(figure.charts[0]);
        return refusal(figure);
    };
    CHECK(broken([](Chart&) {}).empty());
    CHECK(broken([](Chart& c) { c.curves[0].failures = {nan}; }) ==
          "figure T: a failure of curve method 0 is not finite");
    CHECK(broken([](Chart& c) { c.curves[0].low = {1}; }) ==
          "figure T: the band of curve method 0 has not one pair a point");
    CHECK(broken([](Chart& c) { c.curves[0].highlighted = 99; }) ==
          "figure T: the highlighted point of curve method 0 is none of its points");
    CHECK(broken([](Chart& c) { c.x.low = 3, c.x.high = 3; }) ==
          "figure T: the x axis has no length");
    CHECK(broken([](Chart& c) { c.front.push_back({1, infinity}); }) ==
          "figure T: y of the front is not finite");
    CHECK(broken([](Chart& c) { c.map = HeatMap{{1, 2}, {2, 1}, {0, 0, 0, 0}}; }) ==
          "figure T: the values of the map do not ascend");
    CHECK(broken([](Chart& c) { c.map = HeatMap{{1, 2}, {1, 2}, {0, 0, 0}}; }) ==
          "figure T: the map has not one cell for each pair of values");
    CHECK(broken([](Chart& c) { c.map = HeatMap{{1, 2}, {1, 2}, {0, 0, 0, 4}}; }) ==
          "figure T: a cell of the map has no category");
}

TEST_CASE("A figure is two files, or none", "[chart]") {
    const ScratchFolder folder;
    writeFigure(folder / "chart", crowded());
    CHECK(folder.count() == 2);
    CHECK(readPng(folder / "chart.png") == figurePicture(crowded()));
    CHECK(std::filesystem::file_size(folder / "chart.svg") == figureSvg(crowded()).size());
    CHECK_THROWS_AS(writeFigure(folder / "no" / "chart", crowded()), std::runtime_error);
    CHECK_THROWS_AS(writeFigure(folder / "other", Figure{}), std::invalid_argument);
    CHECK(folder.count() == 2);
}

TEST_CASE("A front holds what no other point beats", "[chart]") {
    const auto front = paretoFront({{4, 1}, {1, 5}, {2, 5}, {2, 3}, {3, 4}, {5, 1}, {2, 3}});
    REQUIRE(front.size() == 3);
    CHECK((front[0].x == 1 && front[0].y == 5));
    CHECK((front[1].x == 2 && front[1].y == 3));
    CHECK((front[2].x == 4 && front[2].y == 1));
    CHECK(paretoFront({}).empty());
}
