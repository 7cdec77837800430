#include "chart_parts.h"

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
};

Data dataOf(const Chart& chart) {
    Data data;
    for (const Curve& curve : chart.curves) {
        for (const ChartPoint& p : curve.points) {
            data.x.push_back(p.x);
            data.y.push_back(p.y);
        }
        data.x.insert(data.x.end(), curve.failures.begin(), curve.failures.end());
        for (const auto* band : {&curve.low, &curve.high})
            data.y.insert(data.y.end(), band->begin(), band->end());
    }
    for (const ChartPoint& p : chart.front) {
        data.x.push_back(p.x);
        data.y.push_back(p.y);
    }
    return data;
}

// A map fills its axes; curves on it are cut off where it ends.
Range mapRange(const Axis& axis, const std::vector<double>& values) {
    const AxisScale unit{{values[0], values[1]}, axis.logarithmic, 0, 1};
    const std::size_t n = values.size();
    const double last = (3 * unit(values[n - 1]) - unit(values[n - 2])) / 2;
    const auto back = [&](double s) {
        return axis.logarithmic ? values[0] * std::pow(values[1] / values[0], s)
                                : values[0] + s * (values[1] - values[0]);
    };
    return {axis.low.value_or(back(-0.5)), axis.high.value_or(back(last))};
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

std::vector<Tick> ticksUp(Range range, bool logarithmic, const Box& box, const TextStyle& style) {
    const double fit = (box.bottom - box.top) / (2.4 * style.size);
    return axisTicks(range, logarithmic, static_cast<int>(std::clamp(fit, 1.0, 9.0)));
}

// Keeps the upper left corner.
void shrinkToEqualScale(Box& box, Range x, Range y) {
    const double across = x.high - x.low, up = y.high - y.low;
    const double unit = std::min((box.right - box.left) / across, (box.bottom - box.top) / up);
    box.right = box.left + unit * across;
    box.bottom = box.top + unit * up;
}

void addAxes(Drawing& drawing, const Chart& chart, const Plot& plot, const Look& look) {
    const Box& box = plot.box;
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

void addFrame(Drawing& drawing, const Chart& chart, const Box& box) {
    if (chart.map)
        drawing.items.emplace_back(Stroke{{{box.left, box.top},
                                           {box.right, box.top},
                                           {box.right, box.bottom},
                                           {box.left, box.bottom}},
                                          true,
                                          ink,
                                          1.5,
                                          {}});
    else
        drawing.items.emplace_back(
            Stroke{{{box.left, box.top}, {box.left, box.bottom}, {box.right, box.bottom}},
                   false,
                   ink,
                   1.5,
                   {}});
}

// A row a curve, so that failures at the same place do not hide each other.
struct FailureStrip {
    FailureStrip(const Chart& chart, double size) : row(18 * size) {
        for (const Curve& curve : chart.curves)
            if (!curve.failures.empty()) curves.push_back(&curve);
        if (curves.size() > 6) row *= 6.0 / static_cast<double>(curves.size());
    }

    double height() const {
        return curves.empty() ? 0 : (static_cast<double>(curves.size()) + 1) * row;
    }

    void addTo(Drawing& drawing, const Plot& plot, const TextStyle& style, double size) const {
        if (curves.empty()) return;
        const Box box{plot.box.left, plot.box.top - height(), plot.box.right,
                      plot.box.top - row / 2};
        addRectangle(drawing, box, chartGrid, 0.6);
        addWord(drawing, box.left - 10, (box.top + box.bottom + capHeight(style)) / 2, failed,
                style, Anchor::right);
        for (std::size_t i = 0; i < curves.size(); ++i)
            for (const double x : curves[i]->failures) {
                const PagePoint at{plot.x(x), box.top + (static_cast<double>(i) + 0.75) * row};
                if (contains(box, at)) addMarker(drawing, at, curves[i]->style, 6 * size);
            }
    }

    static constexpr const char* failed = "failed";
    double row;
    std::vector<const Curve*> curves;
};

double widest(std::span<const Tick> ticks, const TextStyle& style) {
    double width = 0;
    for (const Tick& tick : ticks) width = std::max(width, textWidth(tick.text, style));
    return width;
}

// The rectangle of the numbers, which leaves room for all that is written around it.
Box innerBox(const Chart& chart, const Box& box, Range y, const FailureStrip& strip,
             const Look& look) {
    Box inner = box;
    if (!chart.title.empty()) inner.top += 1.6 * look.title.size;
    if (!chart.y.label.empty()) inner.top += 1.5 * look.label.size;
    inner.top += strip.height() + 4;
    inner.bottom -= 2 * look.tick.size + (chart.x.label.empty() ? 0 : 1.5 * look.label.size);
    const auto ticks = ticksUp(y, chart.y.logarithmic, inner, look.tick);
    inner.left +=
        10 + std::max(widest(ticks, look.tick),
                      strip.curves.empty() ? 0 : textWidth(FailureStrip::failed, look.tick));
    inner.right -= 1.2 * look.tick.size;
    return inner;
}

}  // namespace

void addChart(Drawing& drawing, const Chart& chart, const Box& box, double size) {
    const Look look(size);
    const Data data = dataOf(chart);
    const Range x = chart.map ? mapRange(chart.x, chart.map->x) : axisRange(chart.x, data.x);
    const Range y = chart.map ? mapRange(chart.y, chart.map->y) : axisRange(chart.y, data.y);
    const FailureStrip strip(chart, size);
    Box inner = innerBox(chart, box, y, strip, look);
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
    strip.addTo(drawing, plot, look.tick, size);
    addCurves(drawing, chart, plot, size);
    addLabels(drawing, chart, plot, size);
}

}  // namespace plait
