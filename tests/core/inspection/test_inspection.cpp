// Meshes as exporters leave them: what is mended is what it was before it was spoilt, and what is
// refused is named as the file counts.
#include "tests/catch.h"
#include "tests/random.h"

#include <plait/inspection/inspect.h>
#include <plait/measure/surfaces/geometry.h>

#include <algorithm>
#include <array>
#include <set>

using namespace plait;
using namespace plait::test;

namespace {

using Triangles = std::vector<std::array<int, 3>>;

Triangles trianglesOf(const Shape& shape) {
    Triangles all;
    for (int t = 0; t < shape.complex.count(2); ++t) all.push_back(shape.complex.triangle(t));
    return all;
}

Shape shapeOf(std::vector<Vec<double>> positions, const Triangles& triangles,
              const std::vector<std::array<int, 2>>& edges = {}) {
    return {SimplicialComplex(static_cast<int>(positions.size()), {edges, triangles, {}}),
            std::move(positions)};
}

Shape spun(double height) {  // a spindle, closed
    Shape shape = sphere({.subdivisions = 2, .radius = 0.5});
    for (Vec<double>& x : shape.positions)
        x = {0.3 * height * x.x, height * (x.y + 0.5), 0.3 * height * x.z};
    return shape;
}

// Every triangle with corners of its own, off by this part of a metre.
Shape soup(const Shape& shape, double off = 0) {
    Random random(3);
    std::vector<Vec<double>> positions;
    Triangles triangles;
    for (const auto& triangle : trianglesOf(shape)) {
        const int v = static_cast<int>(positions.size());
        triangles.push_back({v, v + 1, v + 2});
        for (const int corner : triangle)
            positions.push_back(shape.positions[corner] + Vec<double>{random.uniform(-off, off),
                                                                      random.uniform(-off, off),
                                                                      random.uniform(-off, off)});
    }
    return shapeOf(positions, triangles);
}

// A sheet of 5 x 4 vertices whose right half has its own copy of the column in the middle, `gap`
// (m) to the right.
Shape split(double gap) {
    const Shape whole = grid({.columns = 5, .rows = 4, .width = 2, .height = 1.5});
    std::vector<Vec<double>> positions = whole.positions;
    std::array<int, 20> copy{};
    for (int v = 2; v < 20; v += 5) {
        copy[v] = static_cast<int>(positions.size());
        positions.push_back(positions[v] + Vec<double>{gap, 0, 0});
    }
    Triangles triangles = trianglesOf(whole);
    for (auto& triangle : triangles)
        if (std::ranges::any_of(triangle, [](int v) { return v % 5 > 2; }))
            for (int& v : triangle)
                if (v % 5 == 2) v = copy[v];
    return shapeOf(positions, triangles);
}

std::string refusal(const Shape& shape, const MeshWanted& wanted,
                    const std::string& file = "a.obj") {
    try {
        inspect(shape, file, wanted);
    } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        CHECK(message.starts_with(file + ": "));
        CHECK(message.find('\n') == std::string::npos);
        return message;
    }
    return "accepted";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

constexpr MeshWanted solid{.solid = true};

}  // namespace

TEST_CASE("inspection: a sound mesh is left as it is", "[inspection][strangers]") {
    for (const bool isSolid : {false, true}) {
        const Shape shape = spun(1.7);
        const InspectedMesh mesh = inspect(shape, "a.obj", {.solid = isSolid});
        CHECK(mesh.warnings.empty());
        CHECK(mesh.shape.complex == shape.complex);
        CHECK(mesh.shape.positions == shape.positions);
        CHECK(mesh.vertices.size() == shape.positions.size());
    }
    // A flag with a streamer of edges, and a seam of three sheets.
    const Shape both = shapeOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 0}},
                               {{0, 1, 2}, {1, 2, 3}, {1, 2, 4}}, {{3, 5}});
    const InspectedMesh mesh = inspect(both, "a.obj");
    CHECK(mesh.shape.complex == both.complex);
    REQUIRE(mesh.warnings.size() == 1);
    CHECK(mesh.warnings[0] ==
          "a.obj: 1 edges of more than two triangles, the first from vertex 2 to 3");
}

TEST_CASE("inspection: vertices that nothing uses are left out", "[inspection][strangers]") {
    Shape whole = grid({.columns = 3, .rows = 3});
    Triangles triangles = trianglesOf(whole);
    for (auto& triangle : triangles)
        for (int& v : triangle) v += v < 4 ? 1 : 2;
    std::vector<Vec<double>> positions = whole.positions;
    positions.insert(positions.begin() + 4, {77, 0, 0});
    positions.insert(positions.begin(), {-77, 0, 0});
    const Shape stray = shapeOf(positions, triangles);
    const InspectedMesh mesh = inspect(stray, "flag.OBJ", {.least = 0.1, .usual = 1, .most = 10});
    CHECK(mesh.shape.complex == whole.complex);
    CHECK(mesh.shape.positions == whole.positions);
    CHECK(mesh.vertices == std::vector<int>{1, 2, 3, 4, 6, 7, 8, 9, 10});
    REQUIRE(mesh.warnings.size() == 1);
    CHECK(mesh.warnings[0] ==
          "flag.OBJ: 2 vertices, the first 1, are on no triangle or edge and left out");
    CHECK(mesh.name(4) == "7");
    CHECK(inspect(stray, "flag.ply").name(4) == "6");
    CHECK(refusal(shapeOf({{0, 0, 0}, {1, 0, 0}}, {}, {{0, 1}}), {}) ==
          "a.obj: no triangles in it");
}

TEST_CASE("inspection: what lies at one place is welded", "[inspection][strangers]") {
    const Shape whole = grid({.columns = 5, .rows = 4, .width = 2, .height = 1.5});
    for (const double gap : {0.0, 1e-6, 1e-4}) {
        const InspectedMesh mesh = inspect(split(gap), "a.obj");
        CHECK(mesh.shape.complex.count(0) == 20);
        CHECK(mesh.shape.complex.count(1) == whole.complex.count(1));
        CHECK(mesh.shape.complex.boundary(1).size() == 14);
        REQUIRE(mesh.warnings.size() == 1);
        CHECK(mesh.warnings[0] ==
              "a.obj: 4 vertices, the first 21, are where others are (3) and welded");
    }
    // Not at one place, and yet one would think so.
    const InspectedMesh nearly = inspect(split(0.02), "a.obj");
    CHECK(nearly.shape.complex.count(0) == 24);
    REQUIRE(nearly.warnings.size() == 1);
    CHECK(nearly.warnings[0] ==
          "a.obj: 4 vertices, the first 3, are nearly where others are (21, 20 "
          "mm off) and not welded");
    // As far apart as vertices are: an open seam.
    CHECK(inspect(split(0.3), "a.obj").warnings.empty());

    // What was written triangle by triangle, with six digits.
    const InspectedMesh body = inspect(soup(spun(1.7), 1e-6), "a.ply", solid);
    CHECK(body.shape.complex.count(0) == 162);
    CHECK(body.shape.complex.eulerCharacteristic() == 2);
    CHECK(body.shape.complex.boundary(1).empty());

    // A triangle that is a point, on an edge.
    std::vector<Vec<double>> positions = whole.positions;
    positions.push_back(positions[7]);
    Triangles triangles = trianglesOf(whole);
    triangles.push_back({7, 8, 20});
    const InspectedMesh mesh = inspect(shapeOf(positions, triangles), "a.obj");
    CHECK(mesh.shape.complex == whole.complex);
}

TEST_CASE("inspection: a mesh in other units is told by its size", "[inspection][strangers]") {
    const MeshWanted body{.solid = true, .least = 0.5, .usual = 1.7, .most = 3.5};
    CHECK(refusal(spun(170), body) ==
          "a.obj: 170 m tall, where 0.5 to 3.5 m are of use: is it in centimetres?");
    CHECK(has(refusal(spun(1700), body), "1700 m tall"));
    CHECK(has(refusal(spun(1700), body), "millimetres?"));
    CHECK(has(refusal(spun(67), body), "inches?"));
    CHECK(has(refusal(spun(5.6), body), "feet?"));
    CHECK(has(refusal(spun(0.0017), body), "kilometres?"));
    CHECK(refusal(spun(0.4), body) == "a.obj: 0.4 m tall, where 0.5 to 3.5 m are of use");
    CHECK(refusal(spun(1.2), body) == "accepted");
    Shape lying = spun(1.7);
    for (Vec<double>& x : lying.positions) x = {x.x, -0.5 * x.z, x.y};
    CHECK(has(refusal(lying, body), "is z up?"));
    const MeshWanted flag{.least = 0.05, .usual = 1.9, .most = 30};
    CHECK(refusal(grid({.columns = 4, .rows = 3, .width = 190, .height = 120}), flag) ==
          "a.obj: 190 m across, where 0.05 to 30 m are of use: is it in centimetres?");
    CHECK(refusal(grid({.columns = 4, .rows = 3, .width = 8, .height = 5}), flag) == "accepted");
}

TEST_CASE("inspection: a body is closed and faces outward", "[inspection][strangers]") {
    const Shape whole = spun(1.7);
    const Triangles outward = trianglesOf(whole);
    const double inside = volume(whole.positions, outward);
    Random random(5);
    Triangles inward = outward, mixed = outward;
    for (auto& t : inward) std::swap(t[0], t[1]);
    int turned = 0;
    for (auto& t : mixed)
        if (random.below(3) == 0) std::swap(t[1], t[2]), ++turned;
    for (const auto& [triangles, count] :
         {std::pair{inward, static_cast<int>(outward.size())}, {mixed, turned}}) {
        const InspectedMesh mesh = inspect(shapeOf(whole.positions, triangles), "a.obj", solid);
        CHECK(volume(mesh.shape.positions, trianglesOf(mesh.shape)) ==
              Approx(inside).epsilon(1e-12));
        REQUIRE(mesh.warnings.size() == 1);
        CHECK(mesh.warnings[0] == "a.obj: " + std::to_string(count) +
                                      " of its 320 triangles faced inward and were turned");
    }
    // Two parts, one of them inside out: eyes.
    Triangles two = outward;
    std::vector<Vec<double>> positions = whole.positions;
    for (const auto& [a, b, c] : outward) two.push_back({c + 162, b + 162, a + 162});
    for (const Vec<double>& x : whole.positions)
        positions.push_back(0.1 * x + Vec<double>{0, 1, 0});
    const InspectedMesh eyes = inspect(shapeOf(positions, two), "a.obj", solid);
    CHECK(volume(eyes.shape.positions, trianglesOf(eyes.shape)) == Approx(1.001 * inside));

    Triangles holed = outward;
    holed.erase(holed.begin() + 17);
    const auto& gone = outward[17];
    const int low = *std::ranges::min_element(gone), high = *std::ranges::max_element(gone);
    CHECK(refusal(shapeOf(whole.positions, holed), solid) ==
          "a.obj: not closed: open at 3 edges, the first from vertex " + std::to_string(low + 1) +
              " to " + std::to_string(gone[0] + gone[1] + gone[2] - low - high + 1));
    // Moebius's: closed by nothing, and with one side only.
    Triangles strip;
    positions.clear();
    for (int i = 0; i < 9; ++i) {
        const double turn = 2 * 3.14159265 * i / 9, half = turn / 2;
        for (const double s : {-0.3, 0.3})
            positions.push_back({(1 + s * std::cos(half)) * std::cos(turn), s * std::sin(half),
                                 (1 + s * std::cos(half)) * std::sin(turn)});
        const int p = 2 * i, q = i == 8 ? 1 : 2 * i + 2, r = i == 8 ? 0 : 2 * i + 3;
        strip.push_back({p, p + 1, q});
        strip.push_back({p + 1, r, q});
    }
    CHECK(has(refusal(shapeOf(positions, strip), solid), "not closed: open at"));
    // Klein's bottle, glued from a square, which has no edge and no outside.
    constexpr int n = 5;
    positions.clear(), strip.clear();
    for (int i = 0; i < n * n; ++i) positions.push_back(random.point(1));
    const auto at = [](int r, int c) {
        return r < n ? n * r + c % n : n * (r - n) + (2 * n - c) % n;
    };
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
            strip.push_back({at(r, c), at(r, c + 1), at(r + 1, c)});
            strip.push_back({at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)});
        }
    CHECK(has(refusal(shapeOf(positions, strip), solid), "cannot all face outward"));
}

TEST_CASE("inspection: triangles without area and vertices without mass",
          "[inspection][strangers]") {
    // A T-junction: the vertex weighs by its other triangles.
    const Shape junction = shapeOf({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}},
                                   {{0, 1, 3}, {0, 2, 1}, {0, 4, 2}, {2, 4, 1}});
    const InspectedMesh mesh = inspect(junction, "a.ply");
    CHECK(mesh.shape.complex == junction.complex);
    REQUIRE(mesh.warnings.size() == 1);
    CHECK(mesh.warnings[0] == "a.ply: a triangle without area, of vertices 0, 1 and 2");
    const Shape hung =
        shapeOf({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {3, 0, 0}}, {{0, 1, 2}, {0, 1, 3}});
    CHECK(refusal(hung, {}) == "a.obj: vertex 4 has no mass: its triangles have no area");
    const Shape tied = shapeOf({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {3, 0, 0}, {4, 0, 0}},
                               {{0, 1, 2}, {0, 1, 3}}, {{3, 4}});
    CHECK(refusal(tied, {}) == "accepted");
}

TEST_CASE("inspection: what crosses or lies on itself at the start is refused",
          "[inspection][strangers]") {
    const auto refused = [](const Shape& shape) {
        const InspectedMesh mesh = inspect(shape, "a.obj");
        try {
            refuseCrossing(mesh, mesh.shape.positions);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    CHECK(refused(grid({.columns = 9, .rows = 9})) == "accepted");
    // A needle through a triangle, of the same mesh, in a file with a stray vertex before it.
    const Shape pierced =
        shapeOf({{9, 9, 9}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0.1, 1}, {2, 2, 0}},
                {{1, 2, 3}, {4, 5, 6}});
    CHECK(
        refused(pierced) ==
        "a.obj: it crosses itself at the start, in 2 places, the first the edge from vertex 3 to 4 "
        "through the triangle of 5, 6 and 7");
    // Two sides over the same vertices: diagonals cross in the plane.
    const std::vector<Vec<double>> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    CHECK(refused(shapeOf(square, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})) ==
          "a.obj: it lies on itself at the start, at vertices 1 and 2");
    Shape apart =
        shapeOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.01}, {1, 0, 0.01}, {0, 1, 0.01}},
                {{0, 1, 2}, {3, 4, 5}});
    CHECK(refused(apart) == "accepted");
}
