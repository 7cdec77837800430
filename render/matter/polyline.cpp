#include "polyline.h"

#include "directions.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>

namespace plait {
namespace {

constexpr int ringSides = 12, stepsPerLink = 4;

glm::vec3 catmullRom(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d,
                     float s) {
    return 0.5f *
           (2.0f * b +
            s * (c - a + s * (2.0f * a - 5.0f * b + 4.0f * c - d + s * (3.0f * (b - c) + d - a))));
}

struct Curve {
    std::vector<glm::vec3> points;
    std::vector<glm::vec3> tints;
};

Curve refine(std::span<const glm::vec3> points, std::span<const glm::vec3> tints, bool closed) {
    const int n = static_cast<int>(points.size()), links = closed ? n : n - 1;
    const auto at = [&](int i) { return points[closed ? (i + n) % n : std::clamp(i, 0, n - 1)]; };
    Curve curve;
    for (int i = 0; i < links; ++i)
        for (int k = 0; k < stepsPerLink; ++k) {
            const float s = static_cast<float>(k) / stepsPerLink;
            curve.points.push_back(catmullRom(at(i - 1), at(i), at(i + 1), at(i + 2), s));
            curve.tints.push_back(glm::mix(tints[i], tints[(i + 1) % n], s));
        }
    if (!closed) {
        curve.points.push_back(points.back());
        curve.tints.push_back(tints.back());
    }
    return curve;
}

// Rings of `ringSides` vertices; consecutive ones are joined by the caller's `join`.
class TubeBuilder {
public:
    TubeBuilder(std::vector<MeshVertex>& vertices, std::vector<std::array<int, 3>>& triangles)
        : vertices_(vertices), triangles_(triangles), first_(static_cast<int>(vertices.size())) {}

    // `lean` turns the normals along the tangent, as on a round end.
    void ring(const glm::vec3& center, const glm::vec3& tangent, const glm::vec3& normal,
              float radius, float lean, const glm::vec3& tint) {
        const glm::vec3 binormal = glm::cross(tangent, normal);
        for (int k = 0; k < ringSides; ++k) {
            const float a = glm::two_pi<float>() * static_cast<float>(k) / ringSides;
            const glm::vec3 out = std::cos(a) * normal + std::sin(a) * binormal;
            vertices_.push_back(
                {.position = center + radius * out,
                 .normal = glm::normalize(std::sqrt(1 - lean * lean) * out + lean * tangent),
                 .tangent = tangent,
                 .tint = tint});
        }
        if (rings_++ > 0) join(rings_ - 2, rings_ - 1);
    }

    void close() { join(rings_ - 1, 0); }

private:
    void join(int a, int b) {
        for (int k = 0; k < ringSides; ++k) {
            const int next = (k + 1) % ringSides;
            const int a0 = first_ + a * ringSides + k, a1 = first_ + a * ringSides + next;
            const int b0 = first_ + b * ringSides + k, b1 = first_ + b * ringSides + next;
            triangles_.push_back({a0, a1, b1});
            triangles_.push_back({a0, b1, b0});
        }
    }

    std::vector<MeshVertex>& vertices_;
    std::vector<std::array<int, 3>>& triangles_;
    int first_, rings_ = 0;
};

constexpr std::array<float, 3> capLean{1, 0.8f, 0.4f};

}  // namespace

std::vector<Polyline> polylines(std::span<const std::array<int, 2>> edges, int vertexCount) {
    std::vector<std::vector<int>> at(static_cast<std::size_t>(vertexCount));
    for (int e = 0; e < static_cast<int>(edges.size()); ++e)
        for (const int v : edges[e]) at[v].push_back(e);
    std::vector<char> used(edges.size());
    std::vector<Polyline> lines;
    const auto follow = [&](int start, int edge) {
        Polyline line{{start}};
        for (int v = start; edge >= 0;) {
            used[edge] = 1;
            v = edges[edge][0] == v ? edges[edge][1] : edges[edge][0];
            if (v == start && at[v].size() == 2) {
                line.closed = true;
                break;
            }
            line.vertices.push_back(v);
            edge = -1;
            if (at[v].size() == 2)
                for (const int e : at[v])
                    if (!used[e]) edge = e;
        }
        lines.push_back(line);
    };
    for (int v = 0; v < vertexCount; ++v)
        if (at[v].size() != 2)
            for (const int e : at[v])
                if (!used[e]) follow(v, e);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e)
        if (!used[e]) follow(edges[e][0], e);
    return lines;
}

void appendTube(std::span<const glm::vec3> points, std::span<const glm::vec3> tints, bool closed,
                float radius, std::vector<MeshVertex>& vertices,
                std::vector<std::array<int, 3>>& triangles) {
    const Curve curve = refine(points, tints, closed);
    const auto& p = curve.points;
    const int n = static_cast<int>(p.size());
    TubeBuilder tube(vertices, triangles);
    glm::vec3 tangent{1, 0, 0}, normal;
    for (int i = 0; i < n; ++i) {
        const glm::vec3 ahead = p[closed ? (i + 1) % n : std::min(i + 1, n - 1)];
        const glm::vec3 behind = p[closed ? (i + n - 1) % n : std::max(i - 1, 0)];
        tangent = unit(ahead - behind, tangent);
        // The frame is carried along without a twist.
        normal = i == 0 ? anyAcross(tangent)
                        : unit(normal - tangent * glm::dot(normal, tangent), anyAcross(tangent));
        const auto cap = [&](float lean) {
            tube.ring(p[i] + lean * radius * tangent, tangent, normal,
                      radius * std::sqrt(1 - lean * lean), lean, curve.tints[i]);
        };
        if (!closed && i == 0)
            for (const float lean : capLean) cap(-lean);
        cap(0);
        if (!closed && i == n - 1)
            for (int k = 2; k >= 0; --k) cap(capLean[k]);
    }
    if (closed) tube.close();
}

}  // namespace plait
