#include "parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plait {
namespace {

constexpr double covering = 1e4;  // another word or ring, or the edge of the plot

bool overlap(const PageBox& a, const PageBox& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

// What a word there would hide: px of curves and front.
double hidden(const PageBox& word, const Chart& chart, const Plot& plot,
              std::span<const PageBox> taken, double markerReach) {
    const PageBox& edge = plot.box;
    const PageBox near{word.left - markerReach, word.top - markerReach, word.right + markerReach,
                       word.bottom + markerReach};
    double sum = word.left < edge.left || word.right > edge.right || word.top < edge.top ||
                         word.bottom > edge.bottom
                     ? covering
                     : 0;
    for (const PageBox& box : taken) sum += overlap(word, box) ? covering : 0;
    const auto addLength = [&](PagePoint a, PagePoint b) {
        const auto [first, last] = inside(a, b, word);
        if (first < last) sum += (last - first) * std::hypot(b.x - a.x, b.y - a.y);
    };
    for (const Curve& curve : chart.curves)
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const PagePoint b = plot(curve.points[i]);
            if (contains(near, b)) sum += 40;  // the marker
            if (i > 0 && curve.style.dash != Dash::none) addLength(plot(curve.points[i - 1]), b);
        }
    for (std::size_t i = 1; i < chart.front.size(); ++i) {
        const PagePoint a = plot(chart.front[i - 1]), b = plot(chart.front[i]);
        addLength(a, {b.x, a.y});
        addLength({b.x, a.y}, b);
    }
    return sum;
}

// Where a word can stand beside a point, near before far.
std::vector<PageBox> placesBeside(PagePoint at, double width, double cap, double em) {
    std::vector<PageBox> places;
    for (const double distance : {0.9, 1.5, 2.4})
        for (const double across : {1.0, -1.0, 0.0})
            for (const double up : {-1.0, 0.0, 1.0}) {
                const double x = at.x + distance * em * across + (across - 1) / 2 * width;
                const double middle = at.y + distance * em * up + up * cap / 2;
                places.push_back(
                    {x - 3, middle - cap / 2 - 4, x + width + 3, middle + cap / 2 + 6});
            }
    return places;
}

void addRing(Drawing& drawing, PagePoint p, double radius, double width) {
    std::vector<PagePoint> ring;
    for (int i = 0; i < 48; ++i) {
        const double angle = 2 * std::numbers::pi * i / 48;
        ring.push_back({p.x + radius * std::cos(angle), p.y + radius * std::sin(angle)});
    }
    drawing.items.emplace_back(Stroke{ring, true, chartGround, 2 * width, {}});
    drawing.items.emplace_back(Stroke{ring, true, ink, width, {}});
}

}  // namespace

// A point that several curves share is ringed once; the word is left out where there is no room.
void addHighlights(Drawing& drawing, const Chart& chart, const Plot& plot, double size) {
    const TextStyle style{Weight::semibold, 18 * size, ink};
    const std::string word = "default";
    const double cap = capHeight(style), width = textWidth(word, style);
    std::vector<PageBox> taken;
    for (const Curve& curve : chart.curves) {
        if (!curve.highlighted) continue;
        const PagePoint p = plot(curve.points[static_cast<std::size_t>(*curve.highlighted)]);
        const double reach = 15 * size;
        const PageBox ring{p.x - reach, p.y - reach, p.x + reach, p.y + reach};
        const bool known = std::any_of(taken.begin(), taken.end(),
                                       [&](const PageBox& box) { return contains(box, p); });
        if (known || !contains(plot.box, p)) continue;
        addRing(drawing, p, 13 * size, 3 * size);
        taken.push_back(ring);
        const std::vector<PageBox> places = placesBeside(p, width, cap, style.size);
        std::vector<double> costs;
        for (const PageBox& place : places)
            costs.push_back(hidden(place, chart, plot, taken, 8 * size));
        const auto least = std::min_element(costs.begin(), costs.end());
        if (*least >= covering) continue;
        const PageBox& best = places[static_cast<std::size_t>(least - costs.begin())];
        const PagePoint near{std::clamp(p.x, best.left, best.right),
                             std::clamp(p.y, best.top, best.bottom)};
        const double gap = std::hypot(near.x - p.x, near.y - p.y);
        if (gap > 2 * reach) addLine(drawing, between(p, near, reach / gap), near, ink, 1.5 * size);
        addRectangle(drawing, best, chartGround, 0.9);
        addWord(drawing, best.left + 3, best.top + 4 + cap, word, style);
        taken.push_back(best);
    }
}

}  // namespace plait
