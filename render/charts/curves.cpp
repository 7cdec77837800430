#include "parts.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

// What of an area lies in the box, side by side (Sutherland and Hodgman 1974).
std::vector<PagePoint> clippedArea(std::vector<PagePoint> points, const PageBox& box) {
    const auto cut = [&](auto distance) {
        std::vector<PagePoint> kept;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const PagePoint a = points[i], b = points[(i + 1) % points.size()];
            const double from = distance(a), to = distance(b);
            if (from >= 0) kept.push_back(a);
            if ((from < 0) != (to < 0)) kept.push_back(between(a, b, from / (from - to)));
        }
        points = std::move(kept);
    };
    cut([&](PagePoint p) { return p.x - box.left; });
    cut([&](PagePoint p) { return box.right - p.x; });
    cut([&](PagePoint p) { return p.y - box.top; });
    cut([&](PagePoint p) { return box.bottom - p.y; });
    return points;
}

// On a map with a light edge, as its markers: dark cells would swallow it.
void addCurve(Drawing& drawing, const Curve& curve, const Plot& plot, bool onMap, double width) {
    if (curve.style.dash == Dash::none) return;
    std::vector<PagePoint> points;
    for (const ChartPoint& point : curve.points) points.push_back(plot(point));
    if (curve.closed && !points.empty()) points.push_back(points.front());
    const auto lines = clipped(points, plot.box);
    std::vector<double> dash = dashPattern(curve.style.dash);
    for (double& length : dash) length *= width / 3;
    for (const auto& line : lines)
        if (onMap) drawing.items.emplace_back(Stroke{line, false, chartGround, 2.4 * width, {}});
    for (const auto& line : lines)
        drawing.items.emplace_back(Stroke{line, false, curveColor(curve.style.color), width, dash});
}

void addBand(Drawing& drawing, const Curve& curve, const Plot& plot) {
    std::vector<PagePoint> around;
    for (std::size_t i = 0; i < curve.low.size(); ++i)
        around.push_back(plot({curve.points[i].x, curve.low[i]}));
    for (std::size_t i = curve.high.size(); i-- > 0;)
        around.push_back(plot({curve.points[i].x, curve.high[i]}));
    around = clippedArea(std::move(around), plot.box);
    if (!around.empty())
        drawing.items.emplace_back(Area{around, curveColor(curve.style.color), 0.2});
}

// From each point to the right until the next is better; from the top and to the right without
// end.
void addFront(Drawing& drawing, std::span<const ChartPoint> front, const Plot& plot, double width) {
    if (front.empty()) return;
    std::vector<PagePoint> stairs{{plot(front[0]).x, plot.box.top}};
    for (const ChartPoint& point : front) {
        const PagePoint p = plot(point);
        stairs.push_back({p.x, stairs.back().y});
        stairs.push_back(p);
    }
    stairs.push_back({plot.box.right, stairs.back().y});
    for (auto& line : clipped(stairs, plot.box))
        drawing.items.emplace_back(Stroke{std::move(line), false, frontColor, width, {}});
}

}  // namespace

bool contains(const PageBox& box, PagePoint p) {
    constexpr double slack = 0.01;
    return p.x >= box.left - slack && p.x <= box.right + slack && p.y >= box.top - slack &&
           p.y <= box.bottom + slack;
}

PagePoint between(PagePoint a, PagePoint b, double s) {
    return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
}

// Liang and Barsky 1984.
std::pair<double, double> inside(PagePoint a, PagePoint b, const PageBox& box) {
    double first = 0, last = 1;
    const auto keep = [&](double distance, double change) {  // distance + s change >= 0
        if (change > 0) first = std::max(first, -distance / change);
        if (change < 0) last = std::min(last, -distance / change);
        if (change == 0 && distance < 0) last = -1;
    };
    keep(a.x - box.left, b.x - a.x);
    keep(box.right - a.x, a.x - b.x);
    keep(a.y - box.top, b.y - a.y);
    keep(box.bottom - a.y, a.y - b.y);
    return {first, last};
}

std::vector<std::vector<PagePoint>> clipped(std::span<const PagePoint> points, const PageBox& box) {
    std::vector<std::vector<PagePoint>> result;
    bool goesOn = false;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const PagePoint a = points[i], b = points[i + 1];
        if (a.x == b.x && a.y == b.y) continue;  // a join without a direction
        const auto [first, last] = inside(a, b, box);
        if (first < last) {
            if (!goesOn || first > 0) result.push_back({between(a, b, first)});
            result.back().push_back(between(a, b, last));
        }
        goesOn = first < last && last == 1;
    }
    return result;
}

void addCurves(Drawing& drawing, const Chart& chart, const Plot& plot, double size) {
    addFront(drawing, chart.front, plot, 9 * size);
    for (const Curve& curve : chart.curves) addBand(drawing, curve, plot);
    // Solid ones first: where two are the same line, both are seen.
    for (const bool solid : {true, false})
        for (const Curve& curve : chart.curves)
            if ((curve.style.dash == Dash::solid) == solid)
                addCurve(drawing, curve, plot, chart.map.has_value(), 3 * size);
    for (const Curve& curve : chart.curves)
        for (const ChartPoint& point : curve.points) {
            const PagePoint p = plot(point);
            if (!contains(plot.box, p) || curve.style.marker == Marker::none) continue;
            if (chart.map) drawing.items.emplace_back(Disc{p, 8.5 * size, chartGround});
            addMarker(drawing, p, curve.style, 6 * size);
        }
}

}  // namespace plait
