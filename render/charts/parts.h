// What a chart is made of; nothing outside of render/charts needs it.
#pragma once

#include "axis.h"
#include "chart.h"
#include "drawing.h"

#include <cmath>
#include <span>

namespace plait {

inline constexpr Color chartGround{0xfa, 0xf6, 0xef}, chartGrid{0xdc, 0xd5, 0xca},
    chartQuiet{0x58, 0x6a, 0x7a}, frontColor{0xc9, 0xbe, 0xad};

Color curveColor(int i);
Color categoryColor(int i);  // of a heat map, from light to dark
std::vector<double> dashPattern(Dash dash);

enum class Anchor { left, middle, right };
// `x` is where the anchor is. Smaller where it is wider than `room`; empty text is left out.
void addWord(Drawing& drawing, double x, double baseline, const std::string& text, TextStyle style,
             Anchor anchor = Anchor::left, double room = HUGE_VAL);
void addLine(Drawing& drawing, PagePoint a, PagePoint b, Color color, double width);
void addRectangle(Drawing& drawing, const PageBox& box, Color color, double alpha = 1);
void addMarker(Drawing& drawing, PagePoint center, const CurveStyle& style, double radius);

// Where a chart's numbers are on the page.
struct Plot {
    PageBox box;
    AxisScale x, y;

    PagePoint operator()(ChartPoint p) const { return {x(p.x), y(p.y)}; }
};

// One chart within the box; `size` 1 is for a chart that has the page to itself.
void addChart(Drawing& drawing, const Chart& chart, const PageBox& box, double size);
// Curves with bands, markers and front; the highlighted points.
void addCurves(Drawing& drawing, const Chart& chart, const Plot& plot, double size);
void addHighlights(Drawing& drawing, const Chart& chart, const Plot& plot, double size);

bool contains(const PageBox& box, PagePoint p);  // its edge too
// Of the segment the part within the box, as fractions; first > last: none.
std::pair<double, double> inside(PagePoint a, PagePoint b, const PageBox& box);
PagePoint between(PagePoint a, PagePoint b, double s);
// What of a line lies in the box.
std::vector<std::vector<PagePoint>> clipped(std::span<const PagePoint> points, const PageBox& box);

// Names and samples of what the charts hold, each name once.
struct LegendEntry {
    std::string name;
    CurveStyle style;
    Color color;
    double width = 3;   // of the line
    bool area = false;  // in place of line and marker
};
std::vector<LegendEntry> legendEntries(std::span<const Chart> charts);
inline constexpr double legendPitch = 34;  // px from one to the next where there is room
double legendWidth(std::span<const LegendEntry> entries, double size);
void addLegend(Drawing& drawing, std::span<const LegendEntry> entries, const PageBox& box,
               double size);

// Throws std::invalid_argument as figureSvg says.
void checkFigure(const Figure& figure);

// The whole page; what figureSvg and figurePicture draw. Throws as they do.
Drawing figureDrawing(const Figure& figure);

}  // namespace plait
