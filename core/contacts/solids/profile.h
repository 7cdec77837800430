// What a potter turns: a closed outline of radius and height, turned around y. It may be hollow, as
// a jug is, whose outline goes up on its outside and down on its inside.
#pragma once

#include "../../numbers/math.h"
#include "profile_grid.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

class Profile {
public:
    // Corners in order, {radius, height} in m, the last joined to the first; either way round. What
    // of it lies on the axis is no surface. Throws std::invalid_argument for fewer than three
    // corners, a radius below 0, what is not finite, and what encloses no area.
    explicit Profile(std::vector<std::array<double, 2>> corners);

    struct Nearest {
        double distance;               // m, below 0 inside
        std::array<double, 2> normal;  // outward, of length 1: radius, height
    };
    Nearest nearest(double radius, double height) const;
    bool contains(double radius, double height) const;
    // How far along a way from a point, in three dimensions, it is met first, of its edges in
    // `which`; `most` (m) where it is not met before. `direction` is of length 1.
    double met(const Vec<double>& from, const Vec<double>& direction,
               std::span<const std::size_t> which, double most) const;
    // Edges within this distance (m).
    std::vector<std::size_t> edgesNear(double radius, double height, double distance) const;

    const std::vector<std::array<double, 2>>& corners() const { return corners_; }

private:
    bool isSurface(std::size_t edge) const;
    std::array<double, 2> offEdge(std::size_t edge, double radius, double height) const;
    bool crosses(std::size_t edge, double radius, double height) const;

    std::vector<std::array<double, 2>> corners_;
    bool reversed_ = false;  // corners go round clockwise, with the radius to the right
    ProfileGrid grid_;
};

}  // namespace plait
