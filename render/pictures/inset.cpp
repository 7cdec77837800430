#include "inset.h"

#include "render/charts/parts.h"

#include <cmath>

namespace plait {
namespace {

constexpr int across = 296, down = 206;
constexpr PageBox area{52, 44, 280, 158};  // of the axes
constexpr Color grid{0x33, 0x40, 0x4d}, quiet{0x58, 0x6a, 0x7a}, faint{0x7c, 0x33, 0x2a};
constexpr double gap = 8;

bool shown(const ChartPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

AxisScale scaleOf(const std::vector<ChartPoint>& curve, double ChartPoint::* part, double from,
                  double to) {
    std::vector<double> data;
    for (const ChartPoint& p : curve) data.push_back(p.*part);
    return {axisRange({}, data), false, from, to};
}

// Of a way what is there and lies within the axes.
void addWay(Drawing& drawing, const std::vector<ChartPoint>& way, const Plot& plot, Color color,
            double thick) {
    std::vector<PagePoint> line;
    const auto end = [&] {
        for (auto& part : clipped(line, plot.box))
            drawing.items.emplace_back(Stroke{std::move(part), false, color, thick, {}});
        line.clear();
    };
    for (const ChartPoint& p : way)
        if (shown(p))
            line.push_back(plot(p));
        else
            end();
    end();
}

void addAxes(Drawing& drawing, const Plot& plot) {
    const TextStyle small{Weight::regular, 14, steel, 1, true};
    const PageBox& box = plot.box;
    for (const auto& [value, text] : axisTicks(plot.x.range, false, 5)) {
        addLine(drawing, {plot.x(value), box.top}, {plot.x(value), box.bottom}, grid, 1);
        addWord(drawing, plot.x(value), box.bottom + gap + capHeight(small), text, small,
                Anchor::middle);
    }
    for (const auto& [value, text] : axisTicks(plot.y.range, false, 4)) {
        addLine(drawing, {box.left, plot.y(value)}, {box.right, plot.y(value)}, grid, 1);
        addWord(drawing, box.left - gap, plot.y(value) + capHeight(small) / 2, text, small,
                Anchor::right);
    }
}

}  // namespace

Drawing insetDrawing(const InsetChart& inset) {
    Drawing drawing{.width = across, .height = down, .title = "", .ground = ink, .items = {}};
    addRectangle(drawing, {0, 0, across, down}, ink, 0.72);
    const Plot plot{area, scaleOf(inset.curve, &ChartPoint::x, area.left, area.right),
                    scaleOf(inset.curve, &ChartPoint::y, area.bottom, area.top)};
    addAxes(drawing, plot);
    const TextStyle name{Weight::regular, 15, ivory};
    addWord(drawing, gap + 6, 30, inset.y, name, Anchor::left, across - 2 * gap);
    addWord(drawing, area.right, down - gap, inset.x, name, Anchor::right, across - 2 * gap);
    addWay(drawing, inset.curve, plot, quiet, 2);
    addWay(drawing, inset.trail, plot, faint, 2.5);
    if (inset.trail.empty() || !shown(inset.trail.back())) return drawing;
    const PagePoint at = plot(inset.trail.back());
    if (!contains(area, at)) return drawing;
    drawing.items.emplace_back(Disc{at, 6.5, ivory});
    drawing.items.emplace_back(Disc{at, 5, vermilion});
    return drawing;
}

void drawInset(Picture& picture, const InsetChart& inset, double below) {
    const double unit = unitOf(picture);
    paintDrawing(picture, picture.width - (40 + across) * unit, (40 + below) * unit,
                 insetDrawing(inset), unit);
}

}  // namespace plait
