#include "penetration.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "../../numbers/finite.h"
#include "../checks.h"
#include "box_tree.h"
#include "orientation.h"

namespace plait {
namespace {

using Point = Vec<double>;
using Corners = std::array<Point, 3>;

// Seen along x: 1 if a, b, p run anticlockwise in (y, z).
int turn(const Point& a, const Point& b, const Point& p) {
    const auto flat = [](const Point& q, double x) { return Point{x, q.y, q.z}; };
    return orientation(flat(p, 1), flat(a, 0), flat(b, 0), flat(p, 0));
}

// The same of a point that is further by e in y and e^2 in z, for e that goes to 0 (Edelsbrunner
// and Muecke, Simulation of simplicity, 1990): 0 only where a and b are one.
int turnBeside(const Point& a, const Point& b, const Point& p) {
    if (const int exact = turn(a, b, p)) return exact;
    if (a.z != b.z) return signOf(a.z - b.z);
    return signOf(b.y - a.y);
}

// Does the ray from p along x, a little beside it, run through the triangle? 1 if it leaves there,
// -1 if it enters. p is not on the triangle.
int crossing(const Corners& t, const Point& p) {
    const int side = turnBeside(t[0], t[1], p);
    if (side == 0 || turnBeside(t[1], t[2], p) != side || turnBeside(t[2], t[0], p) != side)
        return 0;
    // The normal's x has the sign of `side`, and p is before the plane if it is on that side.
    return orientation(t[0], t[1], t[2], p) == side ? side : 0;
}

// Does p lie on the triangle, its sides and corners with it? Not if it has no area.
bool liesOn(const Corners& t, const Point& p) {
    if (orientation(t[0], t[1], t[2], p) != 0) return false;
    const auto turned = [](const Point& q, int axis) {
        return axis == 0 ? q : axis == 1 ? Point{q.y, q.z, q.x} : Point{q.z, q.x, q.y};
    };
    for (int axis = 0; axis < 3; ++axis) {
        const Point a = turned(t[0], axis), b = turned(t[1], axis), c = turned(t[2], axis),
                    q = turned(p, axis);
        const int way = turn(a, b, c);
        if (way == 0) continue;
        return turn(a, b, q) != -way && turn(b, c, q) != -way && turn(c, a, q) != -way;
    }
    return false;
}

void checkClosed(std::span<const std::array<int, 3>> triangles) {
    std::vector<std::array<int, 3>> sides;  // lower vertex, higher vertex, way
    for (const auto& [a, b, c] : triangles)
        for (const auto& [i, j] : {std::array{a, b}, std::array{b, c}, std::array{c, a}})
            if (i != j) sides.push_back({std::min(i, j), std::max(i, j), i < j ? 1 : -1});
    std::sort(sides.begin(), sides.end());
    int sum = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        sum += sides[i][2];
        const bool last = i + 1 == sides.size() || sides[i + 1][0] != sides[i][0] ||
                          sides[i + 1][1] != sides[i][1];
        if (last && sum != 0)
            throw std::invalid_argument("the surface is not closed at edge " +
                                        std::to_string(sides[i][0]) + " " +
                                        std::to_string(sides[i][1]));
    }
}

std::vector<Corners> cornersOf(std::span<const Point> positions,
                               std::span<const std::array<int, 3>> triangles) {
    std::vector<Corners> corners;
    for (const auto& [a, b, c] : triangles)
        corners.push_back({positions[static_cast<std::size_t>(a)],
                           positions[static_cast<std::size_t>(b)],
                           positions[static_cast<std::size_t>(c)]});
    return corners;
}

BoxTree treeOf(std::span<const Corners> triangles) {
    std::vector<Box> boxes;
    for (const Corners& t : triangles) boxes.push_back(boxOf(t));
    return BoxTree(std::move(boxes));
}

}  // namespace

std::vector<int> findInside(std::span<const Point> points, std::span<const Point> positions,
                            std::span<const std::array<int, 3>> triangles) {
    checkIndices(triangles, positions.size());
    if (!allFinite(positions) || !allFinite(points))
        throw std::invalid_argument("a position is not finite");
    checkClosed(triangles);
    const std::vector<Corners> corners = cornersOf(positions, triangles);
    const BoxTree tree = treeOf(corners);
    std::vector<int> inside;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& p = points[i];
        int winding = 0;
        bool on = false;
        constexpr double far = std::numeric_limits<double>::infinity();
        tree.overlaps({p, {far, p.y, p.z}}, [&](int t) {
            const Corners& triangle = corners[static_cast<std::size_t>(t)];
            on = on || liesOn(triangle, p);
            if (!on) winding += crossing(triangle, p);
        });
        if (!on && winding != 0) inside.push_back(static_cast<int>(i));
    }
    return inside;
}

}  // namespace plait
