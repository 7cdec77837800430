#include "chart_parts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

struct Checker {
    std::string figure;

    [[noreturn]] void refuse(const std::string& what) const {
        throw std::invalid_argument("figure " + figure + ": " + what);
    }

    void number(double value, const Axis& axis, const std::string& what) const {
        if (!std::isfinite(value)) refuse(what + " is not finite");
        if (axis.logarithmic && !(value > 0))
            refuse(what + " is not positive on a logarithmic axis");
    }

    void numbers(const std::vector<double>& values, const Axis& axis,
                 const std::string& what) const {
        for (const double value : values) number(value, axis, what);
    }

    void point(const ChartPoint& p, const Chart& chart, const std::string& what) const {
        number(p.x, chart.x, "x of " + what);
        number(p.y, chart.y, "y of " + what);
    }

    void axis(const Axis& axis, const std::string& what) const {
        if (axis.low) number(*axis.low, axis, "the low end of " + what);
        if (axis.high) number(*axis.high, axis, "the high end of " + what);
        if (axis.low && axis.high && !(*axis.low < *axis.high)) refuse(what + " has no length");
    }

    void curve(const Curve& curve, const Chart& chart) const {
        const std::string name = "curve " + curve.name;
        const std::size_t n = curve.points.size();
        for (std::size_t i = 0; i < n; ++i)
            point(curve.points[i], chart, "point " + std::to_string(i) + " of " + name);
        if (curve.low.size() != curve.high.size() || (!curve.low.empty() && curve.low.size() != n))
            refuse("the band of " + name + " has not one pair a point");
        numbers(curve.low, chart.y, "the band of " + name);
        numbers(curve.high, chart.y, "the band of " + name);
        numbers(curve.failures, chart.x, "a failure of " + name);
        if (curve.highlighted &&
            (*curve.highlighted < 0 || static_cast<std::size_t>(*curve.highlighted) >= n))
            refuse("the highlighted point of " + name + " is none of its points");
        if (curve.style.color < 0) refuse("the colour of " + name + " is negative");
    }

    void map(const HeatMap& map, const Chart& chart) const {
        for (const auto& [values, axis] : {std::pair(&map.x, &chart.x), {&map.y, &chart.y}}) {
            numbers(*values, *axis, "a value of the map");
            if (values->size() < 2 || std::adjacent_find(values->begin(), values->end(),
                                                         std::greater_equal<>()) != values->end())
                refuse("the values of the map do not ascend");
        }
        if (map.cells.size() != map.x.size() * map.y.size())
            refuse("the map has not one cell for each pair of values");
        const int count = static_cast<int>(map.categories.size());
        if (count > 4) refuse("the map has more than four categories");
        for (const int cell : map.cells)
            if (cell < -1 || cell >= count) refuse("a cell of the map has no category");
    }

    void chart(const Chart& chart) const {
        axis(chart.x, "the x axis");
        axis(chart.y, "the y axis");
        for (const Curve& c : chart.curves) curve(c, chart);
        for (const ChartPoint& p : chart.front) point(p, chart, "the front");
        for (const ChartLabel& label : chart.labels) point(label.at, chart, "label " + label.text);
        if (chart.map) map(*chart.map, chart);
        const bool drawn =
            chart.map || std::any_of(chart.curves.begin(), chart.curves.end(), [](const Curve& c) {
                return !c.points.empty() || !c.failures.empty();
            });
        if (!drawn) refuse("chart " + chart.title + " has nothing to draw");
        if (chart.equalScale && (chart.x.logarithmic || chart.y.logarithmic))
            refuse("equal scales want linear axes");
    }
};

}  // namespace

void checkFigure(const Figure& figure) {
    const Checker check{figure.title};
    if (figure.charts.empty()) check.refuse("no charts");
    if (figure.columns < 1) check.refuse("no columns");
    if (figure.width < 320 || figure.height < 240) check.refuse("smaller than 320 x 240");
    for (const Chart& chart : figure.charts) check.chart(chart);
}

}  // namespace plait
