#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>

#include "tests/catch.h"
#include "tests/report.h"

#include <plait/complex/shapes.h>

using namespace plait;
using plait::test::report;

namespace {

using Point = Vec<double>;

const Point& at(const Shape& shape, int i) { return shape.positions[i]; }

// Twice the area, along the normal.
Point areaVector(const Shape& shape, int t) {
    const auto [a, b, c] = shape.complex.triangle(t);
    return cross(at(shape, b) - at(shape, a), at(shape, c) - at(shape, a));
}

double area(const Shape& shape) {
    double sum = 0;
    for (int t = 0; t < shape.complex.count(2); ++t) sum += length(areaVector(shape, t)) / 2;
    return sum;
}

double totalLength(const Shape& shape) {
    double sum = 0;
    for (int e = 0; e < shape.complex.count(1); ++e) {
        const auto [a, b] = shape.complex.edge(e);
        sum += length(at(shape, b) - at(shape, a));
    }
    return sum;
}

double signedVolume(const Shape& shape, int i) {
    const auto [a, b, c, d] = shape.complex.tetrahedron(i);
    const Point& o = at(shape, a);
    return dot(cross(at(shape, b) - o, at(shape, c) - o), at(shape, d) - o) / 6;
}

// Enclosed by the triangles, by the divergence theorem.
double enclosedVolume(const Shape& shape) {
    double sum = 0;
    for (int t = 0; t < shape.complex.count(2); ++t)
        sum += dot(at(shape, shape.complex.triangle(t)[0]), areaVector(shape, t)) / 6;
    return sum;
}

// Every triangle has area, and neighbours run along a shared edge in opposite directions.
void requireSurface(const Shape& shape) {
    const auto& complex = shape.complex;
    REQUIRE(complex.count(0) == static_cast<int>(shape.positions.size()));
    std::vector<int> sum(complex.count(1));
    const double least = 1e-6 * area(shape) / complex.count(2);
    int degenerate = 0, inconsistent = 0;
    for (int t = 0; t < complex.count(2); ++t) {
        degenerate += !(length(areaVector(shape, t)) > least);
        for (int j = 0; j < 3; ++j) sum[complex.faces(2, t)[j]] += complex.incidence(2, t, j);
    }
    const auto parents = complex.valences(1);
    for (std::size_t e = 0; e < sum.size(); ++e)
        inconsistent += std::abs(sum[e]) != (parents[e] == 1 ? 1 : 0) || parents[e] > 2;
    REQUIRE(degenerate == 0);
    REQUIRE(inconsistent == 0);
    std::set<std::array<double, 3>> places;
    for (const Point& p : shape.positions) places.insert({p.x, p.y, p.z});
    REQUIRE(places.size() == shape.positions.size());
}

std::string refusal(const std::function<void()>& build) {
    try {
        build();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("grid: counts, numbering, diagonals, area") {
    const Shape shape = grid({.columns = 5, .rows = 4, .width = 2, .height = 3});
    requireSurface(shape);
    CHECK(shape.complex.count(0) == 20);
    CHECK(shape.complex.count(1) == 4 * 4 + 5 * 3 + 4 * 3);
    CHECK(shape.complex.count(2) == 24);
    CHECK(area(shape) == Approx(6).epsilon(1e-14));
    CHECK(at(shape, 0) == Point{0, 0, 0});
    CHECK(at(shape, 2 * 5 + 3) == Point{1.5, 2, 0});
    CHECK(at(shape, 19) == Point{2, 3, 0});
    std::set<std::array<int, 2>> expected, found;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 5; ++c) {
            if (c < 4) expected.insert({r * 5 + c, r * 5 + c + 1});
            if (r < 3) expected.insert({r * 5 + c, r * 5 + 5 + c});
            if (c < 4 && r < 3) expected.insert({r * 5 + c, r * 5 + 5 + c + 1});
        }
    for (int e = 0; e < shape.complex.count(1); ++e) found.insert(shape.complex.edge(e));
    CHECK(found == expected);
    for (int t = 0; t < 24; ++t) CHECK(areaVector(shape, t).z > 0);
    CHECK(shape.complex.triangle(2 * 5) == std::array{6, 7, 12});  // cell (1, 1)
    CHECK(shape.complex.triangle(2 * 5 + 1) == std::array{6, 12, 11});
}

TEST_CASE("a frame turns and moves a shape") {
    const Shape shape = grid({.columns = 3, .rows = 2, .width = 2, .height = 1},
                             {.origin = {10, 20, 30}, .across = {0, 0, -1}, .up = {1, 0, 0}});
    CHECK(at(shape, 0) == Point{10, 20, 30});
    CHECK(at(shape, 2) == Point{10, 20, 28});
    CHECK(at(shape, 3) == Point{11, 20, 30});
    for (int t = 0; t < 4; ++t) CHECK(areaVector(shape, t).y < 0);
    const Shape lying = block({}, {.origin = {0, 0, 0}, .across = {1, 0, 0}, .up = {0, 0, 1}});
    for (int i = 0; i < 6; ++i) CHECK(signedVolume(lying, i) > 0);
}

TEST_CASE("disc: counts, and an area that converges to that of the circle") {
    double last = 1;
    for (int rings : {4, 8, 16, 32}) {
        const Shape shape = disc({.rings = rings, .radius = 1.5});
        requireSurface(shape);
        CHECK(shape.complex.count(0) == 1 + 3 * rings * (rings + 1));
        CHECK(shape.complex.count(2) == 6 * rings * rings);
        CHECK(shape.complex.boundary(1).size() == static_cast<std::size_t>(6 * rings));
        const int n = 6 * rings;
        const double polygon = n / 2.0 * 2.25 * std::sin(2 * pi / n);
        CHECK(area(shape) == Approx(polygon).epsilon(1e-13));
        const double error = 1 - area(shape) / (2.25 * pi);
        CHECK(error < last / 3.9);
        last = error;
        int below = 0;
        for (int t = 0; t < shape.complex.count(2); ++t) below += !(areaVector(shape, t).z > 0);
        CHECK(below == 0);
        CHECK(at(shape, 1 + 3 * rings * (rings - 1)).x == Approx(1.5));
    }
    REQUIRE(report("disc of 32 rings, area", last, 2e-4));
}

TEST_CASE("tube: counts, outward normals, the area of a prism") {
    const Shape shape = tube({.segments = 24, .rings = 5, .radius = 0.5, .height = 2});
    requireSurface(shape);
    CHECK(shape.complex.count(0) == 120);
    CHECK(shape.complex.count(2) == 2 * 24 * 4);
    CHECK(shape.complex.boundary(1).size() == 48);
    CHECK(area(shape) == Approx(24 * 2 * 0.5 * std::sin(pi / 24) * 2).epsilon(1e-13));
    for (int t = 0; t < shape.complex.count(2); ++t) {
        const Point& p = at(shape, shape.complex.triangle(t)[0]);
        CHECK(dot(areaVector(shape, t), {p.x, 0, p.z}) > 0);
    }
    CHECK(at(shape, 24 * 4 + 6).y == 2);
    CHECK(at(shape, 24 * 4 + 6).z == Approx(-0.5));
    requireSurface(tube({.segments = 3, .rings = 2}));
}

TEST_CASE("sphere: counts, outward normals, area and volume that converge at second order") {
    double lastArea = 1, lastVolume = 1;
    for (int n = 0; n <= 5; ++n) {
        const Shape shape = sphere({.subdivisions = n, .radius = 2});
        requireSurface(shape);
        const int faces = 20 << 2 * n;
        CHECK(shape.complex.count(0) == faces / 2 + 2);
        CHECK(shape.complex.count(1) == faces * 3 / 2);
        CHECK(shape.complex.count(2) == faces);
        CHECK(shape.complex.boundary(1).empty());
        double radiusError = 0;
        for (const Point& p : shape.positions)
            radiusError = std::max(radiusError, std::abs(length(p) - 2));
        CHECK(radiusError < 1e-14);
        int inward = 0;
        for (int t = 0; t < faces; ++t)
            inward += !(dot(areaVector(shape, t), at(shape, shape.complex.triangle(t)[0])) > 0);
        CHECK(inward == 0);
        const double areaError = 1 - area(shape) / (16 * pi);
        const double volumeError = 1 - enclosedVolume(shape) / (32 * pi / 3);
        CHECK(areaError > 0);
        CHECK(volumeError > 0);
        if (n > 1) CHECK(areaError < lastArea / 3.6);
        if (n > 1) CHECK(volumeError < lastVolume / 3.6);
        lastArea = areaError;
        lastVolume = volumeError;
        std::set<int> valences;
        for (int valence : shape.complex.valences(0)) valences.insert(valence);
        CHECK(valences == (n == 0 ? std::set<int>{5} : std::set<int>{5, 6}));
    }
    REQUIRE(report("sphere of 5 subdivisions, area", lastArea, 1e-3));
    REQUIRE(report("sphere of 5 subdivisions, volume", lastVolume, 2e-3));
}

TEST_CASE("helix: a chain whose length converges to that of the curve") {
    const double exact = 7.5 * std::hypot(2 * pi * 0.3, 0.2);
    double last = 1;
    for (int links : {100, 200, 400, 800}) {
        const Shape shape = helix({.links = links, .radius = 0.3, .turns = 7.5, .pitch = 0.2});
        CHECK(shape.complex.count(0) == links + 1);
        CHECK(shape.complex.count(1) == links);
        CHECK(shape.complex.boundary(0) == std::vector<int>{0, links});
        const double error = 1 - totalLength(shape) / exact;
        CHECK(error < last / 3.8);
        last = error;
        CHECK(shape.positions.back().y == Approx(1.5));
        CHECK(shape.positions.back().x == Approx(-0.3));
    }
    REQUIRE(report("helix of 800 links, length", last, 1e-3));
    const Shape fine = helix({.links = 100, .turns = 1, .pitch = 1});
    const Point a = fine.positions[1] - fine.positions[0],
                b = fine.positions[2] - fine.positions[1];
    const Point c = fine.positions[3] - fine.positions[2];
    CHECK(dot(cross(a, b), c) > 0);  // right-handed
}

TEST_CASE("chain: equal links from end to end") {
    const Shape shape = chain({.links = 7, .from = {1, 2, 3}, .to = {4, -2, 3}});
    CHECK(at(shape, 0) == Point{1, 2, 3});
    CHECK(at(shape, 7) == Point{4, -2, 3});
    for (int e = 0; e < 7; ++e) {
        CHECK(shape.complex.edge(e) == std::array{e, e + 1});
        CHECK(length(at(shape, e + 1) - at(shape, e)) == Approx(5.0 / 7).epsilon(1e-14));
    }
}

TEST_CASE("block: six tetrahedra a cell of equal volume that match across cells", "[SH6]") {
    const Shape shape =
        block({.columns = 3, .rows = 2, .layers = 4, .width = 3, .height = 4, .depth = 2});
    const auto& complex = shape.complex;
    CHECK(complex.count(0) == 4 * 3 * 5);
    CHECK(complex.count(3) == 6 * 24);
    CHECK(at(shape, (4 * 3 + 2) * 4 + 3) == Point{3, 4, 2});
    for (int i = 0; i < complex.count(3); ++i)
        CHECK(signedVolume(shape, i) == Approx(1.0 / 6).epsilon(1e-13));

    // Cells that did not match would leave faces with one parent inside the box.
    double surface = 0, enclosed = 0;
    std::size_t outside = 0;
    const Csr parents = complex.parents(2);
    for (int t : complex.boundary(2)) {
        const auto faces = complex.faces(3, parents[t][0]);
        const int j = static_cast<int>(std::find(faces.begin(), faces.end(), t) - faces.begin());
        const Point outward = complex.incidence(3, parents[t][0], j) * areaVector(shape, t);
        surface += length(outward) / 2;
        enclosed += dot(at(shape, complex.triangle(t)[0]), outward) / 6;
        ++outside;
    }
    CHECK(outside == 2 * 2 * (3 * 2 + 2 * 4 + 4 * 3));
    CHECK(surface == Approx(2 * (12 + 8 + 6)).epsilon(1e-13));
    CHECK(enclosed == Approx(24).epsilon(1e-13));
}

TEST_CASE("parameters out of range are refused by name") {
    CHECK(refusal([] { grid({.columns = 1}); }) == "grid: columns must be at least 2");
    CHECK(refusal([] { grid({.rows = -3}); }) == "grid: rows must be at least 2");
    CHECK(refusal([] { grid({.width = 0}); }) == "grid: width must be finite and above 0");
    CHECK(refusal([] { grid({.height = notANumber}); }) ==
          "grid: height must be finite and above 0");
    CHECK(refusal([] { grid({.columns = 1 << 20, .rows = 1 << 20}); }) ==
          "grid: columns and rows must be fewer: too many vertices for an int");
    CHECK(refusal([] { grid({}, {.origin = {0, notANumber, 0}}); }) ==
          "frame: origin must be finite");
    CHECK(refusal([] { grid({}, {.across = {2, 0, 0}}); }) ==
          "frame: across must be of unit length");
    CHECK(refusal([] { grid({}, {.up = {notANumber, 0, 0}}); }) ==
          "frame: up must be of unit length");
    CHECK(refusal([] { grid({}, {.up = {1, 0, 0}}); }) ==
          "frame: up must be perpendicular to across");
    CHECK(refusal([] { disc({.rings = 0}); }) == "disc: rings must be at least 1");
    CHECK(refusal([] { disc({.radius = infinity}); }) == "disc: radius must be finite and above 0");
    CHECK(refusal([] { tube({.segments = 2}); }) == "tube: segments must be at least 3");
    CHECK(refusal([] { tube({.rings = 1}); }) == "tube: rings must be at least 2");
    CHECK(refusal([] { tube({.radius = -1}); }) == "tube: radius must be finite and above 0");
    CHECK(refusal([] { tube({.height = notANumber}); }) ==
          "tube: height must be finite and above 0");
    CHECK(refusal([] { sphere({.subdivisions = -1}); }) ==
          "sphere: subdivisions must be at least 0");
    CHECK(refusal([] { sphere({.subdivisions = 11}); }) ==
          "sphere: subdivisions must be at most 10");
    CHECK(refusal([] { sphere({.radius = 0}); }) == "sphere: radius must be finite and above 0");
    CHECK(refusal([] { helix({.links = 0}); }) == "helix: links must be at least 1");
    CHECK(refusal([] { helix({.radius = notANumber}); }) ==
          "helix: radius must be finite and above 0");
    CHECK(refusal([] { helix({.turns = 0}); }) == "helix: turns must be finite and above 0");
    CHECK(refusal([] { helix({.turns = 2e5}); }) == "helix: turns must be at most 100000");
    CHECK(refusal([] { helix({.pitch = -1}); }) == "helix: pitch must be finite and at least 0");
    CHECK(refusal([] { chain({.links = 0}); }) == "chain: links must be at least 1");
    CHECK(refusal([] { chain({.from = {notANumber, 0, 0}}); }) == "chain: from must be finite");
    CHECK(refusal([] { chain({.to = {0, 0, 0}}); }) == "chain: to must be another point than from");
    CHECK(refusal([] { block({.columns = 0}); }) == "block: columns must be at least 1");
    CHECK(refusal([] { block({.rows = 0}); }) == "block: rows must be at least 1");
    CHECK(refusal([] { block({.layers = 0}); }) == "block: layers must be at least 1");
    CHECK(refusal([] { block({.width = notANumber}); }) ==
          "block: width must be finite and above 0");
    CHECK(refusal([] { block({.height = -2}); }) == "block: height must be finite and above 0");
    CHECK(refusal([] { block({.depth = 0}); }) == "block: depth must be finite and above 0");
}
