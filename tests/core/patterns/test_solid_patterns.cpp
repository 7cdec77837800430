// Solids cut into convex cells: closed, apart by the kerf, and all of the solid less the kerfs.
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/surfaces/solid.h>
#include <plait/numbers/splitmix.h>
#include <plait/patterns/solid_pattern.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double kerf = 2e-5;  // m

std::vector<HalfSpace> box(double x, double y, double z) {
    return {{{1, 0, 0}, x},  {{-1, 0, 0}, 0}, {{0, 1, 0}, y},
            {{0, -1, 0}, 0}, {{0, 0, 1}, z},  {{0, 0, -1}, 0}};
}

std::vector<Lump> lumps(int count) {
    Splitmix random(3);
    std::vector<Lump> all;
    for (int i = 0; i < count; ++i) {
        const double x = random.next(), y = random.next(), z = random.next();
        all.push_back({{0.2 * x, 0.1 * y, 0.15 * z}, box(0.2, 0.1, 0.15)});
    }
    return all;
}

double volumeOf(const Shape& shape) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < shape.complex.count(2); ++t) triangles.push_back(shape.complex.triangle(t));
    return solidMoments(shape.positions, triangles).volume;
}

}  // namespace

TEST_CASE("solid patterns: cells fill a box but for their kerfs", "[patterns]") {
    const SolidPattern pattern = cut(lumps(200), kerf);
    double sum = 0, faces = 0;
    for (const Shape& cell : pattern.cells) sum += volumeOf(cell);
    for (const SolidSeam& seam : pattern.seams) faces += seam.length * seam.height;
    // Where kerfs meet, faces are short by about as much as a kerf is wide.
    CHECK(report("cells and kerfs over the box, off by",
                 std::fabs((sum + kerf * faces) / (0.2 * 0.1 * 0.15) - 1), 1e-4));
    CHECK(sum < (1 - 1e-3) * 0.2 * 0.1 * 0.15);
}

TEST_CASE("solid patterns: a cell is nearer to its own site than to any other, by half the kerf",
          "[patterns]") {
    const std::vector<Lump> all = lumps(100);
    const SolidPattern pattern = cut(all, kerf);
    double least = 1;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const Vec<double>& x : pattern.cells[i].positions)
            for (std::size_t j = 0; j < all.size(); ++j) {
                const Vec<double> way = all[j].site - all[i].site;
                if (i == j) continue;
                const Vec<double> middle = 0.5 * (all[i].site + all[j].site);
                least = std::min(least, dot(middle - x, way) / length(way));
            }
    CHECK(least >= kerf / 4);
}

TEST_CASE("solid patterns: two halves of a bar have its section in common", "[patterns]") {
    const std::vector<Lump> halves{{{0.25, 0.05, 0.1}, box(1, 0.1, 0.2)},
                                   {{0.75, 0.05, 0.1}, box(1, 0.1, 0.2)}};
    const SolidPattern pattern = cut(halves, kerf);
    REQUIRE(pattern.seams.size() == 1);
    const SolidSeam& seam = pattern.seams[0];
    CHECK(seam.length == Approx(0.2));
    CHECK(seam.height == Approx(0.1));
    CHECK(std::fabs(seam.along.z) == Approx(1));
    CHECK(volumeOf(pattern.cells[0]) == Approx((0.5 - kerf / 2) * 0.1 * 0.2));
}

TEST_CASE("solid patterns: lumps that are no solids are refused", "[patterns]") {
    std::vector<Lump> two = lumps(2);
    CHECK_THROWS_WITH(cut(two, 0), "the kerf must be positive");
    two[1].site.x = 0.3;
    CHECK_THROWS_WITH(cut(two, kerf), "lump 1 lacks its site");
    two[1].site = two[0].site;
    CHECK_THROWS_WITH(cut(two, kerf), "lump 0 has the site of another");
    two[1] = {{5, 0, 0}, {{{-1, 0, 0}, -4}}};
    CHECK_THROWS_WITH(cut(two, kerf), "lump 1 is empty or open");
}
