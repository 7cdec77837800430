#include "wire_path.h"

#include "directions.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr float tiny = 1e-20f;  // m^2

// Mirrors once in the plane between two points and once in that between their tangents: the frame
// that turns least (Wang et al., Computation of Rotation Minimizing Frames, 2008).
glm::vec3 carried(const glm::vec3& normal, const WirePoint& from, const WirePoint& to) {
    const glm::vec3 way = to.place - from.place;
    const float l2 = glm::dot(way, way);
    glm::vec3 n = normal, t = from.tangent;
    if (l2 > tiny) {
        n -= 2 / l2 * glm::dot(way, n) * way;
        t -= 2 / l2 * glm::dot(way, t) * way;
    }
    const glm::vec3 turn = to.tangent - t;
    const float turn2 = glm::dot(turn, turn);
    if (turn2 > tiny) n -= 2 / turn2 * glm::dot(turn, n) * turn;
    return unit(n - to.tangent * glm::dot(n, to.tangent), anyAcross(to.tangent));
}

class Path {
public:
    Path(std::span<const glm::vec3> points, bool closed, int steps)
        : points_(points),
          n_(static_cast<int>(points.size())),
          links_(closed ? n_ : n_ - 1),
          steps_(steps),
          closed_(closed) {}

    std::vector<WirePoint> curve() const {
        std::vector<WirePoint> path;
        for (int i = 0; i < links_; ++i)
            for (int k = 0; k < steps_; ++k) path.push_back(at(i, k));
        if (!closed_) path.push_back(at(links_ - 1, steps_));
        return path;
    }

    // The director of each point of the path, from one by link.
    void turn(std::vector<WirePoint>& path, std::span<const glm::vec3> directors) const {
        path[0].director = anyAcross(path[0].tangent);
        for (std::size_t i = 1; i < path.size(); ++i)
            path[i].director = carried(path[i - 1].director, path[i - 1], path[i]);
        std::vector<float> angles;
        float round = 0;
        if (!directors.empty()) angles = measured(path, directors);
        if (closed_) round = closing(path, angles);
        if (angles.empty() && round == 0) return;
        for (WirePoint& p : path) {
            const float a = between(angles, round, p.link - 0.5f);
            p.director = std::cos(a) * p.director + std::sin(a) * glm::cross(p.tangent, p.director);
        }
    }

private:
    const glm::vec3& point(int i) const { return points_[(i + n_) % n_]; }
    glm::vec3 edge(int i) const { return point(i + 1) - point(i); }

    // dx / ds at a point, s the length of the polygon.
    glm::vec3 slope(int i) const {
        if (!closed_ && n_ == 2) return unit(edge(0), {1, 0, 0});
        if (!closed_ && i == 0) return 2.0f * perLength(edge(0)) - slope(1);
        if (!closed_ && i == n_ - 1) return 2.0f * perLength(edge(i - 1)) - slope(i - 1);
        const glm::vec3 in = edge(i - 1), out = edge(i);
        const float a = glm::length(in), b = glm::length(out);
        return (b * perLength(in) + a * perLength(out)) / std::max(a + b, 1e-12f);
    }
    static glm::vec3 perLength(const glm::vec3& v) { return v / std::max(glm::length(v), 1e-12f); }

    WirePoint at(int i, int k) const {
        const float s = static_cast<float>(k) / static_cast<float>(steps_), r = 1 - s;
        const glm::vec3 &a = point(i), &b = point(i + 1);
        const float l = glm::length(b - a);
        const glm::vec3 u = l * slope(i), v = l * slope((i + 1) % n_);
        const glm::vec3 along = 6 * s * r * (b - a) + r * (r - 2 * s) * u + s * (s - 2 * r) * v;
        return {
            .place = r * r * (1 + 2 * s) * a + s * s * (3 - 2 * s) * b + s * r * (r * u - s * v),
            .tangent = unit(along, unit(b - a, {1, 0, 0})),
            .link = static_cast<float>(i) + s};
    }

    int middle(int link) const { return link * steps_ + steps_ / 2; }

    // By how much the director of each link is ahead of the frame that is carried along; each
    // angle within half a turn of the one before.
    std::vector<float> measured(const std::vector<WirePoint>& path,
                                std::span<const glm::vec3> directors) const {
        std::vector<float> angles;
        for (int i = 0; i < links_; ++i) {
            const WirePoint& p = path[middle(i)];
            const float x = glm::dot(directors[i], p.director),
                        y = glm::dot(directors[i], glm::cross(p.tangent, p.director));
            const float before = i > 0 ? angles.back() : 0;
            angles.push_back(x * x + y * y > tiny ? nearest(std::atan2(y, x), before) : before);
        }
        return angles;
    }

    // By how much the angles have grown when the curve has come round.
    float closing(const std::vector<WirePoint>& path, const std::vector<float>& angles) const {
        // From the seam on the carried frame is that of the start, turned by one angle.
        const WirePoint& first = path[0];
        const glm::vec3 n = carried(path.back().director, path.back(), first);
        const float off = std::atan2(glm::dot(first.director, glm::cross(first.tangent, n)),
                                     glm::dot(first.director, n));
        if (angles.empty()) return off;
        return nearest(angles.front() + off, angles.back()) - angles.front();
    }

    static float nearest(float angle, float to) {
        return angle - glm::two_pi<float>() * std::round((angle - to) / glm::two_pi<float>());
    }

    // Catmull-Rom over the angles, in links from the middle of the first.
    float between(const std::vector<float>& angles, float round, float x) const {
        if (angles.empty()) return round * (x + 0.5f) / static_cast<float>(links_);
        const auto angle = [&](int i) {
            if (closed_)
                return angles[(i + links_) % links_] + (i < 0         ? -round
                                                        : i >= links_ ? round
                                                                      : 0.0f);
            const int last = links_ - 1;
            if (i < 0)
                return angles[0] + static_cast<float>(i) * (last > 0 ? angles[1] - angles[0] : 0);
            if (i > last)
                return angles[last] + static_cast<float>(i - last) *
                                          (last > 0 ? angles[last] - angles[last - 1] : 0);
            return angles[i];
        };
        const int i = static_cast<int>(std::floor(x));
        const float s = x - static_cast<float>(i);
        const float a = angle(i - 1), b = angle(i), c = angle(i + 1), d = angle(i + 2);
        return 0.5f *
               (2 * b + s * (c - a + s * (2 * a - 5 * b + 4 * c - d + s * (3 * (b - c) + d - a))));
    }

    std::span<const glm::vec3> points_;
    int n_, links_, steps_;
    bool closed_;
};

}  // namespace

std::vector<WirePoint> wirePath(std::span<const glm::vec3> points,
                                std::span<const glm::vec3> directors, bool closed, int steps) {
    const Path path(points, closed, steps);
    std::vector<WirePoint> result = path.curve();
    path.turn(result, directors);
    return result;
}

}  // namespace plait
