#include "parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plait {

Color curveColor(int i) {
    static constexpr Color colors[] = {{0x16, 0x20, 0x2c}, {0xc8, 0x32, 0x1f}, {0x13, 0x7b, 0x85},
                                       {0xd9, 0xa4, 0x41}, {0x86, 0xb4, 0xdc}, {0xa3, 0x9a, 0x90}};
    return colors[i % 6];
}

Color categoryColor(int i) {
    static constexpr Color colors[] = {
        {0xcf, 0xe3, 0xe0}, {0xd9, 0xa4, 0x41}, {0xc8, 0x32, 0x1f}, {0x16, 0x20, 0x2c}};
    return colors[i % 4];
}

std::vector<double> dashPattern(Dash dash) {
    static const std::vector<double> patterns[] = {{}, {10, 6}, {12, 5, 3, 5}, {3, 5}, {20, 7}, {}};
    return patterns[static_cast<int>(dash)];
}

CurveStyle curveStyle(int i) {
    return {i % 6, static_cast<Marker>(1 + i % 6), static_cast<Dash>(i % 5), i / 6 % 2 == 1};
}

void addWord(Drawing& drawing, double x, double baseline, const std::string& text, TextStyle style,
             Anchor anchor, double room) {
    if (text.empty()) return;
    style.size *= std::min(1.0, room / textWidth(text, style));
    const double share = anchor == Anchor::left ? 0 : anchor == Anchor::middle ? 0.5 : 1;
    drawing.items.emplace_back(Word{x - share * textWidth(text, style), baseline, text, style});
}

void addLine(Drawing& drawing, PagePoint a, PagePoint b, Color color, double width) {
    drawing.items.emplace_back(Stroke{{a, b}, false, color, width, {}});
}

void addRectangle(Drawing& drawing, const PageBox& box, Color color, double alpha) {
    drawing.items.emplace_back(Area{corners(box), color, alpha, true});
}

namespace {

void addCross(Drawing& drawing, PagePoint c, Color color, bool upright, double r) {
    const PagePoint arms[] = {upright ? PagePoint{0, 1.3} : PagePoint{1, -1},
                              upright ? PagePoint{1.3, 0} : PagePoint{1, 1}};
    for (const bool outline : {true, false})
        for (const auto& [x, y] : arms) {
            const double reach = outline ? 1.1 * r : r;
            addLine(drawing, {c.x - reach * x, c.y - reach * y}, {c.x + reach * x, c.y + reach * y},
                    outline ? ink : color, outline ? 5.4 : 3);
        }
}

// A marker's corners on a circle, the first straight up but for `turn` of the angle between two.
struct Regular {
    int corners;
    double reach, turn;
};

Regular polygonOf(Marker marker) {
    switch (marker) {
        case Marker::square:
            return {4, 1.25, 0.5};
        case Marker::diamond:
            return {4, 1.3, 0};
        case Marker::triangle:
            return {3, 1.4, 0};
        default:  // wedge
            return {3, 1.4, 0.5};
    }
}

}  // namespace

// Outlined in ink: pale colours stand out from the ground by it.
void addMarker(Drawing& drawing, PagePoint c, const CurveStyle& style, double r) {
    constexpr double rim = 1.2;
    const auto shape = [&](double radius, Color filling) {
        if (style.marker == Marker::disc) {
            drawing.items.emplace_back(Disc{c, radius + rim / 2, ink});
            drawing.items.emplace_back(Disc{c, radius - rim / 2, filling});
            return;
        }
        const Regular polygon = polygonOf(style.marker);
        std::vector<PagePoint> points;
        for (int i = 0; i < polygon.corners; ++i) {
            const double angle = 2 * std::numbers::pi * (i + polygon.turn) / polygon.corners;
            points.push_back({c.x + polygon.reach * radius * std::sin(angle),
                              c.y - polygon.reach * radius * std::cos(angle)});
        }
        drawing.items.emplace_back(Area{points, filling});
        drawing.items.emplace_back(Stroke{points, true, ink, rim, {}});
    };
    const Color color = curveColor(style.color);
    if (style.marker == Marker::none) return;
    if (style.marker == Marker::cross) return addCross(drawing, c, color, style.open, r);
    shape(r, color);
    if (style.open) shape(0.5 * r, chartGround);
}

}  // namespace plait
