// What encloses a volume does so however its triangles lie; what does not is refused by its edges.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/gas/enclosure.h>
#include <plait/inspection/facing.h>
#include <plait/inspection/inspect.h>

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

using Triangles = std::vector<std::array<int, 3>>;

Triangles trianglesOf(const SimplicialComplex& complex) {
    Triangles all;
    for (int t = 0; t < complex.count(2); ++t) all.push_back(complex.triangle(t));
    return all;
}

double relative(double value, double expected) { return std::fabs(value / expected - 1); }

// Of an inscribed prism with as many sides.
double prism(int sides, double radius, double height) {
    return 0.5 * sides * std::sin(2 * pi / sides) * radius * radius * height;
}

std::string refusal(std::span<const Vec<double>> positions, const Triangles& triangles,
                    bool cap = false) {
    try {
        enclose(positions, triangles, {.cap = cap, .name = "bag"});
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("gas: a sphere encloses its volume, whichever way its triangles face", "[gas]") {
    const Shape ball = sphere({.subdivisions = 3, .radius = 0.7});
    const Triangles outward = trianglesOf(ball.complex);
    Triangles mixed = outward, inward = outward;
    Random random(1);
    for (auto& t : inward) std::swap(t[0], t[1]);
    for (auto& t : mixed)
        if (random.below(2)) std::swap(t[1], t[2]);
    double six = 0;  // by its own sum, about the origin
    for (const auto& [a, b, c] : outward)
        six += dot(ball.positions[a], cross(ball.positions[b], ball.positions[c]));
    double worst = 0;
    for (const Triangles& given : {outward, inward, mixed}) {
        const Enclosure e = enclose(ball.positions, given);
        REQUIRE(e.skin == given.size());
        REQUIRE(e.triangles.size() == given.size());
        REQUIRE(!openingOf(e.triangles));
        for (std::size_t t = 0; t < given.size(); ++t)
            REQUIRE(std::ranges::is_permutation(e.triangles[t], given[t]));
        worst = std::max(worst, relative(volume(e, ball.positions), six / 6));
    }
    REQUIRE(report("volume of a sphere, as given, inside out, mixed", worst, 1e-14));
    REQUIRE(relative(six / 6, 4 * pi / 3 * 0.343) < 0.02);
}

TEST_CASE("gas: volume loses nothing far from the origin", "[gas]") {
    Shape ball = sphere({.subdivisions = 3, .radius = 0.045});
    const Enclosure e = enclose(ball.positions, trianglesOf(ball.complex));
    const double here = volume(e, ball.positions);
    for (Vec<double>& x : ball.positions) x += Vec<double>{8192, -4096, 1024};
    // Positions themselves are rounded to 1e-12 m: 2e-11 of the radius, less on the mean.
    REQUIRE(
        report("volume 9 km from the origin", relative(volume(e, ball.positions), here), 1e-11));
}

TEST_CASE("gas: several objects are one volume, each turned by itself", "[gas]") {
    World world;
    const Range a = world.add(sphere({.subdivisions = 2, .radius = 1}));
    Shape other = sphere({.subdivisions = 2, .radius = 0.5}, {.origin = {3, 0, 0}});
    for (Vec<double>& x : other.positions) x.z = -x.z;  // a mirror turns it inside out
    const Range b = world.add(other);
    const Range apart = world.add(sphere({.subdivisions = 2, .radius = 9}));
    const double va = volume(enclose(world, {a}), world.rest);
    const double vb = volume(enclose(world, {b}), world.rest);
    REQUIRE(relative(vb, va / 8) < 1e-14);
    const Enclosure both = enclose(world, {a, b});
    REQUIRE(relative(volume(both, world.rest), va + vb) < 1e-14);
    for (const auto& t : both.triangles)
        for (const int v : t) REQUIRE(v < apart.first);
}

TEST_CASE("gas: openings are capped by triangles that are no matter", "[gas]") {
    const Shape pipe = tube({.segments = 13, .rings = 4, .radius = 0.2, .height = 0.9});
    const Triangles given = trianglesOf(pipe.complex);
    const Enclosure e = enclose(pipe.positions, given, {.cap = true});
    REQUIRE(e.skin == given.size());
    REQUIRE(e.caps().size() == 2 * (13 - 2));
    REQUIRE(!openingOf(e.triangles));
    REQUIRE(report("volume of a capped tube",
                   relative(volume(e, pipe.positions), prism(13, 0.2, 0.9)), 1e-14));
    Triangles inward = given;
    for (auto& t : inward) std::swap(t[0], t[1]);
    REQUIRE(volume(enclose(pipe.positions, inward, {.cap = true}), pipe.positions) > 0);
    // A closed mesh has nothing to cap.
    const Shape ball = sphere({.subdivisions = 1, .radius = 1});
    REQUIRE(enclose(ball.positions, trianglesOf(ball.complex), {.cap = true}).caps().empty());
}

TEST_CASE("gas: openings that meet in a vertex are capped", "[gas]") {
    const Shape ball = sphere({.subdivisions = 2, .radius = 1});
    Triangles given = trianglesOf(ball.complex);
    // Two triangles that share vertex 0 alone.
    const auto hasFirst = [](const auto& t) { return std::ranges::count(t, 0) > 0; };
    const auto one = *std::ranges::find_if(given, hasFirst);
    const auto other = *std::ranges::find_if(given, [&](const auto& t) {
        return hasFirst(t) &&
               std::ranges::count_if(t, [&](int v) { return std::ranges::count(one, v) > 0; }) == 1;
    });
    const double whole = volume(enclose(ball.positions, given), ball.positions);
    std::erase(given, one);
    std::erase(given, other);
    const Enclosure e = enclose(ball.positions, given, {.cap = true});
    REQUIRE(!openingOf(e.triangles));
    REQUIRE(report("volume with two holes at one vertex",
                   relative(volume(e, ball.positions), whole), 1e-14));
}

TEST_CASE("gas: what is flat faces as most of it does", "[gas]") {
    // Two discs on one ring, as a Mylar balloon is cut: the lower one faces down.
    const Shape top = disc({.rings = 4, .radius = 0.3});
    const int ring = 1 + 3 * 4 * 3, inner = ring;  // vertices up to the last ring
    Triangles given = trianglesOf(top.complex);
    std::vector<Vec<double>> positions = top.positions;
    positions.insert(positions.end(), top.positions.begin(), top.positions.begin() + inner);
    const int shift = static_cast<int>(top.positions.size());
    for (auto [a, b, c] : trianglesOf(top.complex)) {
        const auto lower = [&](int v) { return v < inner ? v + shift : v; };
        given.push_back({lower(a), lower(c), lower(b)});
    }
    Triangles mixed = given;
    for (std::size_t t = 0; t < mixed.size(); t += 3) std::swap(mixed[t][1], mixed[t][2]);
    std::vector<Vec<double>> puffed = positions;
    for (int v = 0; v < inner; ++v) {
        puffed[v].z += 0.1;
        puffed[v + shift].z -= 0.1;
    }
    for (const Triangles& triangles : {given, mixed}) {
        const Enclosure e = enclose(positions, triangles);
        REQUIRE(std::fabs(volume(e, positions)) < 1e-15);
        REQUIRE(volume(e, puffed) > 0.02);
    }
}

TEST_CASE("gas: what is not closed is refused by its edges", "[gas]") {
    const Shape ball = sphere({.subdivisions = 2, .radius = 1});
    Triangles given = trianglesOf(ball.complex);
    const auto gone = given.back();
    given.pop_back();
    const std::string text = refusal(ball.positions, given);
    REQUIRE(contains(text, "bag: not closed along 3 edges: "));
    REQUIRE(contains(text, "cap them"));
    REQUIRE(!contains(text, "\n"));
    for (int j = 0; j < 3; ++j)  // as they run in the neighbours
        REQUIRE(contains(text, std::to_string(gone[(j + 1) % 3]) + "-" + std::to_string(gone[j])));
    const Shape pipe = tube({.segments = 13, .rings = 4});
    const std::string many = refusal(pipe.positions, trianglesOf(pipe.complex));
    REQUIRE(contains(many, "26 edges: "));
    REQUIRE(contains(many, ", ...;"));
    REQUIRE(contains(refusal(pipe.positions, {}), "no triangles"));
    REQUIRE(contains(refusal(pipe.positions, {{0, 1, 52}}), "no vertex 52"));
}

TEST_CASE("gas: doubled vertices are refused by name, and welded enclose", "[gas]") {
    // The seam of an export: the first segment's vertices stand there twice.
    const Shape ball = sphere({.subdivisions = 2, .radius = 1});
    std::vector<Vec<double>> positions;
    Triangles soup;
    for (const auto& triangle : trianglesOf(ball.complex)) {
        const int v = static_cast<int>(positions.size());
        soup.push_back({v, v + 1, v + 2});
        for (const int corner : triangle) positions.push_back(ball.positions[corner]);
    }
    const std::string text = refusal(positions, soup);
    REQUIRE(contains(text, "not closed along 960 edges: 0-1"));
    REQUIRE(contains(text, "798 vertices lie where others do"));
    REQUIRE(contains(text, "weld them by inspect()"));
    const Shape mended =
        inspect({SimplicialComplex(static_cast<int>(positions.size()), {{}, soup, {}}), positions},
                "soup.obj")
            .shape;
    const Enclosure e = enclose(mended.positions, trianglesOf(mended.complex));
    REQUIRE(relative(volume(e, mended.positions),
                     volume(enclose(ball.positions, trianglesOf(ball.complex)), ball.positions)) <
            1e-14);
}

TEST_CASE("gas: one side only, and three triangles at an edge, are refused", "[gas]") {
    // Moebius' band of nine triangles, capped or not.
    std::vector<Vec<double>> positions;
    Triangles band;
    const int n = 9;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * pi * i / n;
        positions.push_back({std::cos(angle), std::sin(angle), 0.1 * i});
        band.push_back({i, (i + 1) % n, (i + 2) % n});
    }
    REQUIRE(contains(refusal(positions, band, true), "cannot all face outward: "));
    const Shape ball = sphere({.subdivisions = 1, .radius = 1});
    Triangles fin = trianglesOf(ball.complex);
    const auto first = fin.front();
    std::vector<Vec<double>> more = ball.positions;
    more.push_back({5, 0, 0});
    fin.push_back({first[0], first[1], static_cast<int>(ball.positions.size())});
    REQUIRE(contains(refusal(more, fin, true), "the triangles at 1 edge cannot all face outward"));
}
