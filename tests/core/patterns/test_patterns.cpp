// Panes cut into cells: convex, closed, all of the pane less the kerf.
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/surfaces/solid.h>
#include <plait/patterns/pattern.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

using namespace plait;
using namespace plait::test;

namespace {

constexpr Pane pane{.width = 0.6, .height = 0.5, .thickness = 0.004, .leastCell = 10e-6};

Pattern star(std::uint64_t seed) {
    return cut(pane, starSites(pane, {.centre = {0.25, 0.3}}, 400, seed));
}

double volumeOf(const Shape& shape) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < shape.complex.count(2); ++t) triangles.push_back(shape.complex.triangle(t));
    return solidMoments(shape.positions, triangles).volume;
}

// Of the pane, by which kerfs and cells miss filling it.
double missing(const Pattern& pattern) {
    double sum = 0;
    for (const Cell& cell : pattern.cells) sum += volumeOf(prismOf(cell, pane.thickness));
    for (const Seam& seam : pattern.seams)
        if (!seam.onBorder())
            sum += pane.kerf * pane.thickness *
                   std::hypot(seam.to.x - seam.from.x, seam.to.y - seam.from.y);
    return std::fabs(sum / (pane.width * pane.height * pane.thickness) - 1);
}

bool convex(const Cell& cell) {
    const std::size_t n = cell.outline.size();
    bool turns = n >= 3;
    for (std::size_t i = 0; i < n; ++i) {
        const PlanePoint &a = cell.outline[i], &b = cell.outline[(i + 1) % n],
                         &c = cell.outline[(i + 2) % n];
        turns = turns && (b.x - a.x) * (c.y - b.y) > (b.y - a.y) * (c.x - b.x);
    }
    return turns;
}

// Every edge of its surface belongs to two triangles, one each way.
bool closed(const Shape& shape) {
    std::map<std::pair<int, int>, int> edges;
    for (int t = 0; t < shape.complex.count(2); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::array<int, 3> v = shape.complex.triangle(t);
            ++edges[{v[k], v[(k + 1) % 3]}];
        }
    return std::ranges::all_of(edges, [&](const auto& edge) {
        const auto back = edges.find({edge.first.second, edge.first.first});
        return edge.second == 1 && back != edges.end() && back->second == 1;
    });
}

}  // namespace

TEST_CASE("patterns: cells are convex, closed and fill the pane", "[patterns]") {
    for (const Pattern& pattern : {star(1), star(2), cut(pane, evenSites(pane, 300, 3))}) {
        note("cells", static_cast<double>(pattern.cells.size()));
        REQUIRE(pattern.cells.size() > 200);
        REQUIRE(std::ranges::all_of(pattern.cells, convex));
        REQUIRE(std::ranges::all_of(pattern.cells,
                                    [](const Cell& cell) { return closed(prismOf(cell, 0.004)); }));
        // Corners where three kerfs meet are counted more than once.
        REQUIRE(report("of a pane is missing", missing(pattern), 2e-5));
    }
}

TEST_CASE("patterns: what two cells share lies midway between their sites", "[patterns]") {
    const Pattern pattern = star(1);
    std::map<std::pair<int, int>, int> pairs;
    double worst = 0;
    for (const Seam& seam : pattern.seams) {
        ++pairs[{seam.first, seam.second}];
        if (seam.onBorder()) continue;
        REQUIRE(seam.first < seam.second);
        REQUIRE(seam.second < std::ssize(pattern.cells));
        const PlanePoint &a = pattern.cells[seam.first].site, &b = pattern.cells[seam.second].site;
        for (const PlanePoint& p : {seam.from, seam.to})
            worst = std::max(worst, std::fabs(std::hypot(p.x - a.x, p.y - a.y) -
                                              std::hypot(p.x - b.x, p.y - b.y)));
    }
    REQUIRE(std::ranges::all_of(pairs, [](const auto& pair) { return pair.second == 1; }));
    REQUIRE(report("a seam is off the middle, m", worst, 1e-12));
    // Around each cell its seams close.
    std::vector<PlanePoint> sum(pattern.cells.size(), {0, 0});
    for (const Seam& seam : pattern.seams) {
        const double x = seam.to.x - seam.from.x, y = seam.to.y - seam.from.y;
        sum[seam.first].x += x, sum[seam.first].y += y;
        if (!seam.onBorder()) sum[seam.second].x -= x, sum[seam.second].y -= y;
    }
    double open = 0;
    for (const PlanePoint& p : sum) open = std::max(open, std::hypot(p.x, p.y));
    REQUIRE(report("seams around a cell are open, m", open, 40e-6));
}

TEST_CASE("patterns: a seed decides, and no cell is too small", "[patterns]") {
    const Pattern once = star(1), again = star(1), other = star(2);
    REQUIRE(once.cells.size() == again.cells.size());
    bool same = true, differs = false;
    for (std::size_t i = 0; i < once.cells.size(); ++i)
        same = same && once.cells[i].site.x == again.cells[i].site.x;
    for (std::size_t i = 0; i < std::min(once.cells.size(), other.cells.size()); ++i)
        differs = differs || once.cells[i].site.x != other.cells[i].site.x;
    REQUIRE(same);
    REQUIRE(differs);
    double least = 1;
    for (const Cell& cell : once.cells) least = std::min(least, volumeOf(prismOf(cell, 1)));
    REQUIRE(least > 0.9 * pane.leastCell);
    REQUIRE_THROWS_WITH(cut(pane, {}), Catch::Contains("site"));
    REQUIRE_THROWS_WITH(cut(pane, {{1, 1}}), Catch::Contains("within"));
    REQUIRE_THROWS_WITH(cut({.width = 0, .height = 1, .thickness = 1}, {{0, 0}}),
                        Catch::Contains("size"));
}
