// Points that come and go, as balls whose look follows from their id and age.
#include "render/renderer.h"
#include "tests/catch.h"

#include <algorithm>

using namespace plait;

namespace {

// Four points in a row, the last of which may be absent.
Scene row(Material material) {
    Scene scene;
    Shape points{SimplicialComplex(4), {{-0.3, 0, 0}, {-0.1, 0, 0}, {0.1, 0, 0}, {0.3, 0, 0}}};
    const Range range = scene.world.add(points, {.density = 1});
    Look look{.object = range, .material = material, .radius = 0.05};
    look.point = [](std::int32_t id, double age) {
        return PointLook{age < 1 ? 0.05 : 0.02,
                         {id == 0 ? 2.0 : 0.0, id == 1 ? 2.0 : 0.0, id == 2 ? 2.0 : 0.0},
                         id == 2 ? 0.1 : 0};
    };
    scene.view.looks = {look};
    scene.view.ground = false;
    scene.view.glow = 0;
    scene.view.cameras = {{.eye = {0, 0, 2}, .target = {0, 0, 0}, .focalLength = 50}};
    return scene;
}

struct Counted {
    int red = 0, green = 0, blue = 0;
};
Counted countedIn(const Picture& picture) {
    Counted n;
    for (std::size_t p = 0; p + 2 < picture.rgb.size(); p += 3) {
        const int r = picture.rgb[p], g = picture.rgb[p + 1], b = picture.rgb[p + 2];
        n.red += r > 200 && g < 120 && b < 120;
        n.green += g > 200 && r < 120 && b < 120;
        n.blue += b > 200 && r < 120 && g < 120;
    }
    return n;
}

}  // namespace

TEST_CASE("points: size, light and tail follow from id and age, and what is absent is not drawn",
          "[render][sources][PA2]") {
    const Scene scene = row(Material::spark);
    Renderer renderer(scene, {.width = 320, .height = 180});
    const std::vector<std::int32_t> ids{0, 1, 2, -1};
    const std::vector<Vec<double>> still(4), up(4, Vec<double>{0, 1, 0});
    const auto drawn = [&](std::vector<double> ages, const std::vector<Vec<double>>& velocities) {
        return countedIn(renderer.draw(Moment{scene.world.rest, 0, ids, ages, velocities}));
    };
    const Counted young = drawn({0, 0, 0, -1}, still);
    CHECK(young.red > 60);
    CHECK(std::abs(young.red - young.green) < 0.15 * young.red);
    CHECK(std::abs(young.red - young.blue) < 0.15 * young.red);
    const Counted old = drawn({2, 0, 0, -1}, still);
    CHECK(old.red < 0.4 * young.red);
    CHECK(old.green == young.green);
    const Counted gone = drawn({-1, 0, -1, -1}, still);
    CHECK(gone.red + gone.blue == 0);
    CHECK(gone.green == young.green);
    const Counted fast = drawn({0, 0, 0, -1}, up);
    CHECK(fast.red == young.red);
    CHECK(fast.blue > 1.3 * young.blue);
}
