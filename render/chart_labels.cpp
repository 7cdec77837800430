#include "chart_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plait {
namespace {

// What a label should not hide: points along curves, and words and rings that are there already.
struct Obstacles {
    std::vector<PagePoint> points;
    std::vector<Box> boxes;
};

std::vector<PagePoint> alongCurves(const Chart& chart, const Plot& plot) {
    constexpr double step = 5;
    std::vector<PagePoint> result;
    for (const Curve& curve : chart.curves)
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const PagePoint a = plot(curve.points[i]);
            const bool last = i + 1 == curve.points.size();
            if (last && !curve.closed) {
                result.push_back(a);
                break;
            }
            const PagePoint b = plot(curve.points[last ? 0 : i + 1]);
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            if (length > 4 * (plot.box.right - plot.box.left)) continue;
            for (double at = 0; at <= length; at += step)
                result.push_back({a.x + at / std::max(length, 1.0) * (b.x - a.x),
                                  a.y + at / std::max(length, 1.0) * (b.y - a.y)});
        }
    return result;
}

bool overlap(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Box grown(const Box& box, double by) {
    return {box.left - by, box.top - by, box.right + by, box.bottom + by};
}

constexpr double covering = 1e4;  // another word, or the edge
constexpr double sample = 10;     // 5 px of a curve

// How much a word there would hide.
double cost(const Box& word, const Obstacles& obstacles, const Box& plot) {
    double sum = 0;
    if (word.left < plot.left || word.right > plot.right || word.top < plot.top ||
        word.bottom > plot.bottom)
        sum += covering;
    for (const Box& box : obstacles.boxes) sum += overlap(word, box) ? covering : 0;
    for (const PagePoint& point : obstacles.points) sum += contains(word, point) ? sample : 0;
    return sum;
}

// Where a word can stand beside a point, near before far.
std::vector<Box> placesBeside(PagePoint at, double width, double cap, double em) {
    std::vector<Box> places;
    for (const double distance : {0.9, 1.5, 2.4, 3.6, 5.0})
        for (const double across : {1.0, -1.0, 0.0, 0.5, -0.5})
            for (const double up : {-1.0, 0.0, 1.0}) {
                if (up == 0 && std::abs(across) < 1) continue;
                const double x = at.x + distance * em * across + (across - 1) / 2 * width;
                const double middle = at.y + distance * em * up + up * cap / 2;
                places.push_back(
                    {x - 3, middle - cap / 2 - 4, x + width + 3, middle + cap / 2 + 6});
            }
    return places;
}

// From afar with a line that leads to the point; left out where it would hide more than `most`.
void placeLabel(Drawing& drawing, PagePoint at, const std::string& text, const TextStyle& style,
                double most, Obstacles& obstacles, const Box& plot) {
    if (text.empty()) return;
    const double cap = capHeight(style);
    Box best{};
    double least = HUGE_VAL;
    for (const Box& place : placesBeside(at, textWidth(text, style), cap, style.size)) {
        const double here = cost(place, obstacles, plot);
        if (here < least) {
            least = here;
            best = place;
        }
    }
    if (least > most) return;
    const PagePoint nearest{std::clamp(at.x, best.left, best.right),
                            std::clamp(at.y, best.top, best.bottom)};
    if (std::hypot(nearest.x - at.x, nearest.y - at.y) > 2 * style.size)
        addLine(drawing, at, nearest, chartQuiet, 1.5);
    addRectangle(drawing, best, chartGround, 0.9);
    addWord(drawing, best.left + 3, best.top + 4 + cap, text, style);
    obstacles.boxes.push_back(best);
}

}  // namespace

bool contains(const Box& box, PagePoint p) {
    constexpr double slack = 0.01;
    return p.x >= box.left - slack && p.x <= box.right + slack && p.y >= box.top - slack &&
           p.y <= box.bottom + slack;
}

void addLabels(Drawing& drawing, const Chart& chart, const Plot& plot, double size) {
    const TextStyle style{Weight::semibold, 18 * size, ink};
    Obstacles obstacles{alongCurves(chart, plot), {}};
    struct Wanted {
        PagePoint at;
        std::string text;
        double most;
    };
    std::vector<Wanted> wanted;
    for (const Curve& curve : chart.curves) {
        if (!curve.highlighted) continue;
        const PagePoint p = plot(curve.points[static_cast<std::size_t>(*curve.highlighted)]);
        if (!contains(plot.box, p)) continue;
        std::vector<PagePoint> ring;
        for (int i = 0; i < 48; ++i) {
            const double angle = 2 * std::numbers::pi * i / 48;
            ring.push_back({p.x + 13 * size * std::cos(angle), p.y + 13 * size * std::sin(angle)});
        }
        drawing.items.emplace_back(Stroke{ring, true, chartGround, 6 * size, {}});
        drawing.items.emplace_back(Stroke{ring, true, ink, 3 * size, {}});
        obstacles.boxes.push_back(grown({p.x, p.y, p.x, p.y}, 15 * size));
        wanted.push_back({p, curve.highlight, covering});
    }
    for (const ChartLabel& label : chart.labels)
        if (contains(plot.box, plot(label.at)))
            wanted.push_back({plot(label.at), label.text, 6 * sample});
    for (const Wanted& word : wanted)
        placeLabel(drawing, word.at, word.text, style, word.most, obstacles, plot.box);
}

}  // namespace plait
