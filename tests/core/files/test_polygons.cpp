// Polygons into triangles by their shape: what they cover, what is kept, and what is refused.
#include "mesh_text.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/files/mesh_sequence.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace plait;
using namespace plait::test;

namespace {

using Corners = std::vector<Vec<double>>;

std::string vertices(const Corners& corners) {
    std::string text;
    for (const Vec<double>& p : corners) {
        char line[96];
        std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p.x, p.y, p.z);
        text += line;
    }
    return text;
}

std::string face(const Corners& corners) {
    std::string text = "f";
    for (std::size_t i = 1; i <= corners.size(); ++i) text += " " + std::to_string(i);
    return text + "\n";
}

Shape shapeOf(const Corners& corners) {
    return test::shapeOf("a.obj", vertices(corners) + face(corners));
}

Vec<double> areaOf(const Corners& corners) {
    Vec<double> sum{};
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += 0.5 * cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum;
}

struct Covering {
    double excess = 0;  // of the triangles' area over the polygon's, relative
    double least = 1;   // sine of the least angle; below 0 if turned over
};

// Of a plane polygon, as its face is read.
Covering coveringOf(const Corners& corners) {
    const Shape shape = shapeOf(corners);
    REQUIRE(shape.complex.count(2) == static_cast<int>(corners.size()) - 2);
    const double whole = length(areaOf(corners));
    const Vec<double> normal = (1 / whole) * areaOf(corners);
    Covering covering{.excess = -1};
    for (const auto& triangle : triangles(shape)) {
        Corners x;
        for (const int v : triangle) x.push_back(corners[static_cast<std::size_t>(v)]);
        covering.excess += length(areaOf(x)) / whole;
        for (std::size_t k = 0; k < 3; ++k)
            covering.least = std::min(covering.least, 2 * dot(areaOf(x), normal) /
                                                          length(x[(k + 1) % 3] - x[k]) /
                                                          length(x[(k + 2) % 3] - x[k]));
    }
    return covering;
}

// Every start, both ways round.
void checkCovered(const Corners& corners) {
    Corners turned = corners;
    for (int way = 0; way < 2; ++way, std::ranges::reverse(turned))
        for (std::size_t start = 0; start < turned.size(); ++start) {
            std::ranges::rotate(turned, turned.begin() + 1);
            const Covering covering = coveringOf(turned);
            CHECK(covering.least > 1e-3);
            CHECK(std::abs(covering.excess) < 1e-12);
        }
}

// Out of its plane, far from the origin.
Corners moved(const Corners& corners) {
    const Vec<double> across{0.48, 0.6, 0.64}, up{-0.8, 0, 0.6};
    Corners there;
    for (const Vec<double>& p : corners)
        there.push_back(Vec<double>{30, -200, 70} + p.x * across + p.y * up);
    return there;
}

}  // namespace

TEST_CASE("polygon: concave ones are covered once, from any corner", "[files][strangers]") {
    const Corners swallowtail{{0, 0, 0}, {3, 0, 0}, {2, 1, 0}, {3, 2, 0}, {0, 2, 0}},
        letterL{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}},
        arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}},
        letterE{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0},
                {2, 3, 0}, {1, 3, 0}, {1, 4, 0}, {3, 4, 0}, {3, 5, 0}, {0, 5, 0}};
    for (const Corners& corners : {swallowtail, letterL, arrow, letterE}) {
        checkCovered(corners);
        checkCovered(moved(corners));
    }
}

TEST_CASE("polygon: corners in a line give no triangle without area", "[files][strangers]") {
    const Corners sides{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0, 1, 0}},
        quad{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 2, 0}};
    Corners square;  // of 20 corners
    for (int i = 0; i < 20; ++i) {
        const double t = i % 5 / 5.0;
        square.push_back(i < 5    ? Vec<double>{t, 0, 0}
                         : i < 10 ? Vec<double>{1, t, 0}
                         : i < 15 ? Vec<double>{1 - t, 1, 0}
                                  : Vec<double>{0, 1 - t, 0});
    }
    for (const Corners& corners : {sides, quad, square}) {
        checkCovered(corners);
        checkCovered(moved(corners));
    }
}

TEST_CASE("polygon: a hole cut open by a slit stays a hole", "[files][strangers]") {
    const Corners frame{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                        {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    checkCovered(frame);
    checkCovered(moved(frame));
}

TEST_CASE("polygon: quads keep their first diagonal if it lies inside", "[files][strangers]") {
    const Triangles first{{0, 1, 2}, {0, 2, 3}}, second{{0, 1, 3}, {1, 2, 3}};
    const auto split = [](const Corners& corners) { return triangles(shapeOf(corners)); };
    CHECK(split({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) == first);
    CHECK(split({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}) == first);
    CHECK(split({{0, 0, 0}, {9, 0, 0}, {9.1, 0.1, 0}, {0, 1, 0}}) == first);
    CHECK(split({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}}) == first);   // a saddle
    CHECK(split({{1, 1, 0}, {0, 3, 0}, {0, 0, 0}, {3, 0, 0}}) == first);   // a notch at 0
    CHECK(split({{3, 0, 0}, {1, 1, 0}, {0, 3, 0}, {0, 0, 0}}) == second);  // and at 1
    CHECK(split({{3, 0, 0.2}, {1, 1, -0.2}, {0, 3, 0.2}, {0, 0, 0}}) == second);
    CHECK(split({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == first);  // a pole
    CHECK(split({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}) == first);  // a line
}

TEST_CASE("polygon: one that crosses itself is refused where it stands", "[files][strangers]") {
    const auto told = [](const Corners& corners) {
        return refusal("a.obj", "# of no use\n" + face(corners) + vertices(corners));
    };
    const std::string crossing = "a.obj:2: a face that crosses itself, seen along its normal";
    CHECK(told({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}) == crossing);
    CHECK(told({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1.8, 1, 0}}) == crossing);
    Corners star;
    for (int i = 0; i < 5; ++i)
        star.push_back(
            {std::cos(0.8 * i * std::numbers::pi), std::sin(0.8 * i * std::numbers::pi), 0});
    CHECK(told(star) == crossing);
    CHECK(told(moved(star)) == crossing);
    CHECK(told({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}}) == "accepted");
    CHECK(told({5, Vec<double>{1, 2, 3}}) == "accepted");
}

TEST_CASE("polygon: in PLY too, where vertices may come last", "[files][strangers]") {
    const auto file = [](const std::string& values) {
        return "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\n"
               "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
               "end_header\n" +
               values;
    };
    CHECK(triangles(test::shapeOf("a.ply", file("4 4 1 2 3\n3 3 0\n1 1 0\n0 3 0\n0 0 0\n3 0 0"))) ==
          Triangles{{1, 3, 4}, {1, 2, 3}});
    CHECK(refusal("a.ply", file("4 3 0 4 2\n3 3 0\n1 1 0\n0 3 0\n0 0 0\n3 0 0")) ==
          "a.ply:10: a face that crosses itself, seen along its normal");
}

TEST_CASE("polygon: ten thousand corners cost no more than their square", "[files][strangers]") {
    Random random(3);
    Corners star, comb;
    for (int i = 0; i < 10000; ++i) {
        const double angle = 2e-4 * std::numbers::pi * i, r = random.uniform(0.3, 1);
        star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    for (int i = 0; i < 2000; ++i) comb.push_back({0.5 * i, i % 2 ? 100.0 : 0.0, 0});
    comb.insert(comb.end(), {{1000, -1, 0}, {0, -1, 0}});
    for (const Corners& corners : {star, comb}) {
        const Covering covering = coveringOf(corners);
        CHECK(report("area over the polygon's", std::abs(covering.excess), 1e-9));
        CHECK(covering.least > 0);
    }
}

TEST_CASE("polygon: a sequence is split as its first mesh is", "[files][strangers][sequence]") {
    const ScratchFolder folder;
    const Corners arrow{{3, 0, 0}, {1, 1, 0}, {0, 3, 0}, {0, 0, 0}};
    Corners square = arrow;
    square[1] = {3, 3, 0};
    write(folder / "a1.obj", vertices(arrow) + face(arrow));
    write(folder / "a2.obj", vertices(square) + face(square));
    const MeshSequence sequence(folder / "a*.obj");
    CHECK(sequence.count() == 2);
    CHECK(triangles(sequence.first()) == triangles(shapeOf(arrow)));
}
