#include "parts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

struct Checker {
    std::string figure;

    void require(bool good, const std::string& otherwise) const {
        if (!good) throw std::invalid_argument("figure " + figure + ": " + otherwise);
    }

    void number(double value, const Axis& axis, const std::string& what) const {
        require(std::isfinite(value), what + " is not finite");
        require(!axis.logarithmic || value > 0, what + " is not positive on a logarithmic axis");
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
        require(!axis.low || !axis.high || *axis.low < *axis.high, what + " has no length");
    }

    void curve(const Curve& curve, const Chart& chart) const {
        const std::string name = "curve " + curve.name;
        const std::size_t n = curve.points.size();
        for (std::size_t i = 0; i < n; ++i)
            point(curve.points[i], chart, "point " + std::to_string(i) + " of " + name);
        const std::size_t pairs = curve.low.size();
        require(pairs == curve.high.size() && (pairs == 0 || pairs == n),
                "the band of " + name + " has not one pair a point");
        numbers(curve.low, chart.y, "the band of " + name);
        numbers(curve.high, chart.y, "the band of " + name);
        numbers(curve.failures, chart.x, "a failure of " + name);
        const int chosen = curve.highlighted.value_or(0);
        require(!curve.highlighted || (chosen >= 0 && static_cast<std::size_t>(chosen) < n),
                "the highlighted point of " + name + " is none of its points");
        require(curve.style.color >= 0, "the colour of " + name + " is negative");
    }

    void map(const HeatMap& map, const Chart& chart) const {
        for (const auto& [values, axis] : {std::pair(&map.x, &chart.x), {&map.y, &chart.y}}) {
            numbers(*values, *axis, "a value of the map");
            require(
                values->size() >= 2 && std::adjacent_find(values->begin(), values->end(),
                                                          std::greater_equal<>()) == values->end(),
                "the values of the map do not ascend");
        }
        require(map.cells.size() == map.x.size() * map.y.size(),
                "the map has not one cell for each pair of values");
        const int count = static_cast<int>(map.categories.size());
        require(count <= 4, "the map has more than four categories");
        for (const int cell : map.cells)
            require(cell >= 0 && cell < count, "a cell of the map has no category");
    }

    void chart(const Chart& chart) const {
        axis(chart.x, "the x axis");
        axis(chart.y, "the y axis");
        for (const Curve& c : chart.curves) curve(c, chart);
        for (const ChartPoint& p : chart.front) point(p, chart, "the front");
        if (chart.map) map(*chart.map, chart);
        const bool drawn =
            chart.map || std::any_of(chart.curves.begin(), chart.curves.end(), [](const Curve& c) {
                return !c.points.empty() || !c.failures.empty();
            });
        require(drawn, "chart " + chart.title + " has nothing to draw");
        require(!chart.equalScale || !(chart.x.logarithmic || chart.y.logarithmic),
                "equal scales want linear axes");
    }
};

}  // namespace

void checkFigure(const Figure& figure) {
    const Checker check{figure.title};
    check.require(!figure.charts.empty(), "no charts");
    check.require(figure.columns >= 1, "no columns");
    check.require(figure.width >= 320 && figure.height >= 240, "smaller than 320 x 240");
    for (const Chart& chart : figure.charts) check.chart(chart);
}

}  // namespace plait
