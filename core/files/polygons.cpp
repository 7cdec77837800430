#include "polygons.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace plait {

namespace {

using Triangles = std::vector<std::array<int, 3>>;

struct Point {
    double x, y;
    friend bool operator==(const Point&, const Point&) = default;
};

// Bounds on the worth of a triangle, far from the rounding of doubles and of a file's decimals.
constexpr double flat = 1e-9;     // up to here it has no area
constexpr double turned = -1e-3;  // up to here it is turned over

// Twice the area, below 0 if turned over.
double area(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double squaredDistance(const Point& a, const Point& b) {
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

// Its area over the squares of its edges: 0.29 for the best triangle, whatever its size.
double worth(const Point& a, const Point& b, const Point& c) {
    return divide(area(a, b, c),
                  squaredDistance(a, b) + squaredDistance(b, c) + squaredDistance(c, a));
}

Vec<double> unit(const Vec<double>& a) { return divide(1.0, length(a)) * a; }

// In the polygon's plane, about 1 in size.
std::vector<Point> flattened(std::span<const Vec<double>> corners) {
    double size = 0;
    for (const Vec<double>& corner : corners) {
        const Vec<double> d = corner - corners[0];
        size = std::max({size, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    std::vector<Vec<double>> x;
    for (const Vec<double>& corner : corners)
        x.push_back(divide(1.0, size) * (corner - corners[0]));
    Vec<double> sum{}, largest{};
    for (std::size_t i = 2; i < x.size(); ++i) {
        const Vec<double> part = cross(x[i - 1], x[i]);
        sum += part;
        if (length(part) > length(largest)) largest = part;
    }
    // Two loops may cancel; seen along one of them, the other is turned over.
    const Vec<double> normal = unit(length(sum) > flat ? sum : largest);
    const Vec<double> n{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    const Vec<double> least = n.x <= n.y && n.x <= n.z ? Vec<double>{1, 0, 0}
                              : n.y <= n.z             ? Vec<double>{0, 1, 0}
                                                       : Vec<double>{0, 0, 1};
    const Vec<double> right = unit(cross(least, normal)), up = cross(normal, right);
    std::vector<Point> points;
    for (const Vec<double>& p : x) points.push_back({dot(p, right), dot(p, up)});
    return points;
}

Triangles splitQuad(const std::vector<Point>& x) {
    const double first = std::min(worth(x[0], x[1], x[2]), worth(x[0], x[2], x[3])),
                 second = std::min(worth(x[0], x[1], x[3]), worth(x[1], x[2], x[3]));
    const bool keeps = first > flat || first > second - flat;
    if (!((keeps ? first : second) > turned)) return {};
    if (keeps) return {{0, 1, 2}, {0, 2, 3}};
    return {{0, 1, 3}, {1, 2, 3}};
}

// Clips ears in the order of their worth. Whether a corner can be clipped changes with its
// neighbours only, so that each is tried again no more often than those change.
class Ears {
public:
    explicit Ears(std::vector<Point> corners) : x_(std::move(corners)) {
        const int count = static_cast<int>(x_.size());
        for (int i = 0; i < count; ++i) {
            before_.push_back((i + count - 1) % count);
            behind_.push_back((i + 1) % count);
        }
        worth_.resize(x_.size(), 1);
        for (int i = 0; i < count; ++i) weigh(i);
    }

    Triangles clipped() {
        Triangles triangles;
        while (triangles.size() + 2 < x_.size()) {
            if (open_.empty()) return {};
            const auto [w, place] = open_.top();
            open_.pop();
            const int i = -place;
            if (w != worth_[at(i)] || (w > flat && blocked(i))) continue;
            const int a = before(i), b = behind(i);
            triangles.push_back({a, i, b});
            behind_[at(a)] = b;
            before_[at(b)] = a;
            worth_[at(i)] = gone;
            weigh(a);
            weigh(b);
        }
        return triangles;
    }

private:
    static constexpr double gone = -1;  // less than any triangle's worth

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    const Point& x(int i) const { return x_[at(i)]; }
    int before(int i) const { return before_[at(i)]; }
    int behind(int i) const { return behind_[at(i)]; }

    void weigh(int i) {
        const bool wasConvex = worth_[at(i)] > flat;
        worth_[at(i)] = worth(x(before(i)), x(i), x(behind(i)));
        if (wasConvex && !(worth_[at(i)] > flat)) dents_.push_back(i);
        if (worth_[at(i)] > turned) open_.emplace(worth_[at(i)], -i);
    }

    // By a corner in the ear: if there is any, there is one that is not convex.
    bool blocked(int i) const {
        return std::ranges::any_of(dents_, [&](int v) {
            const bool other = v != before(i) && v != behind(i);
            return other && worth_[at(v)] != gone && worth_[at(v)] <= flat && inEar(i, v);
        });
    }

    bool inEar(int i, int v) const {
        const Point &a = x(before(i)), &b = x(i), &c = x(behind(i)), &p = x(v);
        if (area(a, b, p) < 0 || area(b, c, p) < 0 || p == a || p == c) return false;
        if (p != b) return worth(c, a, p) > -flat;
        // The polygon touches itself at the tip: from within, if an edge there goes inward.
        const auto inward = [&](const Point& q) { return area(a, b, q) > 0 && area(b, c, q) > 0; };
        return inward(x(before(v))) || inward(x(behind(v)));
    }

    std::vector<Point> x_;
    std::vector<int> before_, behind_;
    std::vector<double> worth_;
    std::vector<int> dents_;                            // where the polygon is or was not convex
    std::priority_queue<std::pair<double, int>> open_;  // of like worth the first corner's
};

}  // namespace

std::vector<std::array<int, 3>> splitPolygon(std::span<const Vec<double>> corners) {
    std::vector<Point> points = flattened(corners);
    return points.size() == 4 ? splitQuad(points) : Ears(std::move(points)).clipped();
}

}  // namespace plait
