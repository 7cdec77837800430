// Solids with a formula that matter stays outside of: floors, poles, balls, boxes, still or moving
// rigidly, as heavy as the world.
#pragma once

#include "../surface.h"
#include "placement.h"
#include "solid.h"

namespace plait {

struct Collider {
    Solid solid;
    Frame frame{};  // where it stands: the plane's normal and the capsule's axis are its `up`
    // Where it stands at time t (s), in place of the frame; a function of t alone, asked at both
    // ends of a base step. In between its origin goes straight and steadily and it turns steadily,
    // by less than half a turn (M 2.4) [IN27, IN28].
    Posing motion{};
    // As those of a Surface; of a collider and a surface the mean counts.
    double staticFriction = 0.1;
    double dynamicFriction = 0.1;
    double restitution = 0;
    double stickiness = 0;  // N
};

struct ColliderOptions {
    std::string name = "colliders";
    int order = 0;
    int importance = 24;
    double recovery = 0.5;       // m/s: how fast what began inside, or too near, comes out
    double bounceThreshold = 0;  // m/s: what approaches more slowly, or at less than 2 g h, does
                                 // not bounce
};

struct World;

// Adds the set that keeps every vertex of these surfaces its thickness or radius outside of all
// these colliders, however fast, on the surfaces' terms; their layers, and whether they meet
// themselves, play no part. Only vertices: an edge between two may cut a corner; where that shows,
// pin a mesh and let it meet(). Where lengths leave no room for it (mending), all but a quarter of
// the thickness gives way; and where matter meets matter too, neither has the last word: what one
// would push through the other stays where the substep began. Throws std::invalid_argument, naming
// the value, for one out of range; so does a frame of the solver if a motion gives no frame.
void collide(World& world, const std::vector<Collider>& colliders, std::vector<Surface> surfaces,
             const ColliderOptions& options = {});

}  // namespace plait
