#include "wire_mesh.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

glm::vec2 direction(float angle) { return {std::cos(angle), std::sin(angle)}; }

std::vector<OutlinePoint> circle(float radius, float pixels) {
    const int sides = pixels < 6 ? 8 : pixels < 24 ? 12 : 24;
    const float step = glm::two_pi<float>() / static_cast<float>(sides);
    const float corner = radius * step / (2 * std::sin(step / 2));
    std::vector<OutlinePoint> outline;
    for (int k = 0; k < sides; ++k) {
        const glm::vec2 out = direction(step * static_cast<float>(k));
        outline.push_back({corner * out, glm::vec2(0), out});
    }
    return outline;
}

// Between its rounded corners a side is flat, and is lit so.
std::vector<OutlinePoint> rectangle(const glm::vec2& half, float bevel, float pixels) {
    const int steps = pixels < 4 ? 1 : pixels < 16 ? 2 : 4;
    std::vector<OutlinePoint> outline;
    for (int quarter = 0; quarter < 4; ++quarter) {
        const glm::vec2 side(quarter == 0 || quarter == 3 ? 1 : -1, quarter < 2 ? 1 : -1);
        for (int k = 0; k <= steps; ++k) {
            const float turn =
                static_cast<float>(quarter) + static_cast<float>(k) / static_cast<float>(steps);
            const glm::vec2 out = direction(glm::half_pi<float>() * turn);
            outline.push_back({side * half, bevel * (out - side), out});
        }
    }
    return outline;
}

}  // namespace

std::vector<OutlinePoint> outlineOf(const Section& section, float pixels) {
    const glm::vec2 half(0.5 * section.along, 0.5 * section.across);
    if (half.y <= 0) return circle(half.x, pixels);
    return rectangle(half, static_cast<float>(section.bevel) * std::min(half.x, half.y), pixels);
}

void appendWireVertices(std::span<const WirePoint> path, std::span<const WireLook> looks,
                        std::span<const OutlinePoint> outline, bool closed,
                        std::vector<MeshVertex>& vertices) {
    const auto ring = [&](std::size_t i, float cap) {
        const WirePoint& p = path[i];
        const WireLook& look = looks[i];
        const glm::vec3 across = glm::cross(p.tangent, p.director);
        for (const auto& [sharp, rounding, normal] : outline) {
            const glm::vec2 place = look.scale * (sharp + look.relief * rounding);
            vertices.push_back(
                {.position = p.place + place.x * p.director + place.y * across,
                 .normal = cap != 0 ? cap * p.tangent : normal.x * p.director + normal.y * across,
                 // A cap has no grain of its own, but one along its normal would be none.
                 .tangent = cap != 0 ? p.director : p.tangent,
                 .uv = {look.relief, 0},
                 .tint = look.tint,
                 .cavity = 1,
                 .satin = look.cover});
        }
    };
    for (std::size_t i = 0; i < path.size(); ++i) ring(i, 0);
    if (closed) return;
    ring(0, -1);
    ring(path.size() - 1, 1);
}

void appendWireTriangles(int first, int rings, int corners, bool closed,
                         std::vector<std::array<int, 3>>& triangles) {
    const int joints = closed ? rings : rings - 1;
    for (int i = 0; i < joints; ++i)
        for (int k = 0; k < corners; ++k) {
            const int next = (k + 1) % corners;
            const int a = first + i * corners, b = first + (i + 1) % rings * corners;
            triangles.push_back({a + k, a + next, b + next});
            triangles.push_back({a + k, b + next, b + k});
        }
    if (closed) return;
    const int start = first + rings * corners, end = start + corners;
    for (int k = 1; k + 1 < corners; ++k) {
        triangles.push_back({start, start + k + 1, start + k});
        triangles.push_back({end, end + k, end + k + 1});
    }
}

}  // namespace plait
