// Shadows, nets, mirror, spotlight and camera of the stage.
#include "render/camera.h"
#include "render/renderer.h"
#include "scenes/parts/views.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace plait;
using test::note;
using test::report;

namespace {

constexpr RenderOptions small{.width = 480, .height = 270};

// What every picture here is seen with, and the light that follows from it.
const Camera camera{.eye = {0, 1.2, 6}, .target = {0, 0.5, 0}, .focalLength = 50};

Vec<double> towardsKey() {
    const double e = 42 * M_PI / 180, a = 50 * M_PI / 180;
    return {-std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

Scene stageOf(const Stage& stage = {}) {
    Scene scene;
    scene.view.cameras = {camera};
    scene.view.groundSize = 2;
    scene.view.glowCenter = {0, 0.5, 0};
    scene.view.stage = stage;
    return scene;
}

// Level, around a point.
Range addSheet(Scene& scene, const Vec<double>& middle, Material material, double side = 0.8) {
    const Range sheet = scene.world.add(
        grid({.columns = 17, .rows = 17, .width = side, .height = side},
             {.origin = middle - Vec<double>{0.5 * side, 0, -0.5 * side}, .up = {0, 0, -1}}));
    scene.view.looks.push_back({.object = sheet, .material = material});
    return sheet;
}

Picture drawn(const Scene& scene) { return Renderer(scene, small).draw(scene.world.rest, 0); }

// The pixel where a point of the world is seen.
std::array<int, 3> pixel(const Picture& picture, const Vec<double>& point) {
    const CameraPose pose = poseAt(std::span(&camera, 1), 0);
    const glm::vec4 seen = pose.matrix(16.0f / 9) * glm::vec4(point.x, point.y, point.z, 1);
    const int x =
        static_cast<int>((0.5f + 0.5f * seen.x / seen.w) * static_cast<float>(small.width));
    const int y =
        static_cast<int>((0.5f - 0.5f * seen.y / seen.w) * static_cast<float>(small.height));
    REQUIRE((x >= 0 && x < small.width && y >= 0 && y < small.height));
    const auto* rgb = &picture.rgb[3 * (y * small.width + x)];
    return {rgb[0], rgb[1], rgb[2]};
}

// Mean of its channels, 0 .. 255.
double brightness(const Picture& picture, const Vec<double>& point) {
    const auto [r, g, b] = pixel(picture, point);
    return (r + g + b) / 3.0;
}

int greatestDifference(const Picture& a, const Picture& b) {
    int greatest = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        greatest = std::max(greatest, std::abs(a.rgb[i] - b.rgb[i]));
    return greatest;
}

}  // namespace

TEST_CASE("ground in the shadow of two things is no brighter than in that of one", "[render]") {
    const Vec<double> key = towardsKey();
    Scene one = stageOf(), two = stageOf();
    for (Scene* scene : {&one, &two}) addSheet(*scene, 0.7 * key, Material::cotton);
    const Range ball = two.world.add({SimplicialComplex(1), {2.2 * key + Vec<double>{0.18, 0, 0}}});
    two.view.looks.push_back({.object = ball, .material = Material::brass, .radius = 0.08});
    const Picture a = drawn(one), b = drawn(two);
    double leak = 0;
    for (double x = 0.07; x <= 0.3; x += 0.01)  // beside what the sheet hides from the sky
        leak = std::max(leak, brightness(b, {x, 0, 0}) - brightness(a, {x, 0, 0}));
    CHECK(report("brighter behind two casters, of 255", leak, 4));
    CHECK(brightness(a, {0, 0, 0}) < 0.7 * brightness(a, {1.5, 0, 0}));
}

TEST_CASE("what flies off leaves the shadows of the rest as sharp as they are", "[render]") {
    Scene alone = stageOf(), with = stageOf();
    for (Scene* scene : {&alone, &with}) addSheet(*scene, {0, 0.6, 0}, Material::cotton);
    const Range ball = with.world.add({SimplicialComplex(1), {{-40, 1, 0}}});
    with.view.looks.push_back({.object = ball, .material = Material::brass, .radius = 0.1});
    CHECK(report("difference, of 255", greatestDifference(drawn(alone), drawn(with)), 0));
}

TEST_CASE("each layer of tulle lets the same part of the light through", "[render]") {
    // Black, so that it adds hardly any of its own, before the backdrop.
    const auto through = [](int layers) {
        Scene scene = stageOf();
        scene.view.ground = false;
        for (int i = 0; i < layers; ++i) {
            const Range sheet =
                scene.world.add(grid({.columns = 9, .rows = 9}, {.origin = {-0.5, 0, 0.1 * i}}));
            scene.view.looks.push_back(
                {.object = sheet, .material = Material::tulle, .color = {0, 0, 0}});
        }
        const double c = brightness(drawn(scene), {0, 0.5, 0}) / 255;
        return std::pow((c + 0.055) / 1.055, 2.4) + 0.04;  // the tone curve takes off .04
    };
    const double none = through(0);
    for (int layers = 1; layers <= 3; ++layers)
        CHECK(report("transmitted, relative to theory",
                     std::abs(through(layers) / none / std::pow(0.7, layers) - 1), 0.2));
}

TEST_CASE("each layer of tulle deepens the shadow below it", "[render]") {
    double before = 256;
    for (int layers = 0; layers <= 3; ++layers) {
        Scene scene = stageOf();
        for (int i = 0; i < layers; ++i)
            addSheet(scene, (0.7 + 0.1 * i) * towardsKey(), Material::tulle);
        const double now = brightness(drawn(scene), {0, 0, 0});
        note("ground under layers of tulle, of 255", now);
        CHECK(now < before - 3);
        before = now;
    }
}

TEST_CASE("the order in which layers of tulle were added is not seen", "[render]") {
    const auto picture = [](bool turned) {
        Scene scene = stageOf();
        for (int i = 0; i < 2; ++i) {
            const bool red = (i == 0) != turned;
            const Range sheet = scene.world.add(
                grid({.columns = 9, .rows = 9}, {.origin = {-0.5, 0.2, red ? 0.1 : -0.1}}));
            scene.view.looks.push_back({.object = sheet,
                                        .material = Material::tulle,
                                        .color = {red ? 0.6 : 0.02, 0.02, red ? 0.02 : 0.6}});
        }
        return drawn(scene);
    };
    // The front one is red; in the shadow map each is told by its number.
    const auto first = pixel(picture(false), {0, 0.7, 0}), last = pixel(picture(true), {0, 0.7, 0});
    CHECK(std::abs(first[0] - last[0]) < 3);
    CHECK(first[0] > first[2]);
}

TEST_CASE("a floor mirrors what stands on it, the less the higher", "[render]") {
    const auto picture = [](double mirror) {
        Scene scene = stageOf({.mirror = mirror, .mirrorFades = 0.3});
        addBar(scene.view, {0, 0, 0}, {0, 1.2, 0}, 0.12, Material::brass);
        return drawn(scene);
    };
    const Picture without = picture(0), with = picture(0.9);
    const auto change = [&](const Vec<double>& p) {
        return std::abs(brightness(with, p) - brightness(without, p));
    };
    // Mirror images of points of the bar.
    const double low = change({0, -0.08, 0.1}), middle = change({0, -0.35, 0.1});
    note("change by the image of 8 cm, of 255", low);
    note("change by the image of 35 cm, of 255", middle);
    CHECK(low > 8);
    CHECK(middle < 0.6 * low);
    CHECK(change({0, -0.6, 0.1}) < 0.15 * low);
    for (const Vec<double>& p :
         {Vec<double>{1, 0, 0}, Vec<double>{0, 0.6, 0.1}, Vec<double>{-1, 1, 0}})
        CHECK(change(p) == 0);
}

TEST_CASE("a spotlight ends", "[render]") {
    const Picture lit = drawn(stageOf()), spot = drawn(stageOf({.spot = 1}));
    const Vec<double> within{0.3, 0, 0}, beyond{1.9, 0, 0.5};
    CHECK(std::abs(brightness(lit, within) - brightness(spot, within)) < 4);
    CHECK(brightness(spot, beyond) < 0.75 * brightness(lit, beyond));
}

TEST_CASE("vertices have colours of their own", "[render]") {
    Scene scene = stageOf();
    const Range sheet =
        scene.world.add(grid({.columns = 9, .rows = 9}, {.origin = {-0.5, 0.2, 0}}));
    Look look{.object = sheet, .material = Material::skin};
    for (const auto& x : scene.world.rest)
        look.colors.push_back(x.x < 0 ? std::array{0.6, 0.5, 0.4} : std::array{0.02, 0.02, 0.02});
    scene.view.looks = {look};
    const Picture picture = drawn(scene);
    CHECK(brightness(picture, {-0.3, 0.7, 0}) > 2 * brightness(picture, {0.3, 0.7, 0}));
    scene.view.looks[0].satin = {1, 2, 3};
    CHECK_THROWS_AS(Renderer(scene, small), std::invalid_argument);
}

TEST_CASE("the camera follows without lag and without a jerk", "[render]") {
    View view;
    view.cameras = {camera};
    view.follow.eye = view.follow.target = {1, 0.5, 1};
    const auto eye = [&](double t) { return poseOf(view, t).eye; };
    CHECK(eye(3) == poseAt(view.cameras, 3).eye);
    view.follow.point = [](double t) { return Vec<double>{0.7 * t, 2 * t, 0}; };
    CHECK(eye(3).x == Approx(2.1));
    CHECK(eye(3).y == Approx(1.2 + 3));
    // A metre in a tenth of a second: by the weights, 15 / 16 / .8 = 1.17 m/s and a little more.
    view.follow.point = [](double t) {
        return Vec<double>{std::clamp(10 * t - 20, 0.0, 1.0), 0, 0};
    };
    CHECK(eye(1.2).x == 0);
    CHECK(eye(2.9).x == Approx(1));
    float fastest = 0;
    for (double t = 1; t < 3; t += 1.0 / 24)
        fastest = std::max(fastest, eye(t + 1.0 / 24).x - eye(t).x);
    CHECK(report("fastest step of the camera, m", fastest, 1.45 / 24));
}
