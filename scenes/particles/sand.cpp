#include "sand.h"

#include <plait/constraints/constants.h>
#include <plait/contacts/solids/collider.h>
#include <plait/forces/gravity.h>

#include <cmath>

namespace plait {

double sandMass(double radius) { return 2600 * 4 / 3.0 * pi * std::pow(radius, 3); }

Grains sandOf(Range vertices, double radius, double friction) {
    return {.vertices = vertices,
            .radius = radius,
            .staticFriction = friction,
            .dynamicFriction = 0.8 * friction};
}

void addSand(Scene& scene, const Grains& sand) {
    World& world = scene.world;
    world.act<Gravity>(GravityOptions{});
    pushGrains(world, sand, {.name = "grains"});
    Collider table{.solid = Solid::plane()};
    table.staticFriction = table.dynamicFriction = 1;
    collide(world, {table},
            {{.vertices = sand.vertices,
              .thickness = sand.radius,
              .radii = sand.radii,
              .staticFriction = 1,
              .dynamicFriction = 1}},
            {.name = "table", .order = 1});
    scene.options.schedule = {.substeps = 30, .iterations = 4, .collisionPasses = 1};
}

Metric countThere(const std::string& name, double low, double high) {
    const auto count = [](const Snapshot& at) {
        double n = 0;
        for (std::size_t v = 0; v < at.positions.size(); ++v) n += at.isHere(static_cast<int>(v));
        return n;
    };
    return {.name = name, .unit = "", .measure = count, .low = low, .high = high, .caption = true};
}

Metric inTheTable(const Grains& sand) {
    const auto below = [sand](const Snapshot& at) {
        double n = 0;
        for (int v = sand.vertices.first; v < sand.vertices.last; ++v)
            n += at.isHere(v) && !(at.positions[v].y > 0.5 * sand.radius);
        return n;
    };
    return {.name = "in the table", .unit = "", .measure = below, .low = 0, .high = 0};
}

}  // namespace plait
