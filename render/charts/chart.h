// Charts of numbers: described once, drawn as SVG or as pixels.
#pragma once

#include "render/pictures/picture.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plait {

struct Axis {
    std::string label = {};  // with its unit: "error [m]"
    bool logarithmic = false;
    // The range, low < high; left out: what the data need, and a margin. What lies outside of a
    // given range is cut off.
    std::optional<double> low = {}, high = {};
};

enum class Marker { none, disc, square, triangle, diamond, cross, wedge };
enum class Dash { solid, dashed, dashDotted, dotted, longDashed, none };

// Six colours of the look book that the colour-blind tell apart, 0 to 5; the marker and the dash
// tell curves apart in black and white.
struct CurveStyle {
    int color = 0;
    Marker marker = Marker::disc;
    Dash dash = Dash::solid;
    bool open = false;  // the marker is hollow; a cross stands upright
};

// The look of the i-th curve, i >= 0: no two of the first 12 share a marker, no two of the first 60
// both marker and dash.
CurveStyle curveStyle(int i);
// A line of theory: ink, long dashes, no markers.
inline constexpr CurveStyle theoryStyle{0, Marker::none, Dash::longDashed};

struct ChartPoint {
    double x, y;
};

struct Curve {
    std::string name = {};  // in the legend; empty: not there
    std::vector<ChartPoint> points = {};
    CurveStyle style = {};
    std::vector<double> low = {}, high = {};  // a band in y, one of each a point; both empty: none
    std::vector<double> failures = {};        // x of runs that failed: marks above the top edge
    std::optional<int> highlighted = {};      // the point that is the default: ringed, and told so
    bool closed = false;                      // the last point is joined to the first
};

// Cells by category around the values at which they were measured; the cells of an axis meet half
// way, by ratio on a logarithmic axis, and fill it: a range of its own is passed over.
struct HeatMap {
    std::vector<double> x = {}, y = {};  // ascending, at least two of each
    std::vector<int> cells = {};         // x.size() * y.size(), the first row at y[0]
    // At most four, from light to dark.
    std::vector<std::string> categories{"ok", "drifting", "exploded", "not finite"};
};

// One pair of axes.
struct Chart {
    std::string title = {};  // empty: none
    Axis x = {}, y = {};
    std::optional<HeatMap> map = {};  // beneath the curves
    std::vector<Curve> curves = {};
    // Pareto front, drawn as a step line: least x and y first; empty: none.
    std::vector<ChartPoint> front = {};
    bool equalScale = false;  // a unit is as long in x as in y
};

// Charts side by side under one title: a slide.
struct Figure {
    std::string title = {}, note = {};  // the note is a line beneath the title: setting, machine
    std::vector<Chart> charts = {};
    int columns = 1;
    bool legendBelow = false;        // beneath each chart its own, instead of one for all
    int width = 1280, height = 720;  // px of the SVG; text grows with the root of the width
};

// All throw std::invalid_argument, "figure TITLE: what is wrong", where there is nothing to draw,
// where a number is not finite or not positive on a logarithmic axis, and where sizes do not match;
// and std::runtime_error where no font is installed, since text is measured.
std::string figureSvg(const Figure& figure);
// `scale` pixels to a px of the SVG.
Picture figurePicture(const Figure& figure, double scale = 1.5);
// Both, as `path`.svg and `path`.png, each whole or not at all. Throws std::runtime_error too,
// "file: cause".
void writeFigure(const std::filesystem::path& path, const Figure& figure);

// As it may stand between tags and in quotes, of SVG and HTML: without control characters too.
std::string escaped(std::string_view text);

// Of the points, those that no other beats in both x and y, by ascending x: of work and error the
// best that can be had.
std::vector<ChartPoint> paretoFront(std::vector<ChartPoint> points);

}  // namespace plait
