// Water: what it swallows, what stands before and behind it.
#include "render/renderer.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

using namespace plait;
using test::note;
using test::report;

namespace {

constexpr RenderOptions small{.width = 320, .height = 180};
constexpr double spacing = 0.04;  // m

// A slab of water behind a pane at z = 0, as deep as told (m; 0: next to none, out of sight), seen
// straight on, and nothing else but a backdrop.
Scene slab(double deep) {
    Scene scene;
    Shape shape;
    const int layers = std::max(1, static_cast<int>(std::lround(deep / spacing)));
    for (int k = 0; k < layers; ++k)
        for (int j = -12; j < 12; ++j)
            for (int i = -18; i < 18; ++i) {
                const double away = deep > 0 ? 0 : 1000;
                shape.positions.push_back(
                    {(i + 0.5) * spacing, (j + 0.5) * spacing + away, -(k + 0.5) * spacing});
            }
    shape.complex = SimplicialComplex(static_cast<int>(shape.positions.size()));
    Look look;
    look.object = scene.world.add(shape);
    look.material = Material::water;
    look.wall = {.thickness = 0, .clear = 1 / 1.8};
    look.color = {0, 0, 1e-3};
    look.radius = 0.5 * spacing;
    look.panes = {{{0, 0, 0}, {0, 0, 1}}};
    scene.view.looks = {look};
    scene.view.cameras = {{.eye = {0, 0, 3}, .target = {0, 0, 0}, .focalLength = 50}};
    scene.view.ground = false;
    scene.view.glow = 0;
    scene.view.stage.vignette = 0;
    return scene;
}

void addBlock(Scene& scene, double z) {
    scene.view.props.push_back(
        {block({.width = 0.6, .height = 0.6, .depth = 0.1}, {.origin = {-0.3, -0.3, z}}),
         Material::matte,
         {0.8, 0.8, 0.8}});
}

Picture drawn(const Scene& scene) { return Renderer(scene, small).draw(scene.world.rest, 0); }

// Linear light in the middle of the picture, before the tone curve (Khronos PBR Neutral below .76).
std::array<double, 3> middle(const Picture& picture) {
    std::array<double, 3> sum{};
    int count = 0;
    for (int y = picture.height / 2 - 6; y < picture.height / 2 + 6; ++y)
        for (int x = picture.width / 2 - 6; x < picture.width / 2 + 6; ++x, ++count)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto place = static_cast<std::size_t>(3 * (y * picture.width + x)) + k;
                const double c = picture.rgb[place] / 255.0;
                sum[k] += c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
            }
    for (double& c : sum) c /= count;
    const double low = std::min({sum[0], sum[1], sum[2]});
    const double lost = low < 0.04 ? std::sqrt(low / 6.25) - low : 0.04;
    for (double& c : sum) c += lost;
    return sum;
}

}  // namespace

TEST_CASE("water swallows light by its depth, and more of it where it has less colour",
          "[render][water]") {
    const auto none = middle(drawn(slab(0))), some = middle(drawn(slab(0.4))),
               more = middle(drawn(slab(0.8)));
    note("red, of what is behind: 0.4 m", some[0] / none[0]);
    note("0.8 m", more[0] / none[0]);
    REQUIRE(some[0] < 0.6 * none[0]);
    // Of red it swallows 1.8 a metre; a fiftieth is mirrored.
    REQUIRE(report("0.8 m against 0.4 m, off exp(-0.72)",
                   std::fabs(more[0] / some[0] / std::exp(-0.72) - 1), 0.12));
    REQUIRE(report("blue passes", std::fabs(more[2] / none[2] - 1), 0.05));
}

TEST_CASE("what stands before water hides it, what stands behind is seen through it",
          "[render][water]") {
    Scene before = slab(0.4), behind = slab(0.4), dry = slab(0), dryBehind = slab(0);
    addBlock(before, 0.5);
    addBlock(dry, 0.5);
    addBlock(behind, -1);
    addBlock(dryBehind, -1);
    const auto hidden = middle(drawn(before)), alone = middle(drawn(dry));
    for (std::size_t k = 0; k < 3; ++k)
        REQUIRE(report("hidden", std::fabs(hidden[k] / alone[k] - 1), 0.1));
    const auto through = middle(drawn(behind)), without = middle(drawn(slab(0.4))),
               clear = middle(drawn(dryBehind));
    REQUIRE(std::fabs(through[2] - without[2]) > 0.05);
    REQUIRE(report("red through water, off exp(-0.72)",
                   std::fabs(through[0] / clear[0] / std::exp(-0.72) - 1), 0.25));
}

TEST_CASE("water is the same picture whenever it is drawn", "[render][water]") {
    const Scene scene = slab(0.4);
    Renderer renderer(scene, small);
    const Picture first = renderer.draw(scene.world.rest, 0);
    std::vector<Vec<double>> moved = scene.world.rest;
    for (Vec<double>& p : moved) p.y *= 0.5;
    REQUIRE_FALSE(renderer.draw(moved, 0) == first);
    REQUIRE(renderer.draw(scene.world.rest, 0) == first);
    REQUIRE(drawn(scene) == first);
}

TEST_CASE("two waters, or seven panes, are refused", "[render][water]") {
    Scene scene = slab(0.1);
    scene.view.looks.push_back(scene.view.looks[0]);
    REQUIRE_THROWS_AS(Renderer(scene, small), std::invalid_argument);
    scene.view.looks.pop_back();
    scene.view.looks[0].panes.resize(7, scene.view.looks[0].panes[0]);
    REQUIRE_THROWS_AS(Renderer(scene, small), std::invalid_argument);
}
