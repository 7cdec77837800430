#include "chart_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plait {

Color curveColor(int i) {
    static constexpr std::array<Color, 6> colors{{{0x16, 0x20, 0x2c},
                                                  {0xc8, 0x32, 0x1f},
                                                  {0x13, 0x7b, 0x85},
                                                  {0xd9, 0xa4, 0x41},
                                                  {0x86, 0xb4, 0xdc},
                                                  {0xa3, 0x9a, 0x90}}};
    return colors[static_cast<std::size_t>(i) % colors.size()];
}

Color categoryColor(int i) {
    static constexpr std::array<Color, 4> colors{
        {{0xcf, 0xe3, 0xe0}, {0xd9, 0xa4, 0x41}, {0xc8, 0x32, 0x1f}, {0x16, 0x20, 0x2c}}};
    return colors[static_cast<std::size_t>(i) % colors.size()];
}

std::vector<double> dashPattern(Dash dash) {
    switch (dash) {
        case Dash::dashed:
            return {10, 6};
        case Dash::dotted:
            return {3, 5};
        case Dash::dashDotted:
            return {12, 5, 3, 5};
        case Dash::longDashed:
            return {20, 7};
        default:
            return {};
    }
}

CurveStyle curveStyle(int i) {
    static constexpr std::array markers{Marker::disc,    Marker::square, Marker::triangle,
                                        Marker::diamond, Marker::cross,  Marker::wedge};
    static constexpr std::array dashes{Dash::solid, Dash::dashed, Dash::dashDotted, Dash::dotted,
                                       Dash::longDashed};
    const auto k = static_cast<std::size_t>(i);
    return {i % 6, markers[k % markers.size()], dashes[k % dashes.size()], i / 6 % 2 == 1};
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

void addRectangle(Drawing& drawing, const Box& box, Color color, double alpha) {
    drawing.items.emplace_back(Area{{{box.left, box.top},
                                     {box.right, box.top},
                                     {box.right, box.bottom},
                                     {box.left, box.bottom}},
                                    color,
                                    alpha,
                                    true});
}

namespace {

// Corners on a circle, the first straight up.
std::vector<PagePoint> regular(PagePoint center, double radius, int corners, double turn) {
    std::vector<PagePoint> result;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + turn) / corners;
        result.push_back(
            {center.x + radius * std::sin(angle), center.y - radius * std::cos(angle)});
    }
    return result;
}

void addCross(Drawing& drawing, PagePoint c, Color color, bool upright, double r) {
    for (const bool outline : {true, false}) {
        const double reach = (outline ? 1.1 : 1) * (upright ? 1.3 : 1) * r;
        for (const double sign : {-1.0, 1.0}) {
            const PagePoint d = upright ? PagePoint{sign > 0 ? reach : 0, sign > 0 ? 0 : reach}
                                        : PagePoint{reach, sign * reach};
            addLine(drawing, {c.x - d.x, c.y - d.y}, {c.x + d.x, c.y + d.y}, outline ? ink : color,
                    outline ? 5.4 : 3);
        }
    }
}

}  // namespace

// Outlined in ink: pale colours stand out from the ground by it.
void addMarker(Drawing& drawing, PagePoint c, const CurveStyle& style, double r) {
    const Color color = curveColor(style.color);
    constexpr double rim = 1.2;
    const auto shape = [&](double radius, Color filling) {
        const auto polygon = [&](double reach, int corners, double turn) {
            const auto points = regular(c, reach * radius, corners, turn);
            drawing.items.emplace_back(Area{points, filling});
            drawing.items.emplace_back(Stroke{points, true, ink, rim, {}});
        };
        switch (style.marker) {
            case Marker::disc:
                drawing.items.emplace_back(Disc{c, radius + rim / 2, ink});
                drawing.items.emplace_back(Disc{c, radius - rim / 2, filling});
                break;
            case Marker::square:
                polygon(1.25, 4, 0.5);
                break;
            case Marker::diamond:
                polygon(1.3, 4, 0);
                break;
            case Marker::triangle:
                polygon(1.4, 3, 0);
                break;
            case Marker::wedge:
                polygon(1.4, 3, 0.5);
                break;
            default:
                break;
        }
    };
    if (style.marker == Marker::cross) return addCross(drawing, c, color, style.open, r);
    shape(r, color);
    if (style.open) shape(0.5 * r, chartGround);
}

}  // namespace plait
