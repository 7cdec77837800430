// Which way the triangles of a body face.
#pragma once

#include "../numbers/math.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace plait {

// Turns triangles so that neighbours agree and every part of the surface, by itself, has its
// volume inside. Returns how many were turned. Triangles that no edge of two joins are parts of
// their own.
int faceOutward(std::span<const Vec<double>> positions, std::vector<std::array<int, 3>>& triangles);

// An edge where it is not closed: along which as many triangles do not run one way as the other.
struct Opening {
    std::array<int, 2> edge;
    int count;  // of such edges
    bool open;  // that one has one triangle; else its triangles cannot all face outward
};
std::optional<Opening> openingOf(std::span<const std::array<int, 3>> triangles);

}  // namespace plait
