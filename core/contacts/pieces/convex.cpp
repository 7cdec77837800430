#include "convex.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace plait {
namespace {

constexpr double flat = 1e-6;  // of the radius

Vec<double> normalOf(std::span<const Vec<double>> x, const std::array<int, 3>& t) {
    const Vec<double> n = cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
    return divide(1.0, length(n)) * n;
}

// The ways round what is given as triangles of one plane: edges that only one of them has.
std::vector<int> outlineOf(std::span<const std::array<int, 3>> triangles) {
    std::map<int, int> next;
    std::map<std::array<int, 2>, int> seen;
    for (const auto& t : triangles)
        for (int k = 0; k < 3; ++k) ++seen[{t[k], t[(k + 1) % 3]}];
    for (const auto& [edge, count] : seen)
        if (!seen.contains({edge[1], edge[0]})) next[edge[0]] = edge[1];
    std::vector<int> outline;
    for (int v = next.begin()->first; outline.size() < next.size(); v = next[v])
        outline.push_back(v);
    return outline;
}

}  // namespace

Convex convexOf(std::span<const Vec<double>> positions,
                std::span<const std::array<int, 3>> triangles, const Vec<double>& centre,
                const std::string& name) {
    Convex convex;
    for (const Vec<double>& x : positions) {
        convex.corners.push_back(x - centre);
        convex.radius = std::max(convex.radius, length(x - centre));
    }
    const double wrong = flat * convex.radius;
    std::vector<std::vector<std::array<int, 3>>> parts;
    for (const auto& t : triangles) {
        const Vec<double> normal = normalOf(convex.corners, t);
        const double height = dot(normal, convex.corners[t[0]]);
        for (const Vec<double>& x : convex.corners)
            if (dot(normal, x) > height + wrong)
                throw std::invalid_argument(name + ": it is not convex");
        std::size_t f = 0;
        while (f < convex.faces.size() &&
               std::ranges::any_of(
                   t,
                   [&](int v) {
                       return std::fabs(dot(convex.faces[f].normal, convex.corners[v]) -
                                        convex.faces[f].height) > wrong;
                   }))
            ++f;
        if (f == convex.faces.size()) {
            convex.faces.push_back({normal, height, {}});
            parts.emplace_back();
        }
        parts[f].push_back(t);
    }
    std::map<std::array<int, 2>, int> left;
    for (std::size_t f = 0; f < parts.size(); ++f) {
        std::vector<int>& corners = convex.faces[f].corners;
        corners = outlineOf(parts[f]);
        for (std::size_t i = 0; i < corners.size(); ++i)
            left[{corners[i], corners[(i + 1) % corners.size()]}] = static_cast<int>(f);
    }
    for (const auto& [ends, face] : left) {
        if (ends[0] > ends[1]) continue;
        const Vec<double> along = convex.corners[ends[1]] - convex.corners[ends[0]];
        convex.edges.push_back(
            {ends, {face, left.at({ends[1], ends[0]})}, divide(1.0, length(along)) * along});
    }
    return convex;
}

double Convex::lowest(const Pose& pose, const Vec<double>& direction) const {
    const Vec<double> own = pose.turn.back(direction);
    double least = dot(own, corners[0]);
    for (const Vec<double>& x : corners) least = std::min(least, dot(own, x));
    return least + dot(direction, pose.centre);
}

void Placed::put(const Convex& convex, const Pose& pose) {
    shape = &convex;
    corners.resize(convex.corners.size());
    normals.resize(convex.faces.size());
    along.resize(convex.edges.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = pose.centre + pose.turn * convex.corners[i];
    for (std::size_t i = 0; i < normals.size(); ++i)
        normals[i] = pose.turn * convex.faces[i].normal;
    for (std::size_t i = 0; i < along.size(); ++i) along[i] = pose.turn * convex.edges[i].along;
}

double Placed::lowest(const Vec<double>& direction) const {
    double least = dot(direction, corners[0]);
    for (const Vec<double>& x : corners) least = std::min(least, dot(direction, x));
    return least;
}

}  // namespace plait
