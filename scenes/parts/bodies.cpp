#include "bodies.h"

#include <plait/measure/surfaces/geometry.h>
#include <plait/stencils.h>

namespace plait {

Range addBody(World& world, const Shape& shape, double mass) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < shape.complex.count(2); ++t) triangles.push_back(shape.complex.triangle(t));
    return world.add(shape, {.density = mass / area(shape.positions, triangles)});
}

void keepShapes(World& world, std::span<const Range> bodies, SetOptions options) {
    std::vector<int> pairs;
    for (const Range& body : bodies)
        for (int a = body.first; a < body.last; ++a)
            for (int b = a + 1; b < body.last; ++b) pairs.insert(pairs.end(), {a, b});
    world.constrain(restRows<Stretch>(pairs, world.rest), std::move(options));
}

void addGround(World& world, Range vertices, double height, double thickness, int order) {
    Rows<PlaneContact> ground = restRows<PlaneContact>(pointStencils(vertices), world.rest);
    for (auto& row : ground.rows) row = {{0, height, 0}, {0, 1, 0}, thickness};
    world.constrain(ground, {.name = "ground", .order = order});
}

Surface roughSurface(Range vertices, double thickness, double friction) {
    return {.vertices = vertices,
            .thickness = thickness,
            .staticFriction = friction,
            .dynamicFriction = friction};
}

}  // namespace plait
