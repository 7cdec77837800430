// Rubber that is blown up: how it stretches, and what light it lets through.
#include "render/matter/area_stretch.h"
#include "render/renderer.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

using namespace plait;
using test::note;
using test::report;

namespace {

constexpr RenderOptions small{.width = 320, .height = 180};
constexpr double radius = 0.05;  // m, at rest

// A balloon that fills half of the picture's height, however far it is blown up.
Scene balloon(const Look& look, double stretch) {
    Scene scene;
    const Range object = scene.world.add(sphere({.subdivisions = 4, .radius = radius}));
    scene.view.looks = {look};
    scene.view.looks[0].object = object;
    scene.view.looks[0].material = Material::latex;
    const double away = 4 * radius * stretch * 50 / 20.25;
    scene.view.cameras = {{.eye = {0, 0, away}, .target = {0, 0, 0}, .focalLength = 50}};
    scene.view.ground = false;
    scene.view.stage.vignette = 0;
    return scene;
}

// The light of the rim, behind it and above, alone: the key light's pool is elsewhere.
void lightFromBehind(Scene& scene) {
    scene.view.glow = 0;
    scene.view.glowCenter = {100, 0, -100};
    scene.view.stage.dim = 1;
    scene.view.stage.spot = 0.1;
}

Picture blownUp(const Scene& scene, double stretch) {
    auto x = scene.world.rest;
    for (auto& p : x) p = stretch * p;
    return Renderer(scene, small).draw(x, 0);
}

// Linear light in the middle of the picture, before the tone curve (Khronos PBR Neutral below .76).
std::array<double, 3> middle(const Picture& picture) {
    std::array<double, 3> sum{};
    int count = 0;
    for (int y = picture.height / 2 - 6; y < picture.height / 2 + 6; ++y)
        for (int x = picture.width / 2 - 6; x < picture.width / 2 + 6; ++x, ++count)
            for (int k = 0; k < 3; ++k) {
                const double c = picture.rgb[3 * (y * picture.width + x) + k] / 255.0;
                sum[k] += c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
            }
    for (double& c : sum) c /= count;
    const double low = std::ranges::min(sum);  // 6.25 times its square, or .04 less
    const double lost = low < 0.04 ? std::sqrt(low / 6.25) - low : 0.04;
    for (double& c : sum) c += lost;
    return sum;
}

}  // namespace

TEST_CASE("a surface's stretch is that of its area about each vertex", "[render][latex]") {
    // Twice as long, and half of it half as wide; the last vertex is in no triangle.
    Shape sheet = grid({.columns = 5, .rows = 3, .width = 4, .height = 2});
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < sheet.complex.count(2); ++i) triangles.push_back(sheet.complex.triangle(i));
    sheet.positions.push_back({9, 9, 9});
    const auto place = [](const Vec<double>& p) {
        const double y = p.y < 1 ? 0.5 * p.y : p.y - 0.5;
        return glm::vec3(2 * p.x, 0.8 * y, 0.6 * y);
    };
    std::vector<glm::vec3> x;
    for (const auto& p : sheet.positions) x.push_back(place(p));
    std::vector<float> stretch;
    AreaStretch(triangles, sheet.positions).measure(x, stretch);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double y = sheet.positions[i].y;
        if (y == 0) CHECK(stretch[i] == Approx(1));
        if (y == 1) CHECK((stretch[i] > 1.3 && stretch[i] < 1.7));
        if (y == 2) CHECK(stretch[i] == Approx(2));
    }
    CHECK(stretch.back() == 1);
}

TEST_CASE("light that comes through latex follows exp(-k t / stretch of area)", "[render][latex]") {
    const Look look{
        .object = {}, .color = {0.6, 0.4, 0.3}, .wall = {.thickness = 2e-4, .clear = 1e-4}};
    const auto light = [&](double stretch) {
        Scene scene = balloon(look, stretch);
        lightFromBehind(scene);
        return middle(blownUp(scene, stretch));
    };
    const auto limp = light(1), taut = light(2), tauter = light(4);
    for (int k = 0; k < 3; ++k) {
        const double depth = -2 * std::log(look.color[k]);
        note("through the limp wall", limp[k]);
        CHECK(report("taut over limp, relative to theory",
                     std::abs(taut[k] / limp[k] / std::exp(0.75 * depth) - 1), 0.006));
        CHECK(report("tauter over taut, relative to theory",
                     std::abs(tauter[k] / taut[k] / std::exp(0.1875 * depth) - 1), 0.006));
    }
}

TEST_CASE("latex is dark and matte where it is limp, bright and glossy where it is taut",
          "[render][latex]") {
    const auto seen = [](const Look& look, double stretch) {
        return blownUp(balloon(look, stretch), stretch);
    };
    const auto limp = middle(seen({}, 1)), half = middle(seen({}, 2)), taut = middle(seen({}, 4));
    CHECK(limp[0] < 0.8 * half[0]);
    CHECK(half[0] < 0.9 * taut[0]);
    CHECK(taut[0] > 4 * taut[1]);  // red still

    // Black, it shows what it mirrors alone: the key's soft box, upper left, and its edge.
    const auto mirrored = [&](double stretch) {
        const Picture p = seen({.object = {}, .color = {0, 0, 0}}, stretch);
        int brightest = 0, step = 0;
        for (int y = p.height / 2 - 30; y < p.height / 2; ++y)
            for (int x = p.width / 2 - 25; x < p.width / 2; ++x) {
                const auto* rgb = &p.rgb[3 * (y * p.width + x)];
                brightest = std::max<int>(brightest, rgb[0]);
                step = std::max(step, std::abs(rgb[3] - rgb[0]));
            }
        return std::pair(brightest, step);
    };
    const auto [dull, blurred] = mirrored(1);
    const auto [bright, crisp] = mirrored(4);
    note("brightest that limp latex mirrors, of 255", dull);
    note("brightest that taut latex mirrors, of 255", bright);
    note("step to the next pixel, limp", blurred);
    note("step to the next pixel, taut", crisp);
    CHECK(bright > dull + 20);
    CHECK(crisp > 4 * blurred);
}
