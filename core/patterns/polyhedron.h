// A convex solid that planes are cut off from.
#pragma once

#include "solid_pattern.h"

#include <span>
#include <vector>

namespace plait {

class Polyhedron {
public:
    struct Face {
        std::vector<int> corners;  // anticlockwise from outside
        int plane;                 // as named by cutOff
    };

    // A cube about `centre`, its faces of plane -1.
    Polyhedron(const Vec<double>& centre, double halfSide);

    // Takes off what lies outside of a plane, unless that is all within `slack` (m) of it.
    void cutOff(const HalfSpace& plane, int name, double slack);

    std::span<const Vec<double>> corners() const { return corners_; }
    std::span<const Face> faces() const { return faces_; }
    bool empty() const { return faces_.empty(); }
    double reach(const Vec<double>& from) const;  // m, of the farthest corner
    Shape shape() const;                          // of what corners are in use

private:
    std::vector<Vec<double>> corners_;
    std::vector<Face> faces_;
};

}  // namespace plait
