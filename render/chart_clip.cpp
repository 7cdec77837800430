#include "chart_parts.h"

#include <algorithm>

namespace plait {
namespace {

PagePoint between(PagePoint a, PagePoint b, double s) {
    return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
}

// Of the segment the part within the box, as fractions (Liang and Barsky 1984); first > last: none.
std::pair<double, double> inside(PagePoint a, PagePoint b, const Box& box) {
    double first = 0, last = 1;
    const auto keep = [&](double distance, double change) {  // distance + s change >= 0
        if (change > 0) first = std::max(first, -distance / change);
        if (change < 0) last = std::min(last, -distance / change);
        if (change == 0 && distance < 0) last = -1;
    };
    keep(a.x - box.left, b.x - a.x);
    keep(box.right - a.x, a.x - b.x);
    keep(a.y - box.top, b.y - a.y);
    keep(box.bottom - a.y, a.y - b.y);
    return {first, last};
}

}  // namespace

std::vector<std::vector<PagePoint>> clippedLine(std::span<const PagePoint> points, const Box& box) {
    std::vector<std::vector<PagePoint>> result;
    bool goesOn = false;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        // A join without a direction would be drawn as one that turns.
        if (points[i].x == points[i + 1].x && points[i].y == points[i + 1].y) continue;
        const auto [first, last] = inside(points[i], points[i + 1], box);
        if (first >= last) {
            goesOn = false;
            continue;
        }
        if (!goesOn || first > 0) result.push_back({between(points[i], points[i + 1], first)});
        result.back().push_back(between(points[i], points[i + 1], last));
        goesOn = last == 1;
    }
    return result;
}

// Side by side (Sutherland and Hodgman 1974).
std::vector<PagePoint> clippedArea(std::vector<PagePoint> points, const Box& box) {
    const auto cut = [&](auto distance) {
        std::vector<PagePoint> kept;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const PagePoint a = points[i], b = points[(i + 1) % points.size()];
            const double from = distance(a), to = distance(b);
            if (from >= 0) kept.push_back(a);
            if ((from < 0) != (to < 0)) kept.push_back(between(a, b, from / (from - to)));
        }
        points = std::move(kept);
    };
    cut([&](PagePoint p) { return p.x - box.left; });
    cut([&](PagePoint p) { return box.right - p.x; });
    cut([&](PagePoint p) { return p.y - box.top; });
    cut([&](PagePoint p) { return box.bottom - p.y; });
    return points;
}

}  // namespace plait
