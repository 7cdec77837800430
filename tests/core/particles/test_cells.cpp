// Cells against all pairs, and the order of slots.
#include "pools.h"
#include "tests/catch.h"

#include <plait/particles/cells.h>

#include <algorithm>
#include <limits>

using namespace plait;
using namespace plait::test;

namespace {

template <class Real>
std::vector<Vec<Real>> randomPoints(int count, double size, unsigned seed) {
    std::mt19937 random(seed);
    const auto u = [&] {
        return static_cast<Real>(size * static_cast<double>(random()) / 4294967296.0);
    };
    std::vector<Vec<Real>> points;
    for (int i = 0; i < count; ++i) {
        const Real x = u(), y = u(), z = u();
        points.push_back({x, y, z});
    }
    return points;
}

// Dense, strewn wide, with outliers, on the borders of cells, and all in one point.
template <class Real>
std::vector<std::vector<Vec<Real>>> everyCloud() {
    std::vector<std::vector<Vec<Real>>> clouds{
        randomPoints<Real>(1000, 5, 1), randomPoints<Real>(300, 200, 2),
        randomPoints<Real>(700, 4, 3),  {},
        {{Real(3), Real(-2), Real(1)}}, std::vector<Vec<Real>>(40, {1, 2, 3})};
    for (const Real far : {Real(1e3), Real(-1e6)}) {
        clouds[2].push_back({far, 1, 1});
        clouds[2].push_back({far + Real(0.5), 1, 1});
    }
    for (const Vec<double>& p : blockOf(8, 8, 8, 1))
        clouds[3].push_back(
            {static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)});
    return clouds;
}

template <class Real>
Cells<Real> sorted(const std::vector<Vec<Real>>& points, Real reach, int threads) {
    Workers workers(threads);
    Cells<Real> cells;
    cells.sort(static_cast<int>(points.size()), reach, [&](int i) { return points[i]; }, workers);
    return cells;
}

}  // namespace

TEMPLATE_TEST_CASE("cells: around a point is everything that is near", "[liquid][BP3]", float,
                   double) {
    for (const auto& points : everyCloud<TestType>()) {
        const TestType reach = 1;
        const Cells<TestType> cells = sorted(points, reach, 1);
        long seen = 0;
        for (const Vec<TestType>& p : points) {
            std::vector<int> near, expected;
            cells.around(p, [&](int slot) {
                ++seen;
                const Vec<TestType> d = cells.point(slot) - p;
                if (dot(d, d) < reach * reach) near.push_back(cells.order()[slot]);
            });
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Vec<TestType> d = points[i] - p;
                if (dot(d, d) < reach * reach) expected.push_back(static_cast<int>(i));
            }
            std::ranges::sort(near);
            REQUIRE(near == expected);
        }
        // Of a dense cloud 27 cells are looked at, not all.
        if (points.size() == 1000) CHECK(seen < 400 * 1000);
    }
}

TEMPLATE_TEST_CASE("cells: slots go by cell, and in a cell by particle, for any threads",
                   "[liquid][threads]", float, double) {
    auto clouds = everyCloud<TestType>();
    clouds.push_back(randomPoints<TestType>(20000, 12, 5));
    for (const auto& points : clouds) {
        const Cells<TestType> cells = sorted<TestType>(points, 1, 1);
        std::vector<int> seen(points.size(), 0);
        int slot = 0, last = -1;
        for (const int cell : cells.occupied()) {
            REQUIRE(cell > last);
            last = cell;
            REQUIRE(cells.start()[cell] == slot);
            REQUIRE(cells.start()[cell + 1] > slot);
            for (int before = -1; slot < cells.start()[cell + 1]; ++slot) {
                const int i = cells.order()[slot];
                REQUIRE(i > before);
                before = i;
                ++seen[i];
                REQUIRE(cells.point(slot) == points[i]);
            }
        }
        REQUIRE(slot == static_cast<int>(points.size()));
        REQUIRE(std::ranges::all_of(seen, [](int times) { return times == 1; }));
        for (const int threads : {2, 3, 4})
            REQUIRE(
                std::ranges::equal(sorted<TestType>(points, 1, threads).order(), cells.order()));
    }
}

TEST_CASE("cells: what is no number has a cell as well", "[liquid]") {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        auto points = randomPoints<float>(100, 3, 4);
        points[50].y = bad;
        points[0].z = -bad;
        REQUIRE(sorted(points, 1.0F, 1).order().size() == 100);
    }
}
