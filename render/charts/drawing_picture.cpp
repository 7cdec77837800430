#include "drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plait {
namespace {

using Polygon = std::vector<PagePoint>;
using Polygons = std::vector<Polygon>;

// How much of each pixel polygons cover that all turn the same way: every edge adds the area to its
// right, signed by whether it goes up or down, as differences along the row; what several cover
// counts once.
class Coverage {
public:
    Coverage(int width, int height)
        : width_(width), height_(height), change_(std::size_t(width + 2) * height) {}

    void addEdge(PagePoint a, PagePoint b) {
        if (a.y == b.y) return;
        const double sign = a.y < b.y ? 1 : -1;
        if (a.y > b.y) std::swap(a, b);
        const double slope = (b.x - a.x) / (b.y - a.y);
        const int last = static_cast<int>(std::floor(std::min(b.y, height_ - 1.0)));
        for (int row = static_cast<int>(std::max(a.y, 0.0)); row <= last; ++row) {
            const double top = std::max<double>(a.y, row), bottom = std::min(b.y, row + 1.0);
            addRow(row, a.x + slope * (top - a.y), a.x + slope * (bottom - a.y),
                   sign * (bottom - top));
        }
    }

    void paintOn(Picture& picture, int left, int top, Color color, double alpha) const {
        for (int y = 0; y < height_; ++y) {
            double sum = 0;
            for (int x = 0; x < width_; ++x) {
                sum += change_[y * (width_ + 2) + x];
                const double covered = std::min(std::abs(sum), 1.0);
                if (covered > 1e-3) paint(picture, left + x, top + y, color, alpha * covered);
            }
        }
    }

private:
    // An edge within a row from x0 to x1, which has `height` of it.
    void addRow(int row, double x0, double x1, double height) {
        if (x0 > x1) std::swap(x0, x1);
        const double right = width_;
        x0 = std::clamp(x0, 0.0, right);
        x1 = std::clamp(x1, 0.0, right);
        // The area right of the edge and left of x, per height.
        const auto area = [&](double x) {
            if (x <= x0) return 0.0;
            if (x >= x1) return x - (x0 + x1) / 2;
            return (x - x0) * (x - x0) / (2 * (x1 - x0));
        };
        double before = 0, share = 0;
        for (int x = static_cast<int>(x0); x <= static_cast<int>(x1) + 1; ++x) {
            const double here = area(x + 1.0), now = here - before;
            change_[row * (width_ + 2) + x] += height * (now - share);
            before = here;
            share = now;
        }
    }

    int width_, height_;
    std::vector<double> change_;
};

void fill(Picture& picture, const Polygons& polygons, Color color, double alpha = 1) {
    double left = picture.width, top = picture.height, right = 0, bottom = 0;
    for (const Polygon& polygon : polygons)
        for (const auto& [x, y] : polygon) {
            left = std::min(left, x);
            top = std::min(top, y);
            right = std::max(right, x);
            bottom = std::max(bottom, y);
        }
    const int x0 = static_cast<int>(std::max(left, 0.0)), y0 = static_cast<int>(std::max(top, 0.0));
    const int width = static_cast<int>(std::ceil(std::min<double>(right, picture.width))) - x0;
    const int height = static_cast<int>(std::ceil(std::min<double>(bottom, picture.height))) - y0;
    if (width <= 0 || height <= 0) return;
    Coverage coverage(width, height);
    const auto moved = [&](PagePoint p) { return PagePoint{p.x - x0, p.y - y0}; };
    for (const Polygon& polygon : polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i)
            coverage.addEdge(moved(polygon[i]), moved(polygon[(i + 1) % polygon.size()]));
    coverage.paintOn(picture, x0, y0, color, alpha);
}

// Appends corners along an arc, ends included.
void addArc(Polygon& polygon, PagePoint center, double radius, double from, double turn,
            int pieces) {
    for (int i = 0; i <= pieces; ++i) {
        const double angle = from + turn * i / pieces;
        polygon.push_back(
            {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
    }
}

Polygon segmentOf(PagePoint a, PagePoint b, double radius) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double x = -(b.y - a.y) / length * radius, y = (b.x - a.x) / length * radius;
    return {{a.x - x, a.y - y}, {b.x - x, b.y - y}, {b.x + x, b.y + y}, {a.x + x, a.y + y}};
}

// The outer side of the corner b, round. Only what the two segments leave open: pixels along an
// edge that two shapes share would count twice, and dense curves look rough.
Polygon cornerOf(PagePoint a, PagePoint b, PagePoint c, double radius) {
    const double in = std::atan2(b.y - a.y, b.x - a.x), out = std::atan2(c.y - b.y, c.x - b.x);
    const double turn = std::remainder(out - in, 2 * std::numbers::pi);
    Polygon polygon{b};
    addArc(polygon, b, radius, (turn > 0 ? in : out) - std::copysign(std::numbers::pi / 2, turn),
           std::abs(turn), 1 + static_cast<int>(std::abs(turn) / 0.3));
    return polygon;
}

// Round where lines meet, blunt at ends.
Polygons outline(const Stroke& stroke) {
    Polygons result;
    const double radius = stroke.width / 2;
    std::size_t k = 0;
    bool on = true;
    double left = stroke.dash.empty() ? HUGE_VAL : stroke.dash[0];
    const std::size_t n = stroke.points.size(), segments = stroke.closed ? n : n - 1;
    for (std::size_t i = 0; i < segments; ++i) {
        const PagePoint a = stroke.points[i], b = stroke.points[(i + 1) % n];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (on && (i > 0 || stroke.closed))
            result.push_back(cornerOf(stroke.points[(i + n - 1) % n], a, b, radius));
        const auto along = [&](double at) {
            return PagePoint{a.x + at / length * (b.x - a.x), a.y + at / length * (b.y - a.y)};
        };
        for (double at = 0; at < length;) {
            const double end = std::min(length, at + left);
            if (on && end > at) result.push_back(segmentOf(along(at), along(end), radius));
            left -= end - at;
            at = end;
            if (left > 1e-9) continue;  // what rounding leaves would never be used up
            on = !on;
            k = (k + 1) % stroke.dash.size();
            left = stroke.dash[k];
        }
    }
    return result;
}

struct Painter {
    Picture& picture;
    PagePoint origin;  // pixels
    double scale;

    PagePoint at(PagePoint p) const { return {origin.x + p.x * scale, origin.y + p.y * scale}; }

    void operator()(Stroke stroke) const {
        if (stroke.points.size() < 2) return;
        for (PagePoint& p : stroke.points) p = at(p);
        for (double& length : stroke.dash) length *= scale;
        stroke.width *= scale;
        fill(picture, outline(stroke), stroke.color);
    }

    void operator()(const Area& area) const {
        Polygon polygon;
        for (const PagePoint& point : area.points) {
            const PagePoint p = at(point);
            polygon.push_back(area.crisp ? PagePoint{std::round(p.x), std::round(p.y)} : p);
        }
        fill(picture, {polygon}, area.color, area.alpha);
    }

    void operator()(const Disc& disc) const {
        Polygon polygon;
        addArc(polygon, at(disc.center), disc.radius * scale, 0, 2 * std::numbers::pi,
               std::max(12, static_cast<int>(4 * disc.radius * scale)));
        fill(picture, {polygon}, disc.color);
    }

    void operator()(const Word& word) const {
        TextStyle style = word.style;
        style.size *= scale;
        const PagePoint p = at({word.x, word.baseline});
        drawText(picture, p.x, p.y, word.text, style);
    }
};

}  // namespace

PageBox boxOf(const Word& word) {
    const double cap = capHeight(word.style);
    return {word.x, word.baseline - cap, word.x + textWidth(word.text, word.style),
            word.baseline + 0.3 * cap};
}

Picture drawingPicture(const Drawing& drawing, double scale) {
    Picture picture = filled(static_cast<int>(std::lround(drawing.width * scale)),
                             static_cast<int>(std::lround(drawing.height * scale)), drawing.ground);
    paintDrawing(picture, 0, 0, drawing, scale);
    return picture;
}

void paintDrawing(Picture& picture, double x, double y, const Drawing& drawing, double scale) {
    for (const auto& item : drawing.items) std::visit(Painter{picture, {x, y}, scale}, item);
}

}  // namespace plait
