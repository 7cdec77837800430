// What comes apart, and is whole again when what was before is drawn.
#include "render/renderer.h"
#include "tests/catch.h"
#include "tests/torn_sheet.h"

#include <algorithm>
#include <cstdlib>

using namespace plait;
using namespace plait::test;

namespace {

constexpr RenderOptions small{.width = 320, .height = 180};
constexpr double gap = 0.3;  // m, in the middle of the picture

Scene sceneOf(const TornSheet& sheet, Look look = {}) {
    Scene scene;
    scene.world = sheet.world;
    look.object = sheet.cloth;
    scene.view.looks = {look};
    scene.view.ground = false;
    scene.view.glow = 0;
    scene.view.cameras = {{.eye = {gap / 2, 0, 3}, .target = {gap / 2, 0, 0}, .focalLength = 50}};
    return scene;
}

// By how much of 255 the middle of two pictures differs.
int differenceInTheMiddle(const Picture& a, const Picture& b) {
    const std::size_t at = 3 * static_cast<std::size_t>(a.height / 2 * a.width + a.width / 2);
    int most = 0;
    for (std::size_t k = at; k < at + 3; ++k) most = std::max(most, std::abs(a.rgb[k] - b.rgb[k]));
    return most;
}

double fractionThatDiffers(const Picture& a, const Picture& b) {
    REQUIRE(a.rgb.size() == b.rgb.size());
    int count = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) count += std::abs(a.rgb[i] - b.rgb[i]) > 8;
    return count / static_cast<double>(a.rgb.size());
}

// A colour a vertex, and one for the spare ones.
Look painted(const TornSheet& sheet, const std::array<double, 3>& spare) {
    Look look;
    for (int v = 0; v < sheet.cloth.size(); ++v)
        look.colors.push_back(v < 6 ? std::array{0.1 + 0.1 * v, 0.05, 0.3} : spare);
    return look;
}

Look printed(const TornSheet& sheet, const std::array<double, 2>& spare) {
    Look look{.object = {}, .print = "plait"};
    for (int v = 0; v < sheet.cloth.size(); ++v)
        look.uv.push_back(v < 6 ? std::array{v % 3 / 2.0, double(v / 3)} : spare);
    return look;
}

}  // namespace

TEST_CASE("between the lips of a tear one sees what is behind, until it is whole again",
          "[render][tearing]") {
    const TornSheet sheet;
    const Scene scene = sceneOf(sheet);
    Renderer renderer(scene, small);
    const Picture whole = renderer.draw(scene.world.rest, 0);
    const std::vector<Vec<double>> apart = sheet.parted(gap);
    const Moment torn{.positions = apart, .cuts = sheet.cuts};
    const Picture open = renderer.draw(torn);
    const Picture nothing =
        renderer.draw(std::vector<Vec<double>>(apart.size(), Vec<double>{0, 100, 0}), 0);
    CHECK(differenceInTheMiddle(open, nothing) <= 2);
    CHECK(differenceInTheMiddle(whole, nothing) > 40);
    CHECK((renderer.draw(scene.world.rest, 0) == whole));
    CHECK((renderer.draw(torn) == open));
    // Not torn, it would be drawn out instead.
    CHECK(differenceInTheMiddle(renderer.draw(apart, 0), nothing) > 40);
}

TEST_CASE("an exposure may begin before a tear and end after it", "[render][tearing]") {
    const TornSheet sheet;
    const Scene scene = sceneOf(sheet);
    Renderer renderer(scene, small);
    const std::vector<Vec<double>> apart = sheet.parted(gap);
    const Moment before{scene.world.rest}, after{.positions = apart, .cuts = sheet.cuts};
    const Picture whole = renderer.draw(before), open = renderer.draw(after);
    const std::vector<Moment> both{before, after, before, after};
    const Picture mean = renderer.draw(both);
    CHECK(differenceInTheMiddle(mean, whole) > 10);
    CHECK(differenceInTheMiddle(mean, open) > 10);
    CHECK((renderer.draw(both) == mean));
    CHECK((renderer.draw(before) == whole));
}

TEST_CASE("a copy looks as its vertex does, and what is not there yet is not seen",
          "[render][tearing]") {
    const TornSheet sheet(2), without(0), more(20);
    const auto drawn = [](const TornSheet& of, const Look& look, bool torn, double by) {
        const Scene scene = sceneOf(of, look);
        const std::vector<Vec<double>> x = of.parted(by);
        Renderer renderer(scene, small);
        return torn ? renderer.draw(Moment{.positions = x, .cuts = of.cuts})
                    : renderer.draw(scene.world.rest, 0);
    };
    const Picture plain = drawn(sheet, {}, false, 0);
    CHECK((drawn(more, {}, false, 0) == plain));
    const Scene never = sceneOf(without);
    CHECK((Renderer(never, small).draw(never.world.rest, 0) == plain));

    const std::array<Look, 2> paint{painted(sheet, {0, 1, 0}), painted(sheet, {1, 1, 1})};
    const std::array<Look, 2> print{printed(sheet, {0, 0}), printed(sheet, {1, 1})};
    for (const auto& [a, b] : {paint, print}) {
        const Picture torn = drawn(sheet, a, true, gap), closed = drawn(sheet, a, true, 0);
        CHECK((drawn(sheet, b, true, gap) == torn));
        CHECK(fractionThatDiffers(closed, drawn(sheet, a, false, 0)) < 0.002);
    }
}

TEST_CASE("latex that tears is as taut as its own triangles", "[render][tearing][latex]") {
    const TornSheet sheet;
    const Scene scene = sceneOf(sheet, {.object = {}, .material = Material::latex});
    Renderer renderer(scene, small);
    const Picture whole = renderer.draw(scene.world.rest, 0);
    const std::vector<Vec<double>> closed = sheet.parted(0);
    const Picture torn = renderer.draw(Moment{.positions = closed, .cuts = sheet.cuts});
    CHECK(fractionThatDiffers(torn, whole) < 0.002);
}
