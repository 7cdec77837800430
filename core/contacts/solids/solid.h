// Solids in axes of their own: how far a point is from one, on which side, and when a straight path
// first comes near it.
#pragma once

#include "../../numbers/math.h"
#include "profile.h"

#include <memory>
#include <optional>

namespace plait {

// All that is within `radius` of a box around the origin, its sides along the axes; or all that is
// not above y = 0; or what a profile encloses, turned around y. Lengths in m, at least 0.
struct Solid {
    Vec<double> half{};  // of the box: how far it reaches along each axis
    double radius = 0;
    bool halfSpace = false;
    std::shared_ptr<const Profile> profile{};

    static Solid plane() { return {.halfSpace = true}; }
    static Solid sphere(double radius) { return {.radius = radius}; }
    // Around a segment of this length along y.
    static Solid capsule(double length, double radius) {
        return {.half = {0, 0.5 * length, 0}, .radius = radius};
    }
    static Solid box(double width, double height, double depth) {
        return {.half = {0.5 * width, 0.5 * height, 0.5 * depth}};
    }
    static Solid turned(Profile profile) {
        return {.profile = std::make_shared<const Profile>(std::move(profile))};
    }
};

// How far a point is outside, below 0 inside, and the way out where it is nearest.
struct Side {
    double distance;     // m
    Vec<double> normal;  // unit
};

Side sideOf(const Solid& solid, const Vec<double>& p);

// The part of the way from `start` to `end` after which it is no more than `gap` (m) away, for the
// first time.
std::optional<double> reaches(const Solid& solid, const Vec<double>& start, const Vec<double>& end,
                              double gap);

}  // namespace plait
