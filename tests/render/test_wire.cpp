// Wires: the curve, its frame, the mesh around it, how wide and how dark it is drawn.
#include "render/matter/wire_skin.h"
#include "render/renderer.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

constexpr float halfTurn = glm::pi<float>();

std::vector<glm::vec3> ring(int n, float radius = 1) {
    std::vector<glm::vec3> points;
    for (int i = 0; i < n; ++i) {
        const float a = 2 * halfTurn * static_cast<float>(i) / static_cast<float>(n);
        points.push_back({radius * std::cos(a), 0, -radius * std::sin(a)});
    }
    return points;
}

std::vector<glm::vec3> line(int links, float length) {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= links; ++i)
        points.push_back({length * static_cast<float>(i) / static_cast<float>(links), 0, 0});
    return points;
}

// A right-handed coil up y.
std::vector<glm::vec3> coil(int turns, int links, float radius, float pitch) {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= turns * links; ++i) {
        const float s = static_cast<float>(i) / static_cast<float>(links), a = 2 * halfTurn * s;
        points.push_back({radius * std::cos(a), pitch * s, -radius * std::sin(a)});
    }
    return points;
}

struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::array<int, 3>> triangles;

    double area() const {
        double sum = 0;
        for (const auto& [a, b, c] : triangles) sum += 0.5 * glm::length(normal(a, b, c));
        return sum;
    }
    // By Gauss: negative where triangles face inwards, and wrong where a face is missing.
    double volume() const {
        double sum = 0;
        for (const auto& [a, b, c] : triangles)
            sum += glm::dot(normal(a, b, c), vertices[a].position) / 6.0;
        return sum;
    }
    glm::vec3 normal(int a, int b, int c) const {
        return glm::cross(vertices[b].position - vertices[a].position,
                          vertices[c].position - vertices[a].position);
    }
};

Mesh swept(const std::vector<WirePoint>& path, const Section& section, bool closed) {
    const auto outline = outlineOf(section, 100);
    Mesh mesh;
    appendWireVertices(path, std::vector<WireLook>(path.size()), outline, closed, mesh.vertices);
    appendWireTriangles(0, static_cast<int>(path.size()), static_cast<int>(outline.size()), closed,
                        mesh.triangles);
    return mesh;
}

Polyline through(const std::vector<glm::vec3>& points) {
    Polyline curve;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) curve.vertices.push_back(i);
    return curve;
}

// A camera at z = `away` that looks at the origin.
Lens from(float away, float pixel) { return {{0, 0, away}, {0, 0, -1}, pixel}; }

Mesh drawn(const std::vector<glm::vec3>& points, const Section& section, const Lens& lens) {
    WireSkin skin({.object = {}, .section = section}, {through(points)}, points, 1e-4f);
    Mesh mesh;
    skin.update(points, {}, std::vector<glm::vec3>(points.size()), lens, mesh.vertices);
    mesh.triangles = skin.triangles();
    return mesh;
}

}  // namespace

TEST_CASE("a wire's path follows a circle to fourth order", "[render][wire]") {
    for (const int n : {12, 24}) {
        const double turn = 2.0 * halfTurn / n;
        float worst = 0, aslant = 0;
        for (const WirePoint& p : wirePath(ring(n), {}, true, 4)) {
            worst = std::max(worst, std::abs(glm::length(p.place) - 1));
            aslant = std::max(aslant, std::abs(glm::dot(p.tangent, p.place)));
        }
        // Halfway: cos(t/2) + sin(t) sin(t/2) / 4 - 1, of links that turn by t.
        const double theory = 1 - std::cos(turn / 2) - std::sin(turn) * std::sin(turn / 2) / 4;
        CHECK(worst == Approx(theory).epsilon(0.01));
        CHECK(report("tangent across a circle", aslant, std::pow(turn, 3) / 14));
    }
    // Links of 1:5 on a line: no point goes back.
    const std::vector<glm::vec3> uneven{{0, 0, 0}, {1, 0, 0}, {1.2f, 0, 0}, {2.2f, 0, 0}};
    const auto path = wirePath(uneven, {}, false, 4);
    for (std::size_t i = 1; i < path.size(); ++i) CHECK(path[i].place.x > path[i - 1].place.x);
}

TEST_CASE("a wire's frame turns as its directors do", "[render][wire]") {
    // 100 degrees a link, for four turns and more: at the ends too, where no director is.
    const int links = 16;
    const float rate = 100 * halfTurn / 180;
    const auto points = line(links, 2);
    std::vector<glm::vec3> arms;
    for (int e = 0; e < links; ++e) {
        const float a = rate * static_cast<float>(e);
        arms.push_back(0.01f * glm::vec3(3, std::cos(a), std::sin(a)));  // along the edge: nothing
    }
    float worst = 0;
    for (const WirePoint& p : wirePath(points, arms, false, 8)) {
        const float a = rate * (p.link - 0.5f);
        worst = std::max(worst, glm::length(p.director - glm::vec3(0, std::cos(a), std::sin(a))));
        CHECK(std::abs(glm::dot(p.director, p.tangent)) < 1e-6f);
    }
    CHECK(report("frame off the directors, rad", worst, 1e-5));

    // Around a ring, with so many turns on the way; the seam is a place like any other.
    for (const int turns : {0, 3, -2}) {
        const int n = 24;
        const auto circle = ring(n);
        arms.clear();
        const auto wanted = [&](float link) {
            const float at = 2 * halfTurn * link / n, a = static_cast<float>(turns) * at;
            return std::cos(a) * glm::vec3(std::cos(at), 0, -std::sin(at)) +
                   std::sin(a) * glm::vec3(0, -1, 0);
        };
        for (int e = 0; e < n; ++e) arms.push_back(wanted(static_cast<float>(e) + 0.5f));
        worst = 0;
        for (const WirePoint& p : wirePath(circle, arms, true, 4))
            worst = std::max(worst, glm::length(p.director - wanted(p.link)));
        CHECK(report("frame of a ring off its directors, rad", worst, 1e-3));
    }
}

TEST_CASE("without directors a wire's frame does not twist, and closes", "[render][wire]") {
    // A curve that does not lie in a plane: carried once around, a frame comes back turned.
    std::vector<glm::vec3> knot;
    const int n = 60;
    for (int i = 0; i < n; ++i) {
        const float a = 2 * halfTurn * static_cast<float>(i) / n;
        knot.push_back({std::sin(a) + 2 * std::sin(2 * a), std::cos(a) - 2 * std::cos(2 * a),
                        -std::sin(3 * a)});
    }
    const auto twist = [](const WirePoint& a, const WirePoint& b) {
        const glm::vec3 axis = glm::normalize(a.tangent + b.tangent);
        const glm::vec3 p = a.director - axis * glm::dot(a.director, axis),
                        q = b.director - axis * glm::dot(b.director, axis);
        return std::atan2(glm::dot(glm::cross(p, q), axis), glm::dot(p, q));
    };
    const auto path = wirePath(knot, {}, true, 4);
    double least = 1, most = -1, sum = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double t = twist(path[i], path[(i + 1) % path.size()]);
        least = std::min(least, t);
        most = std::max(most, t);
        sum += t;
    }
    CHECK(report("greatest less least twist a step, rad", most - least, 2e-3));
    CHECK(std::abs(sum) < halfTurn + 1e-3);
    const auto open = wirePath(std::span(knot).first(40), {}, false, 4);
    for (std::size_t i = 1; i < open.size(); ++i)
        CHECK(std::abs(twist(open[i - 1], open[i])) < 1e-3);
}

TEST_CASE("a wire's mesh is closed, and as large as its section says", "[render][wire]") {
    const double a = 0.03, b = 0.01, length = 0.7;
    const auto path = wirePath(line(7, 0.7f), {}, false, 2);
    const Mesh sharp = swept(path, {.along = a, .across = b, .bevel = 0}, false);
    CHECK(sharp.area() == Approx(2 * (a + b) * length + 2 * a * b).epsilon(1e-5));
    CHECK(sharp.volume() == Approx(a * b * length).epsilon(1e-5));
    // Round edges: two half circles of b and two flats. Inscribed, they are a little smaller.
    const Mesh round = swept(path, {.along = a, .across = b, .bevel = 1}, false);
    const double outline = 2 * (a - b) + halfTurn * b, inside = (a - b) * b + halfTurn * b * b / 4;
    CHECK(round.area() == Approx(outline * length + 2 * inside).epsilon(0.01));
    CHECK(round.volume() == Approx(inside * length).epsilon(0.02));
    CHECK(round.volume() < inside * length);

    const Mesh torus = swept(wirePath(ring(24), {}, true, 4), {.along = 0.1}, true);
    CHECK(torus.area() == Approx(4 * halfTurn * halfTurn * 0.05).epsilon(0.005));
    CHECK(torus.volume() == Approx(2 * halfTurn * halfTurn * 0.05 * 0.05).epsilon(0.01));
    float off = 0;
    for (const MeshVertex& v : torus.vertices) {
        const glm::vec3 in(v.position.x, 0, v.position.z), out = v.position - glm::normalize(in);
        off = std::max(off, glm::length(v.normal - glm::normalize(out)));
    }
    CHECK(report("normals of a torus", off, 0.005));
}

// Whatever its distance a wire takes as much light away as it is wide.
TEST_CASE("what a thin wire covers times how wide it is drawn is its width", "[render][wire]") {
    const Section round{.along = 2e-3}, flat{.along = 2.5e-3, .across = 0.6e-3, .bevel = 0};
    for (const float pixels : {0.02f, 0.3f, 1.0f, 1.4f, 2.0f, 9.0f})
        for (const Section& section : {round, flat}) {
            const float pixel = 2e-3f / pixels;
            const Mesh wire = drawn(line(8, 0.4f), section, from(1, pixel));
            double low = 1, high = -1;
            for (const MeshVertex& v : wire.vertices) {
                low = std::min<double>(low, v.position.y);
                high = std::max<double>(high, v.position.y);
            }
            const double width = high - low, cover = wire.vertices[0].satin;
            CHECK(width > 1.49 * pixel);
            // Any side of the flat one may face the camera: there is no director.
            const double own = section.across > 0 ? 2.5e-3 : 2e-3;
            if (section.across == 0 || width < 1.51 * pixel)
                CHECK(width * cover == Approx(section.across > 0 && cover == 1 ? width : own)
                                           .epsilon(section.across > 0 ? 0.01 : 0.07));
            CHECK(cover <= 1);
        }
}

TEST_CASE("a stack of wires covers all, however far away it is", "[render][wire]") {
    for (const float pixels : {0.1f, 0.4f, 0.9f}) {
        const auto points = coil(20, 24, 0.03f, 1e-3f);
        const Mesh stack = drawn(points, {.along = 1e-3}, from(1, 1e-3f / pixels));
        // A station of the middle turns, in front: drawn wide, they lie `1.5 / pixels` deep.
        float least = 1;
        for (const MeshVertex& v : stack.vertices)
            if (v.position.z > 0.02f && v.position.y > 5e-3f && v.position.y < 15e-3f)
                least = std::min(least, v.satin);
        CHECK(report("light through a stack", std::pow(1 - least, 1.5 / pixels), 0.01));
        // Apart by ten widths they are seen through.
        const Mesh loose =
            drawn(coil(20, 24, 0.03f, 1e-2f), {.along = 1e-3}, from(1, 1e-3f / pixels));
        CHECK(loose.vertices[0].satin == Approx(pixels / 1.5).epsilon(0.1));
    }
}

TEST_CASE("turns beside a point of a wire are found, and the wire itself is not",
          "[render][wire]") {
    const auto stations = [](const std::vector<glm::vec3>& points, float round = 0) {
        std::vector<WireStation> result;
        const auto path = wirePath(points, {}, round > 0, 2);
        float length = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) length += glm::length(points[i] - points[i - 1]);
            result.push_back(
                {points[i], path[2 * i].tangent, path[2 * i].director, length, round, 0});
        }
        return result;
    };
    for (const Beside& beside : besides(stations(line(50, 1)), 0.1f))
        CHECK((beside[0] == glm::vec3(0) && beside[1] == glm::vec3(0)));
    for (const Beside& beside : besides(stations(ring(50), 2 * halfTurn), 0.3f))
        CHECK((beside[0] == glm::vec3(0) && beside[1] == glm::vec3(0)));
    const auto found = besides(stations(coil(6, 48, 1, 0.05f)), 0.2f);
    float side = found[100][0].y > 0 ? 1.0f : -1.0f;
    for (int i = 60; i < 5 * 48 - 12; ++i) {
        CHECK(found[static_cast<std::size_t>(i)][0].y == Approx(side * 0.05f).epsilon(0.01));
        CHECK(found[static_cast<std::size_t>(i)][1].y == Approx(-side * 0.05f).epsilon(0.01));
    }
    CHECK(found[10][0].y * found[10][1].y == 0);  // the lowest turn has one above it alone
}

TEST_CASE("a stack is dark inside as a tube is", "[render][wire]") {
    const float radius = 0.033f, pitch = 0.62e-3f;
    const int turns = 86;
    const auto points = coil(turns, 24, radius, pitch);
    std::vector<WireStation> stations;
    for (std::size_t i = 0; i < points.size(); ++i)
        stations.push_back({points[i],
                            {0, 0, -1},
                            {1, 0, 0},  // of those that are looked at
                            static_cast<float>(i) * 2 * halfTurn * radius / 24,
                            0,
                            0});
    const auto open = opennessOf(stations, 1.56e-3f);
    const auto& middle = open[static_cast<std::size_t>(turns / 2 * 24)];
    // Of an element of a tube's wall both mouths are seen under (z^2 + 1/2) / sqrt(z^2 + 1) - z
    // each, z being its distance by the diameter.
    const double z = 0.5 * turns * pitch / (2 * radius),
                 // smoke blurs their rims
        mouths = 2 * ((z * z + 0.5) / std::sqrt(z * z + 1) - z);
    CHECK(report("light inside off a tube's", std::abs(middle.at(-1, 0) - mouths), 0.16));
    CHECK(report("light that is lost outside", 1 - middle.at(1, 0), 0.05));
    CHECK(opennessOf(std::span(stations).first(6), 1.56e-3f)[0].at(0.6f, 0.8f) > 0.95f);
}

TEST_CASE("a wire that cannot be drawn is refused", "[render][wire]") {
    const auto points = line(4, 1);
    const auto make = [&](const Look& look) { WireSkin(look, {through(points)}, points, 1e-3f); };
    CHECK_NOTHROW(make({.object = {}, .section = {.along = 1e-3}, .directors = {5, 9}}));
    CHECK_THROWS_AS(make({.object = {}, .section = {.along = 1e-3}, .directors = {5, 8}}),
                    std::invalid_argument);
    CHECK_THROWS_AS(make({.object = {}, .section = {.along = 1e-3, .across = -1}}),
                    std::invalid_argument);
    CHECK_THROWS_AS(make({.object = {}, .section = {.along = 1e-3, .bevel = 2}}),
                    std::invalid_argument);
}

TEST_CASE("an exposure is the mean light of its moments", "[render][wire]") {
    // A ball before the backdrop, here and there; none of its colours is so dark or bright that the
    // tone curve is bent.
    Scene scene;
    const Range point = scene.world.add({SimplicialComplex(1), {{-0.5, 0, 0}}});
    scene.view.looks = {
        {.object = point, .material = Material::matte, .color = {0.2, 0.2, 0.2}, .radius = 0.3}};
    scene.view.cameras = {{.eye = {0, 0, 5}, .focalLength = 60}};
    scene.view.ground = false;
    Renderer renderer(scene, {.width = 160, .height = 90});
    const std::vector<Vec<double>> here{{-0.5, 0, 0}}, there{{0.5, 0, 0}};
    const Picture a = renderer.draw(here, 0), b = renderer.draw(there, 0);
    CHECK((renderer.draw(std::vector<Moment>{{here, 0}}) == a));
    const std::vector<Moment> both{{here, 0}, {there, 0}};
    const Picture mean = renderer.draw(both);
    CHECK((renderer.draw(both) == mean));
    CHECK((renderer.draw(here, 0) == a));
    const auto light = [](const Picture& p, int x) {
        const double c = p.rgb[static_cast<std::size_t>(3 * (45 * p.width + x))] / 255.0;
        return std::pow((c + 0.055) / 1.055, 2.4);
    };
    // The middles of both, where a part of a pixel aside changes little.
    for (const int x : {58, 80, 102})
        CHECK(light(mean, x) == Approx((light(a, x) + light(b, x)) / 2).margin(0.008));
    CHECK(std::abs(light(a, 58) - light(b, 58)) > 0.03);
}
