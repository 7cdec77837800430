// The plane that parts two convex solids best, and where they touch along it.
#pragma once

#include "convex.h"

#include <optional>
#include <vector>

namespace plait {

// By which features two are parted: a face of one, or an edge of each.
struct Parting {
    enum class By { firstFace, secondFace, edges };
    Vec<double> normal;  // of unit length, from the second to the first
    double gap;          // m, of the first over the second along it; below 0: they overlap
    By by;
    int first, second;  // face or edge of either; -1: none
};

// By the normals of faces and what is across two edges (Gottschalk, Lin and Manocha 1996, but only
// edges whose arcs cross on the sphere of normals, Gregorius 2013). Faces are taken where edges
// part them by no more than `bias` (m) better, since they touch in more than a point. Where corners
// are nearest it is less than the distance, and still a plane between them.
Parting partingOf(const Placed& first, const Placed& second, double bias);

// Two points that are to stay apart along the normal of a parting.
struct TouchPoint {
    Vec<double> first, second;  // m, on either
};

// Where they are nearer than `reach` (m) along the normal: of faces what one covers of the other
// (Sutherland and Hodgman 1974); of edges a point.
void findTouch(const Placed& first, const Placed& second, const Parting& parting, double reach,
               std::vector<TouchPoint>& points);

}  // namespace plait
