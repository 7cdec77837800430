// Convex solids by their corners, faces and edges.
#pragma once

#include "../../numbers/rotation.h"
#include "../../pieces/poses.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace plait {

// About the centre of a piece, at rest. Triangles that lie in one plane are one face.
struct Convex {
    struct Face {
        Vec<double> normal;        // of unit length, outward
        double height;             // m, of its plane along it
        std::vector<int> corners;  // anticlockwise seen from outside
    };
    struct Edge {
        std::array<int, 2> corners;
        std::array<int, 2> faces;  // the left one seen from outside, and the right one
        Vec<double> along;         // of unit length
    };
    std::vector<Vec<double>> corners;  // m
    std::vector<Face> faces;
    std::vector<Edge> edges;
    double radius = 0;  // m, of what is farthest from the centre

    // How far along a direction the first of it is, m.
    double lowest(const Pose& pose, const Vec<double>& direction) const;
};

// Of a closed surface about `centre`. Throws std::invalid_argument, naming `name`, if a corner lies
// outside of a face by more than a millionth of its radius.
Convex convexOf(std::span<const Vec<double>> positions,
                std::span<const std::array<int, 3>> triangles, const Vec<double>& centre,
                const std::string& name);

// The same where it is: corners, normals, directions of edges.
struct Placed {
    const Convex* shape = nullptr;
    std::vector<Vec<double>> corners, normals, along;

    void put(const Convex& convex, const Pose& pose);
    double lowest(const Vec<double>& direction) const;
    double highest(const Vec<double>& direction) const { return -lowest(-direction); }
};

}  // namespace plait
