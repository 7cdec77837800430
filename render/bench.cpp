#include "bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace plait {
namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

RenderTimes benchRender(const RenderOptions& options, int cells, int frames) {
    Scene scene;
    const GridParameters size{
        .columns = cells + 1, .rows = cells + 1, .width = 1.92, .height = 1.2};
    const Range cloth = scene.world.add(grid(size, {.origin = {-0.96, 0.4, 0}}));
    Look look{.object = cloth, .print = "plait"};
    for (const auto& x : scene.world.rest) look.uv.push_back({x.x, x.y});
    scene.view.cameras = {{.eye = {0, 1, 5}, .target = {0, 0.9, 0}, .focalLength = 68}};
    scene.view.looks = {look};

    RenderTimes times;
    double before = now();
    Renderer renderer(scene, options);
    times.start = now() - before;
    auto x = scene.world.rest;
    times.frame = 1e9;
    for (int i = 0; i < frames; ++i) {
        const double t = i / 24.0;
        for (std::size_t k = 0; k < x.size(); ++k)
            x[k].z = 0.12 * std::sin(6 * scene.world.rest[k].x - 5 * t);
        before = now();
        renderer.draw(x, t);
        const double took = now() - before;
        if (i == 0)
            times.first = took;
        else
            times.frame = std::min(times.frame, took);
    }
    return times;
}

}  // namespace plait
