#include "chart_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plait {
namespace {

// Where cells end, px: half way between values, which is by ratio on a logarithmic axis, but not
// outside of the plot; the outer ones are as wide as their neighbour.
std::vector<double> edges(const std::vector<double>& values, const AxisScale& scale) {
    std::vector<double> result;
    const std::size_t n = values.size();
    const auto at = [&](std::size_t i) { return scale(values[i]); };
    result.push_back(at(0) - (at(1) - at(0)) / 2);
    for (std::size_t i = 0; i + 1 < n; ++i) result.push_back((at(i) + at(i + 1)) / 2);
    result.push_back(at(n - 1) + (at(n - 1) - at(n - 2)) / 2);
    const auto [low, high] = std::minmax(scale.from, scale.to);
    for (double& edge : result) edge = std::clamp(edge, low, high);
    return result;
}

std::vector<PagePoint> placed(std::span<const ChartPoint> points, const Plot& plot) {
    std::vector<PagePoint> result;
    for (const ChartPoint& point : points) result.push_back(plot(point));
    return result;
}

// On a map with a light edge, as its markers: dark cells would swallow it.
void addCurve(Drawing& drawing, const Curve& curve, const Plot& plot, bool onMap, double width) {
    if (curve.style.dash == Dash::none) return;
    std::vector<PagePoint> points = placed(curve.points, plot);
    if (curve.closed && !points.empty()) points.push_back(points.front());
    const auto lines = clippedLine(points, plot.box);
    if (onMap)
        for (const auto& line : lines)
            drawing.items.emplace_back(Stroke{line, false, chartGround, 2.4 * width, {}});
    std::vector<double> dash = dashPattern(curve.style.dash);
    for (double& length : dash) length *= width / 3;
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
    for (auto& line : clippedLine(stairs, plot.box))
        drawing.items.emplace_back(Stroke{std::move(line), false, frontColor, width, {}});
}

}  // namespace

void addCells(Drawing& drawing, const Box& box, int category) {
    if (category >= 0) return addRectangle(drawing, box, categoryColor(category));
    addRectangle(drawing, box, chartGround);
    // Strokes that rise to the right and go on from row to row.
    constexpr double pitch = 8;
    const double first = std::ceil((box.left + box.top) / pitch) * pitch;
    for (double sum = first; sum < box.right + box.bottom; sum += pitch)
        for (const auto& line :
             clippedLine(std::array<PagePoint, 2>{{{box.left, sum - box.left},
                                                   {box.right, sum - box.right}}},
                         box))
            drawing.items.emplace_back(Stroke{line, false, frontColor, 1, {}});
}

void addHeatMap(Drawing& drawing, const HeatMap& map, const Plot& plot) {
    const std::vector<double> x = edges(map.x, plot.x), y = edges(map.y, plot.y);
    const std::size_t columns = map.x.size();
    for (std::size_t row = 0; row < map.y.size(); ++row)
        for (std::size_t from = 0, to = 0; from < columns; from = to) {
            const int* cells = &map.cells[row * columns];
            for (to = from + 1; to < columns && cells[to] == cells[from];) ++to;
            const Box run{x[from], y[row + 1], x[to], y[row]};
            if (run.right > run.left && run.bottom > run.top) addCells(drawing, run, cells[from]);
        }
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
        for (const PagePoint& p : placed(curve.points, plot))
            if (contains(plot.box, p) && curve.style.marker != Marker::none) {
                if (chart.map) drawing.items.emplace_back(Disc{p, 8.5 * size, chartGround});
                addMarker(drawing, p, curve.style, 6 * size);
            }
}

}  // namespace plait
