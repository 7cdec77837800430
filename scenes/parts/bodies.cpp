#include "bodies.h"

#include <plait/measure/surfaces/solid.h>
#include <plait/stencils.h>

namespace plait {

Piece addSolid(World& world, const Shape& shape, double mass) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < shape.complex.count(2); ++t) triangles.push_back(shape.complex.triangle(t));
    return addPiece(world, shape,
                    {.density = mass / solidMoments(shape.positions, triangles).volume});
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
