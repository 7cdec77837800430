// Intersections against closed forms and brute force.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/measure/surfaces/box_tree.h>
#include <plait/measure/surfaces/intersections.h>
#include <plait/measure/surfaces/orientation.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace plait;
using plait::test::Random;

namespace {

using V = Vec<double>;
using Edges = std::vector<std::array<int, 2>>;
using Triangles = std::vector<std::array<int, 3>>;

// A copy of the definition in intersections.h, every pair for itself, without boxes.
std::vector<Intersection> bruteForce(const std::vector<V>& x, const Edges& edges,
                                     const Triangles& triangles) {
    std::vector<Intersection> found;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
            const auto [p, q] = edges[e];
            const auto [a, b, c] = triangles[t];
            if (a == p || b == p || c == p || a == q || b == q || c == q) continue;
            const int ends[]{orientation(x[a], x[b], x[c], x[p]),
                             orientation(x[a], x[b], x[c], x[q])};
            const int sides[]{orientation(x[p], x[q], x[a], x[b]),
                              orientation(x[p], x[q], x[b], x[c]),
                              orientation(x[p], x[q], x[c], x[a])};
            const auto [least, most] = std::minmax({sides[0], sides[1], sides[2]});
            if (ends[0] * ends[1] < 0 && least * most >= 0) found.push_back({e, t});
        }
    }
    return found;
}

Triangles gridTriangles(int columns, int rows) {
    Triangles triangles;
    for (int j = 0; j + 1 < rows; ++j) {
        for (int i = 0; i + 1 < columns; ++i) {
            const int a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
            triangles.push_back({a, b, c});
            triangles.push_back({b, d, c});
        }
    }
    return triangles;
}

// A sheet of columns x rows points, crumpled by waves of the given height.
std::vector<V> sheet(int columns, int rows, double height) {
    std::vector<V> x;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const double u = i / (columns - 1.0), v = j / (rows - 1.0);
            x.push_back({u + height * std::sin(31 * v) * std::cos(17 * u),
                         height * std::sin(40 * u + 9 * v), v + height * std::cos(29 * u + 3 * v)});
        }
    }
    return x;
}

// The triangle (0, 0, 0), (4, 0, 0), (0, 4, 0) and one edge.
int pierced(const V& p, const V& q) {
    const std::vector<V> x{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, q};
    const int count = countIntersections(x, Edges{{3, 4}}, Triangles{{0, 1, 2}});
    CHECK(countIntersections(x, Edges{{4, 3}}, Triangles{{1, 0, 2}}) == count);
    return count;
}

}  // namespace

TEST_CASE("what counts as an intersection", "[intersections]") {
    CHECK(pierced({1, 1, -1}, {1, 1, 1}) == 1);
    CHECK(pierced({1, 1, -1}, {1, 1, -1e-300}) == 0);  // stays below
    CHECK(pierced({3, 3, -1}, {3, 3, 1}) == 0);        // passes by
    CHECK(pierced({2, 0, -1}, {2, 0, 1}) == 1);        // through a side
    CHECK(pierced({2, 2, -1}, {2, 2, 1}) == 1);
    CHECK(pierced({0, 0, -1}, {0, 0, 1}) == 1);  // through a corner
    CHECK(pierced({-1, 1, -1}, {1, -1, 1}) == 1);
    CHECK(pierced({5, 0, -1}, {5, 0, 1}) == 0);  // in line with a side, outside
    CHECK(pierced({2, std::nextafter(0, -1), -1}, {2, -1e-9, 1}) == 0);
    CHECK(pierced({1, 1, 0}, {1, 1, 1}) == 0);   // an end touches
    CHECK(pierced({-1, 1, 0}, {5, 1, 0}) == 0);  // in the plane
    CHECK(pierced({1, 1, 1}, {1, 1, 1}) == 0);   // no length

    // A triangle without area is never pierced; a shared index is no intersection, a shared place
    // is touching.
    const std::vector<V> x{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, -1}, {1, 0, 1}, {0, 0, 0}};
    CHECK(countIntersections(x, Edges{{3, 4}}, Triangles{{0, 1, 2}}) == 0);
    const std::vector<V> fan{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {2, 2, -1}, {2, 2, 1}};
    CHECK(countIntersections(fan, Edges{{4, 5}}, Triangles{{0, 1, 2}, {1, 3, 2}}) == 2);
    CHECK(countIntersections(fan, Edges{{0, 5}}, Triangles{{0, 1, 2}}) == 0);
}

TEST_CASE("two crossed sheets intersect along a line", "[intersections]") {
    // A level sheet and an upright one, each of 7 x 7 squares cut in two, at a generic place.
    const int n = 8;
    std::vector<V> x;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) x.push_back({1.0 * i, 0, 1.0 * j});
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) x.push_back({0.3 + i / 3.0, j - 3.4, 3.21 + i / 50.0});
    }
    auto triangles = gridTriangles(n, n);
    CHECK(countIntersections(x, triangles) == 0);
    for (auto t : gridTriangles(n, n)) {
        for (int& v : t) v += n * n;
        triangles.push_back(t);
    }
    // The upright sheet's row at the crossing has 8 uprights and 7 diagonals, which pierce the
    // level one. The crossing runs from (0.3, 3.21) to (2.633, 3.35) in x and z, so of the level
    // sheet it meets the edges on x = 1, x = 2 and the diagonals on x + z = 4, x + z = 5.
    CHECK(countIntersections(x, triangles) == 8 + 7 + 2 + 2);
}

TEST_CASE("intersections are those of brute force", "[intersections]") {
    Random random(7);
    for (int round = 0; round < 60; ++round) {
        // Random soups; on the coarse lattices of every third round most pairs are degenerate.
        std::vector<V> x;
        for (int i = 0; i < 80; ++i) {
            const V p = random.point(2);
            x.push_back(round % 3 ? p : V{std::round(p.x), std::round(p.y), std::round(p.z)});
        }
        Edges edges;
        Triangles triangles;
        for (int i = 0; i < 150; ++i) {
            edges.push_back({random.below(80), random.below(80)});
            triangles.push_back({random.below(80), random.below(80), random.below(80)});
        }
        const auto found = findIntersections(x, edges, triangles);
        CHECK(found == bruteForce(x, edges, triangles));
        CHECK(found.size() > 100);
    }
    const auto x = sheet(20, 30, 0.3);
    const auto triangles = gridTriangles(20, 30);
    Edges edges;
    for (const auto& [a, b, c] : triangles) edges.insert(edges.end(), {{a, b}, {b, c}});
    CHECK(findIntersections(x, edges, triangles) == bruteForce(x, edges, triangles));
}

TEST_CASE("sheets of 80,000 triangles, timed", "[intersections]") {
    const auto triangles = gridTriangles(201, 201);
    const auto count = [&](const char* what, const std::vector<V>& x) {
        const auto start = std::chrono::steady_clock::now();
        const int found = countIntersections(x, triangles);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        test::note(std::string(what) + ", seconds", time.count());
        return found;
    };
    // Flat but for rounding, and to the bit: the filter decides nothing.
    auto slanted = sheet(201, 201, 0);
    for (auto& p : slanted) p.y = 0.3 * p.x + 0.7 * p.z;
    CHECK(count("slanted sheet", slanted) == 0);
    for (auto& p : slanted) {
        p = {std::round(p.x * 200) / 256, 0, std::round(p.z * 200) / 256};
        p.y = 0.5 * p.x + p.z;
    }
    CHECK(count("slanted sheet on a lattice", slanted) == 0);
    CHECK(count("wavy sheet", sheet(201, 201, 0.02)) == 0);
    const int found = count("crumpled sheet", sheet(201, 201, 0.1));
    test::note("crumpled sheet, intersections", found);
    CHECK(found > 0);
}

TEST_CASE("bad soups are refused", "[intersections]") {
    const std::vector<V> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(countIntersections({}, {}, {}) == 0);
    CHECK(countIntersections(x, Edges{{0, 1}}, {}) == 0);
    CHECK_THROWS_AS(countIntersections(x, Triangles{{0, 1, 3}}), std::invalid_argument);
    CHECK_THROWS_AS(countIntersections(x, Edges{{-1, 0}}, {}), std::invalid_argument);
    const std::vector<V> bad{{0, 0, std::numeric_limits<double>::infinity()}};
    CHECK_THROWS_AS(countIntersections(bad, {}, {}), std::invalid_argument);
}

TEST_CASE("a box tree finds what overlaps", "[intersections]") {
    Random random(7);
    std::vector<Box> boxes;
    for (int i = 0; i < 500; ++i) {
        const V p = random.point(1), s = random.point(0.2);
        boxes.push_back(boxOf(std::array{p, p + s}));
    }
    const BoxTree tree(boxes);
    for (int i = 0; i < 100; ++i) {
        const V p = random.point(1);
        const Box query = boxOf(std::array{p, p + random.point(0.3)});
        std::vector<int> found, expected;
        tree.overlaps(query, [&](int k) { found.push_back(k); });
        for (int k = 0; k < 500; ++k) {
            if (query.overlaps(boxes[k])) expected.push_back(k);
        }
        std::sort(found.begin(), found.end());
        CHECK(found == expected);
    }
}
