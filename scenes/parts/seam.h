// Where cloth is sewn to a surface that moves: a closed line around it.
#pragma once

#include <plait/complex/shapes.h>

#include <array>
#include <functional>
#include <vector>

namespace plait {

// Triangles counter-clockwise from outside; where its vertices are by time (s).
struct MovingSurface {
    std::vector<std::array<int, 3>> triangles;
    std::function<std::vector<Vec<double>>(double t)> positions;
};

class Seam {
public:
    // Where the plane through the frame's origin and across its `up` cuts the surface at time 0, so
    // far (m) off it. From where it is furthest along `across`, towards across x up; its points are
    // all as far from one to the next as seen `flare` (m) further out. Of several closed lines it
    // is the one nearest to the origin. Throws std::invalid_argument if there is none.
    Seam(MovingSurface surface, const Frame& frame, double clearance, double flare, int points);

    // Above the places that they have on the surface.
    std::vector<Vec<double>> at(double t) const;
    // By point: the direction in the plane that leads away at time 0, without what is uneven in the
    // surface.
    const std::vector<Vec<double>>& outwards() const { return outwards_; }

private:
    // On two edges of one triangle, or on one.
    struct Place {
        std::array<int, 4> corner;
        std::array<double, 4> weight;
    };

    static Place between(const Place& a, const Place& b, double part);
    std::vector<Place> sectionOf(const Frame& frame) const;
    std::vector<Vec<double>> above(const std::vector<Place>& places, double t) const;

    MovingSurface surface_;
    double clearance_;
    std::vector<Place> places_;
    std::vector<Vec<double>> outwards_;
};

}  // namespace plait
