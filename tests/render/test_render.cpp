#include "render/camera.h"
#include "render/gl/context.h"
#include "render/matter/polyline.h"
#include "render/matter/subdivision.h"
#include "render/overlay.h"
#include "render/renderer.h"
#include "render/stage/emblem.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <cmath>

using namespace plait;
using test::report;

namespace {

// A small printed cloth that waves, a wire, a ball, a post.
Scene smallScene() {
    Scene scene;
    const Range cloth = scene.world.add(grid({.columns = 25, .rows = 17, .width = 1.6}));
    const Range wire =
        scene.world.add(chain({.links = 6, .from = {-0.4, 0.1, 0}, .to = {-0.1, 0.9, 0}}));
    const Range point = scene.world.add({SimplicialComplex(1), {{1.9, 0.2, 0}}});
    Look flag{.object = cloth, .print = "plait"};
    for (int i = 0; i < cloth.size(); ++i)
        flag.uv.push_back({scene.world.rest[i].x / 1.6, scene.world.rest[i].y});
    scene.view.looks = {flag,
                        {.object = wire, .material = Material::wire, .radius = 0.01},
                        {.object = point, .material = Material::rubber, .radius = 0.1}};
    scene.view.props.push_back(
        {tube({.radius = 0.03, .height = 1.2}, {.origin = {-0.05, 0, 0}}), Material::steel});
    scene.view.cameras = {{.eye = {0.7, 0.7, 4.5}, .target = {0.7, 0.5, 0}, .focalLength = 60}};
    return scene;
}

std::vector<Vec<double>> waved(const Scene& scene, double phase) {
    auto x = scene.world.rest;
    for (auto& p : x) p.z = 0.12 * std::sin(5 * p.x - phase) * p.x;
    return x;
}

double fractionThatDiffers(const Picture& a, const Picture& b, int beyond) {
    REQUIRE(a.rgb.size() == b.rgb.size());
    int count = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        bool differs = false;
        for (std::size_t k = i; k < i + 3; ++k) differs |= std::abs(a.rgb[k] - b.rgb[k]) > beyond;
        count += differs;
    }
    return 3.0 * count / static_cast<double>(a.rgb.size());
}

double linear(int byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

constexpr RenderOptions small{.width = 320, .height = 180};

}  // namespace

TEST_CASE("an offscreen context comes up and says what it is", "[render]") {
    const Context context;
    CHECK((context.library() == "osmesa" || context.library() == "egl"));
    CHECK(context.renderer().find("OpenGL") != std::string::npos);
    CHECK(glChoice("egl") == GlChoice::egl);
    CHECK_THROWS_AS(glChoice("vulkan"), std::invalid_argument);
}

TEST_CASE("the same state gives the same bits, whatever was drawn before",
          "[render][determinism]") {
    const Scene scene = smallScene();
    Renderer first(scene, small);
    const Picture a = first.draw(waved(scene, 1), 0);
    const Picture other = first.draw(waved(scene, 2), 0);
    CHECK(fractionThatDiffers(a, other, 3) > 0.01);
    CHECK((first.draw(waved(scene, 1), 0) == a));
    Renderer second(scene, small);
    CHECK((second.draw(waved(scene, 1), 0) == a));
}

TEST_CASE("drawing shows what it is given", "[render]") {
    const Scene scene = smallScene();
    Renderer renderer(scene, small);
    const auto x = waved(scene, 1);
    const Picture picture = renderer.draw(x, 0);
    CHECK(picture.width == 320);
    CHECK(picture.rgb.size() == 3u * 320 * 180);
    // Top row first: dusk above, haze below.
    CHECK(picture.rgb[0] < 60);
    CHECK(picture.rgb[3 * 320 * 170] > 100);

    auto moved = x;
    for (auto& p : moved) p.x += 4.5 * 0.6 / 320;  // a pixel
    CHECK(fractionThatDiffers(picture, renderer.draw(moved, 0), 3) > 0.005);
    Scene blue = scene;
    blue.view.looks[0].color = {0.02, 0.1, 0.5};
    CHECK(fractionThatDiffers(picture, Renderer(blue, small).draw(x, 0), 3) > 0.05);
    const Overlay low{.values = std::vector<float>(x.size(), 0)};
    const Overlay high{.values = std::vector<float>(x.size(), 1)};
    CHECK(fractionThatDiffers(renderer.draw(x, 0, &high), renderer.draw(x, 0, &low), 3) > 0.05);
    CHECK((renderer.draw(x, 0) == picture));
}

TEST_CASE("a renderer refuses what it cannot draw", "[render]") {
    Scene scene = smallScene();
    CHECK_THROWS_AS(Renderer(scene, {.width = 8}), std::invalid_argument);
    Renderer renderer(scene, small);
    CHECK_THROWS_AS(renderer.draw(std::vector<Vec<double>>(3), 0), std::invalid_argument);
    const Overlay overlay{.values = {1, 2}};
    CHECK_THROWS_AS(renderer.draw(scene.world.rest, 0, &overlay), std::invalid_argument);
    scene.view.looks[0].uv.pop_back();
    CHECK_THROWS_AS(Renderer(scene, small), std::invalid_argument);
    scene.view.cameras.clear();
    CHECK_THROWS_AS(Renderer(scene, small), std::invalid_argument);
}

TEST_CASE("lit cloth has the look book's colours", "[render]") {
    // Upright and towards the camera, as most of a flag is.
    const auto color = [](const std::array<double, 3>& albedo) {
        Scene scene;
        const Range sheet =
            scene.world.add(grid({.columns = 9, .rows = 9}, {.origin = {-0.5, -0.5, 0}}));
        scene.view.looks = {{.object = sheet, .material = Material::silk, .color = albedo}};
        scene.view.cameras = {{.eye = {0, 0, 6}, .focalLength = 68}};
        scene.view.ground = false;
        const Picture p = Renderer(scene, small).draw(scene.world.rest, 0);
        const auto* center = &p.rgb[3 * (320 * 90 + 160)];
        return std::array{linear(center[0]), linear(center[1]), linear(center[2])};
    };
    const auto distance = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
        return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
    };
    CHECK(report("lit ivory, linear", distance(color({0.88, 0.791, 0.658}), {0.83, 0.66, 0.48}),
                 0.1));
    CHECK(report("lit vermilion, linear", distance(color({0.578, 0.032, 0.014}), {0.47, 0.02, 0.0}),
                 0.1));
}

TEST_CASE("a fine mesh, lit by vertex, looks like a coarse one, lit by pixel", "[render]") {
    // A tilted sheet, of whose two sides the camera sees one.
    const auto sheet = [](int cells, bool back) {
        Scene scene;
        const Range cloth = scene.world.add(grid(
            {.columns = cells + 1, .rows = cells + 1, .width = 1.6}, {.origin = {-0.8, 0, 0}}));
        for (auto& x : scene.world.rest) x.z = 0.7 * x.x;
        Look look{.object = cloth, .print = "plait"};
        for (const auto& x : scene.world.rest) look.uv.push_back({x.x / 1.6 + 0.5, x.y});
        scene.view.looks = {look};
        scene.view.cameras = {{.eye = {0.4, 0.7, back ? -4.5 : 4.5}, .target = {0, 0.5, 0}}};
        return Renderer(scene, small).draw(scene.world.rest, 0);
    };
    for (const bool back : {false, true})
        CHECK(report("pixels that differ", fractionThatDiffers(sheet(3, back), sheet(48, back), 6),
                     0.003));
}

TEST_CASE("subdivision keeps planes and corners, and rounds spheres", "[render]") {
    const auto shape = grid({.columns = 5, .rows = 4});
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < shape.complex.count(2); ++i) triangles.push_back(shape.complex.triangle(i));
    const Subdivision fine(triangles, shape.positions);
    CHECK(fine.triangles().size() == 4 * triangles.size());
    CHECK(fine.size() == shape.complex.count(0) + shape.complex.count(1));
    std::vector<glm::vec3> coarse, x;
    for (const auto& p : shape.positions) coarse.emplace_back(p.x, p.y, 2 * p.x - p.y);
    fine.apply<glm::vec3>(coarse, x);
    float error = 0;
    for (const auto& p : x) error = std::max(error, std::abs(p.z - 2 * p.x + p.y));
    CHECK(report("subdivided plane", error, 1e-6));
    CHECK(x[0] == coarse[0]);
    CHECK(x[19] == coarse[19]);

    const auto ball = sphere({.subdivisions = 3});
    triangles.clear();
    for (int i = 0; i < ball.complex.count(2); ++i) triangles.push_back(ball.complex.triangle(i));
    coarse.clear();
    for (const auto& p : ball.positions) coarse.emplace_back(p.x, p.y, p.z);
    Subdivision(triangles, ball.positions).apply<glm::vec3>(coarse, x);
    float low = 2, high = 0;
    for (const auto& p : x) {
        low = std::min(low, glm::length(p));
        high = std::max(high, glm::length(p));
    }
    CHECK(report("roundness of a subdivided sphere", high - low, 2e-3));
}

TEST_CASE("the camera's path is smooth and meets its poses", "[render]") {
    const std::vector<Camera> path{{.time = 1, .eye = {0, 0, 5}, .focalLength = 50},
                                   {.time = 2, .eye = {1, 0, 5}, .focalLength = 60},
                                   {.time = 4, .eye = {2, 1, 5}, .focalLength = 60}};
    const auto at = [&](double t) { return poseAt(path, t).eye; };
    for (const Camera& c : path) CHECK(at(c.time).x == Approx(c.eye.x));
    CHECK(at(0) == at(1));
    CHECK(at(9) == at(4));
    CHECK(at(1.001).x < 1e-5f);  // it starts from rest
    CHECK((at(2.01).x - at(2).x) == Approx(at(2).x - at(1.99).x).epsilon(0.05));
    CHECK(poseAt(std::span(path).first(2), 1.5).eye.x == Approx(0.5));
    CHECK(poseAt(path, 1).fieldOfView == Approx(2 * std::atan(10.125 / 50)));
    CHECK_THROWS_AS(poseAt({}, 0), std::invalid_argument);
}

TEST_CASE("edges are strung into curves", "[render]") {
    // A fork of three branches, and a ring.
    const std::vector<std::array<int, 2>> edges{{0, 1}, {1, 2}, {1, 3}, {3, 4},
                                                {5, 6}, {6, 7}, {7, 5}};
    const auto lines = polylines(edges, 8);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0].vertices == std::vector{0, 1});
    CHECK(lines[2].vertices == std::vector{1, 3, 4});
    CHECK(lines[3].closed);
    CHECK(lines[3].vertices.size() == 3);

    std::vector<MeshVertex> vertices;
    std::vector<std::array<int, 3>> triangles;
    const std::vector<glm::vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, tints(3);
    appendTube(line, tints, false, 0.1f, vertices, triangles);
    for (const MeshVertex& v : vertices) {
        const float beyond = std::max({-v.position.x, v.position.x - 2, 0.0f});
        CHECK(std::hypot(v.position.y, v.position.z, beyond) == Approx(0.1f));
    }
}

TEST_CASE("the emblem is a plait", "[render]") {
    const Emblem emblem = makeEmblem(1.6f);
    CHECK(emblem.period == Approx(0.8f));
    const auto inside = [&](int x, int y, int k) {
        return emblem.texels[2 * (static_cast<std::size_t>(y) * 256 + x % 256) + k] < 32768;
    };
    int ivory = 0, brass = 0, both = 0, shifted = 0;
    for (int y = 0; y < emblem.height; ++y)
        for (int x = 0; x < emblem.width; ++x) {
            ivory += inside(x, y, 0);
            brass += inside(x, y, 1);
            both += inside(x, y, 0) && inside(x, y, 1);
            // Mirrored at its middle line it is itself, half a period later.
            for (int k = 0; k < 2; ++k)
                shifted += inside(x, y, k) != inside(x + 128, emblem.height - 1 - y, k);
        }
    CHECK(both == 0);
    CHECK(ivory == Approx(2 * brass).epsilon(0.01));
    CHECK(shifted < 200);
}

TEST_CASE("an overlay's colours run from end to end", "[render]") {
    const Overlay strain{.values = {}, .low = 0, .high = 0.04f};
    const auto colors = paletteColors(Palette::heat);
    CHECK(overlayColor(strain, -1) == colors.front());
    CHECK(overlayColor(strain, 0.02f) == colors[2]);
    CHECK(overlayColor(strain, 1) == colors.back());
    const Overlay batches{.values = {}, .palette = Palette::categories};
    CHECK(overlayColor(batches, 7) == overlayColor(batches, 1));
}
