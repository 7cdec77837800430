// Pictures to judge by eye beside the look book: plait_render_tests "[look]" leaves them in look/.
#include "render/bench.h"
#include "render/pictures/image.h"
#include "render/renderer.h"
#include "scenes/parts/views.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <cmath>
#include <filesystem>

using namespace plait;

namespace {

constexpr int columns = 126, rows = 79;
constexpr double width = 1.92, height = 1.2;

Scene flagScene() {
    constexpr std::array brass{0.584, 0.305, 0.050}, steel{0.397, 0.445, 0.491};
    Scene scene;
    const GridParameters size{.columns = columns, .rows = rows, .width = width, .height = height};
    Look flag{.object = scene.world.add(grid(size)), .print = "plait"};
    for (const auto& x : scene.world.rest) flag.uv.push_back({x.x / width, x.y / height});
    View& view = scene.view;
    view.looks = {flag};
    view.cameras = {{.eye = {0.35, 1.7, 6.6}, .target = {0.8, 2.36, 0}, .focalLength = 68}};
    view.ground = false;
    view.glowCenter = {1.2, 1.55, -2};
    view.props.push_back({turned({{0.022, 0}, {0.022, 3.12}}), Material::steel, steel});
    view.props.push_back({sphere({.subdivisions = 4, .radius = 0.05}, {.origin = {0, 3.165, 0}}),
                          Material::brass, brass});
    for (const double y : {3.11, 3.04, 1.875}) {
        const Shape ring = turned({{0.022, y - 0.012},
                                   {0.027, y - 0.01},
                                   {0.028, y},
                                   {0.027, y + 0.01},
                                   {0.022, y + 0.012}});
        view.props.push_back({ring, Material::brass, brass});
    }
    return scene;
}

// Waves that travel and grow towards the free end; lengths along the flag are kept.
std::vector<Vec<double>> waving(double t) {
    std::vector<Vec<double>> positions;
    for (int row = 0; row < rows; ++row) {
        const double v = height * row / (rows - 1), step = width / (columns - 1);
        Vec<double> x{0.026, 1.86 + v, 0};
        for (int column = 0; column < columns; ++column) {
            const double u = step * column, g = u / width;
            const double swell = std::sin(5.2 * u - 6 * t - 0.7 * (height - v) +
                                          0.9 * std::sin(1.9 * v + 1.2 * u - 3 * t));
            const double ripple = std::sin(9.1 * u + 2.6 * v - 9 * t + 0.6);
            const double angle = ((0.3 + 0.9 * g) * (1.25 * swell + 0.4 * ripple) +
                                  0.3 * std::sin(2.1 * u - 2 * t + 1)) *
                                 (1 - std::exp(-5 * u));
            if (column > 0)
                x += step * Vec<double>{std::cos(angle), -0.1 - 0.25 * g, std::sin(angle)};
            positions.push_back(x);
        }
    }
    return positions;
}

}  // namespace

TEST_CASE("a flag to look at", "[.][look]") {
    Renderer renderer(flagScene());
    std::filesystem::create_directories("look");
    for (const int frame : {0, 1, 2, 3})
        writePng("look/flag" + std::to_string(frame) + ".png",
                 renderer.draw(waving(0.4 + 0.45 * frame), 0));
}

TEST_CASE("what a frame costs", "[.][look]") {
    const RenderTimes times = benchRender();
    test::note("renderer made, s", times.start);
    test::note("first frame, s", times.first);
    test::note("frame of 80,000 triangles at 1280x720, 4 samples, s", times.frame);
}
