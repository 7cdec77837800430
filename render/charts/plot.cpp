#include "parts.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

// How text is set in a chart of this size.
struct Look {
    explicit Look(double size)
        : title{Weight::semibold, 20 * size, ink},
          label{Weight::regular, 18 * size, ink},
          tick{Weight::regular, 17 * size, ink, 1, true} {}
    TextStyle title, label, tick;
};

struct Data {
    std::vector<double> x, y;

    void add(const std::vector<ChartPoint>& points) {
        for (const ChartPoint& p : points) x.push_back(p.x), y.push_back(p.y);
    }
};

Data dataOf(const Chart& chart) {
    Data data;
    for (const Curve& curve : chart.curves) {
        data.add(curve.points);
        data.x.insert(data.x.end(), curve.failures.begin(), curve.failures.end());
        data.y.insert(data.y.end(), curve.low.begin(), curve.low.end());
        data.y.insert(data.y.end(), curve.high.begin(), curve.high.end());
    }
    data.add(chart.front);
    return data;
}

// Where the cells of a map end; the outer ones are as wide as their neighbour.
std::vector<double> cellEdges(const std::vector<double>& values, bool logarithmic) {
    const auto between = [&](std::size_t i, double s) {
        const double a = values[i], b = values[i + 1];
        return logarithmic ? a * std::pow(b / a, s) : a + s * (b - a);
    };
    std::vector<double> edges{between(0, -0.5)};
    for (std::size_t i = 0; i + 1 < values.size(); ++i) edges.push_back(between(i, 0.5));
    edges.push_back(between(values.size() - 2, 1.5));
    return edges;
}

// A map fills its axes; curves on it are cut off where it ends.
AxisRange rangeOf(const Axis& axis, const std::vector<double>& data,
                  const std::vector<double>* mapped) {
    if (!mapped) return axisRange(axis, data);
    const std::vector<double> edges = cellEdges(*mapped, axis.logarithmic);
    return {edges.front(), edges.back()};
}

void addHeatMap(Drawing& drawing, const HeatMap& map, const Plot& plot) {
    const std::vector<double> x = cellEdges(map.x, plot.x.logarithmic);
    const std::vector<double> y = cellEdges(map.y, plot.y.logarithmic);
    const std::size_t columns = map.x.size();
    for (std::size_t row = 0; row < map.y.size(); ++row)
        for (std::size_t from = 0, to = 0; from < columns; from = to) {
            const int* cells = &map.cells[row * columns];
            for (to = from + 1; to < columns && cells[to] == cells[from];) ++to;
            const PagePoint low = plot({x[from], y[row]}), high = plot({x[to], y[row + 1]});
            addRectangle(drawing, {low.x, high.y, high.x, low.y}, categoryColor(cells[from]));
        }
}

bool collide(const std::vector<Tick>& ticks, const AxisScale& scale, const TextStyle& style) {
    double end = -HUGE_VAL;
    for (const Tick& tick : ticks) {
        if (tick.text.empty()) continue;
        const double width = textWidth(tick.text, style), left = scale(tick.value) - width / 2;
        if (left < end + style.size) return true;
        end = left + width;
    }
    return false;
}

std::vector<Tick> ticksAcross(const AxisScale& x, const TextStyle& style) {
    for (int steps = 9;; --steps) {
        std::vector<Tick> ticks = axisTicks(x.range, x.logarithmic, steps);
        if (steps == 1 || !collide(ticks, x, style)) return ticks;
    }
}

std::vector<Tick> ticksUp(AxisRange range, bool logarithmic, const PageBox& box,
                          const TextStyle& style) {
    const double fit = (box.bottom - box.top) / (2.4 * style.size);
    return axisTicks(range, logarithmic, static_cast<int>(std::clamp(fit, 1.0, 9.0)));
}

// Keeps the upper left corner.
void shrinkToEqualScale(PageBox& box, AxisRange x, AxisRange y) {
    const double across = x.high - x.low, up = y.high - y.low;
    const double unit = std::min((box.right - box.left) / across, (box.bottom - box.top) / up);
    box.right = box.left + unit * across;
    box.bottom = box.top + unit * up;
}

void addAxes(Drawing& drawing, const Chart& chart, const Plot& plot, const Look& look) {
    const PageBox& box = plot.box;
    constexpr double outside = 6;
    const TextStyle& style = look.tick;
    const auto gridLine = [&](PagePoint a, PagePoint b, bool named) {
        if (!chart.map) addLine(drawing, a, b, chartGrid, named ? 1.5 : 0.7);
    };
    for (const Tick& tick : ticksAcross(plot.x, style)) {
        const double x = plot.x(tick.value);
        gridLine({x, box.top}, {x, box.bottom}, !tick.text.empty());
        if (tick.text.empty()) continue;
        addLine(drawing, {x, box.bottom}, {x, box.bottom + outside}, ink, 1.5);
        addWord(drawing, x, box.bottom + outside + 1.15 * style.size, tick.text, style,
                Anchor::middle);
    }
    for (const Tick& tick : ticksUp(plot.y.range, plot.y.logarithmic, box, style)) {
        const double y = plot.y(tick.value);
        gridLine({box.left, y}, {box.right, y}, !tick.text.empty());
        if (tick.text.empty()) continue;
        addLine(drawing, {box.left - outside, y}, {box.left, y}, ink, 1.5);
        addWord(drawing, box.left - outside - 4, y + capHeight(style) / 2, tick.text, style,
                Anchor::right);
    }
}

// A map's all round, else the two axes.
void addFrame(Drawing& drawing, const Chart& chart, const PageBox& box) {
    std::vector<PagePoint> line = corners(box);
    if (!chart.map) line = {line[0], line[3], line[2]};
    drawing.items.emplace_back(Stroke{line, chart.map.has_value(), ink, 1.5, {}});
}

constexpr const char* failed = "failed";

std::vector<const Curve*> failing(const Chart& chart) {
    std::vector<const Curve*> curves;
    for (const Curve& curve : chart.curves)
        if (!curve.failures.empty()) curves.push_back(&curve);
    return curves;
}

// px, of the strip above the top edge: a row a curve and one more, closer where there are many.
double stripHeight(const Chart& chart, double size) {
    const auto rows = static_cast<double>(failing(chart).size());
    return rows == 0 ? 0 : 18 * size * (rows + 1) * std::min(1.0, 6 / rows);
}

// A row a curve, so that failures at the same place do not hide each other.
void addFailures(Drawing& drawing, const Chart& chart, const Plot& plot, const TextStyle& style,
                 double size) {
    const std::vector<const Curve*> curves = failing(chart);
    if (curves.empty()) return;
    const double height = stripHeight(chart, size);
    const double row = height / (static_cast<double>(curves.size()) + 1);
    const PageBox box{plot.box.left, plot.box.top - height, plot.box.right, plot.box.top - row / 2};
    addRectangle(drawing, box, chartGrid, 0.6);
    addWord(drawing, box.left - 10, (box.top + box.bottom + capHeight(style)) / 2, failed, style,
            Anchor::right);
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (const double x : curves[i]->failures) {
            const PagePoint at{plot.x(x), box.top + (static_cast<double>(i) + 0.75) * row};
            if (contains(box, at)) addMarker(drawing, at, curves[i]->style, 6 * size);
        }
}

// The rectangle of the numbers, which leaves room for all that is written around it.
PageBox innerBox(const Chart& chart, const PageBox& box, AxisRange y, const Look& look,
                 double size) {
    PageBox inner = box;
    const double strip = stripHeight(chart, size);
    if (!chart.title.empty()) inner.top += 1.6 * look.title.size;
    if (!chart.y.label.empty()) inner.top += 1.5 * look.label.size;
    inner.top += strip + 8;
    inner.bottom -= 2 * look.tick.size + (chart.x.label.empty() ? 0 : 1.5 * look.label.size);
    double widest = strip > 0 ? textWidth(failed, look.tick) : 0;
    for (const Tick& tick : ticksUp(y, chart.y.logarithmic, inner, look.tick))
        widest = std::max(widest, textWidth(tick.text, look.tick));
    inner.left += 10 + widest;
    inner.right -= 1.2 * look.tick.size;
    return inner;
}

}  // namespace

void addChart(Drawing& drawing, const Chart& chart, const PageBox& box, double size) {
    const Look look(size);
    const Data data = dataOf(chart);
    const AxisRange x = rangeOf(chart.x, data.x, chart.map ? &chart.map->x : nullptr);
    const AxisRange y = rangeOf(chart.y, data.y, chart.map ? &chart.map->y : nullptr);
    PageBox inner = innerBox(chart, box, y, look, size);
    if (chart.equalScale) shrinkToEqualScale(inner, x, y);
    const Plot plot{inner,
                    {x, chart.x.logarithmic, inner.left, inner.right},
                    {y, chart.y.logarithmic, inner.bottom, inner.top}};

    const double room = box.right - box.left;
    double line = box.top + look.title.size;
    addWord(drawing, box.left, line, chart.title, look.title, Anchor::left, room);
    if (!chart.title.empty()) line += 1.5 * look.label.size;
    addWord(drawing, box.left, line, chart.y.label, look.label, Anchor::left, room);
    addWord(drawing, inner.right, inner.bottom + 2 * look.tick.size + look.label.size,
            chart.x.label, look.label, Anchor::right, inner.right - box.left);

    if (chart.map) addHeatMap(drawing, *chart.map, plot);
    addAxes(drawing, chart, plot, look);
    addFrame(drawing, chart, inner);
    addFailures(drawing, chart, plot, look.tick, size);
    addCurves(drawing, chart, plot, size);
    addHighlights(drawing, chart, plot, size);
}

}  // namespace plait
