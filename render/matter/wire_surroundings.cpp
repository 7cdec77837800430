#include "wire_surroundings.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr float mostCells = 1 << 20;

// Whether a link leads from one to the next.
bool joined(const WireStation& a, const WireStation& b) { return a.wire == b.wire; }

// Cells of one size around points, that sparse and long curves fill.
struct Cells {
    Cells(std::span<const WireStation> stations, float wanted) {
        glm::vec3 high(-1e30f);
        low = glm::vec3(1e30f);
        for (const WireStation& s : stations) {
            low = glm::min(low, s.place);
            high = glm::max(high, s.place);
        }
        for (size = wanted;; size *= 1.26f) {
            const glm::vec3 n = glm::floor((high - low) / size) + 5.0f;
            if (n.x * n.y * n.z > mostCells) continue;
            count = n;
            low -= 2 * size;
            return;
        }
    }
    // In cells from the low corner.
    glm::vec3 place(const glm::vec3& p) const { return (p - low) / size; }
    int index(const glm::ivec3& c) const { return (c.z * count.y + c.y) * count.x + c.x; }
    bool inside(const glm::ivec3& c) const {
        return glm::all(glm::greaterThanEqual(c, glm::ivec3(0))) &&
               glm::all(glm::lessThan(c, count));
    }
    int total() const { return count.x * count.y * count.z; }

    glm::vec3 low;
    float size;  // m
    glm::ivec3 count;
};

// Part of a wire's projection that lies in each cell, 1/m; blended between cells.
class Smoke {
public:
    Smoke(std::span<const WireStation> stations, float width, float size)
        : cells_(stations, size), density_(static_cast<std::size_t>(cells_.total())) {
        const float volume = cells_.size * cells_.size * cells_.size;
        for (std::size_t i = 1; i < stations.size(); ++i) {
            const WireStation &a = stations[i - 1], &b = stations[i];
            if (!joined(a, b)) continue;
            const float l = b.length - a.length;
            const int parts = 1 + static_cast<int>(2 * l / cells_.size);
            for (int k = 0; k < parts; ++k)
                add(glm::mix(a.place, b.place,
                             (static_cast<float>(k) + 0.5f) / static_cast<float>(parts)),
                    l * width / (volume * static_cast<float>(parts)));
        }
    }

    float size() const { return cells_.size; }

    float at(const glm::vec3& p) const {
        float sum = 0;
        around(p, [&](int cell, float weight) { sum += weight * density_[cell]; });
        return sum;
    }

private:
    void add(const glm::vec3& p, float amount) {
        around(p, [&](int cell, float weight) { density_[cell] += weight * amount; });
    }

    template <class Visit>
    void around(const glm::vec3& p, const Visit& visit) const {
        const glm::vec3 place = cells_.place(p) - 0.5f, floor = glm::floor(place),
                        s = place - floor;
        const glm::ivec3 c(floor);
        if (!cells_.inside(c) || !cells_.inside(c + 1)) return;
        const int first = cells_.index(c), row = cells_.count.x, layer = row * cells_.count.y;
        for (int k = 0; k < 8; ++k) {
            const float weight =
                (k & 1 ? s.x : 1 - s.x) * (k & 2 ? s.y : 1 - s.y) * (k & 4 ? s.z : 1 - s.z);
            visit(first + (k & 1) + (k & 2) / 2 * row + (k & 4) / 4 * layer, weight);
        }
    }

    Cells cells_;
    std::vector<float> density_;
};

constexpr int rays = 32;

std::array<glm::vec3, rays> sphereOfRays() {
    std::array<glm::vec3, rays> directions;
    for (int i = 0; i < rays; ++i) {
        const float y = 1 - (2 * static_cast<float>(i) + 1) / rays, r = std::sqrt(1 - y * y);
        const float a = 2.39996323f * static_cast<float>(i);  // the golden angle
        directions[static_cast<std::size_t>(i)] = {r * std::cos(a), y, r * std::sin(a)};
    }
    return directions;
}

// Ever coarser: a ray widens as it goes.
std::vector<Smoke> smokes(std::span<const WireStation> stations, float width) {
    std::vector<Smoke> levels;
    for (const float widths : {2.0f, 4.0f, 8.0f})
        levels.emplace_back(stations, width, widths * width);
    return levels;
}

// Part of the light from there that is left.
float clear(std::span<const Smoke> levels, const glm::vec3& from, const glm::vec3& towards) {
    float depth = 0, way = 0;
    for (const Smoke& smoke : levels)
        for (int i = 0; i < 4; ++i) {
            depth += smoke.size() * smoke.at(from + (way + 0.5f * smoke.size()) * towards);
            way += smoke.size();
        }
    return std::exp(-depth);
}

// Of the light of the half sphere about `n`. Rays begin where the smoke of the surface itself ends.
float openTo(std::span<const Smoke> levels, const glm::vec3& p, const glm::vec3& n) {
    static const std::array<glm::vec3, rays> directions = sphereOfRays();
    const glm::vec3 from = p + 1.25f * levels[0].size() * n;
    float sum = 0, weights = 0;
    for (const glm::vec3& d : directions) {
        const float weight = glm::dot(d, n);
        if (weight <= 0) continue;
        sum += weight * clear(levels, from, d);
        weights += weight;
    }
    return sum / weights;
}

// Links by the cell of their middle, to look through those around a point.
class Buckets {
public:
    Buckets(std::span<const WireStation> stations, float reach)
        : cells_(stations, reach), start_(static_cast<std::size_t>(cells_.total()) + 1) {
        std::vector<int> at;
        for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
            if (!joined(stations[i], stations[i + 1])) continue;
            const glm::vec3 middle = 0.5f * (stations[i].place + stations[i + 1].place);
            at.push_back(cells_.index(glm::ivec3(cells_.place(middle))));
            links_.push_back(static_cast<int>(i));
            ++start_[at.back() + 1];
        }
        for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
        std::vector<int> next(start_.begin(), start_.end() - 1);
        order_.resize(links_.size());
        for (std::size_t i = 0; i < links_.size(); ++i) order_[next[at[i]]++] = links_[i];
    }

    template <class Visit>
    void near(const glm::vec3& p, const Visit& visit) const {
        const glm::ivec3 c(cells_.place(p));
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y) {
                const int first = cells_.index(c + glm::ivec3(-1, y, z));
                for (int k = start_[first]; k < start_[first + 3]; ++k) visit(order_[k]);
            }
    }

private:
    Cells cells_;
    std::vector<int> start_, links_, order_;
};

glm::vec3 nearestOn(const glm::vec3& a, const glm::vec3& b, const glm::vec3& p) {
    const glm::vec3 d = b - a;
    const float l2 = std::max(glm::dot(d, d), 1e-20f);
    return a + glm::clamp(glm::dot(p - a, d) / l2, 0.0f, 1.0f) * d;
}

// m, along the wire.
float apart(const WireStation& a, const WireStation& b) {
    if (a.wire != b.wire) return 1e30f;
    const float l = std::abs(a.length - b.length);
    return a.round > 0 ? std::min(l, a.round - l) : l;
}

float longestLink(std::span<const WireStation> stations) {
    float longest = 0;
    for (std::size_t i = 1; i < stations.size(); ++i)
        if (joined(stations[i - 1], stations[i]))
            longest = std::max(longest, stations[i].length - stations[i - 1].length);
    return longest;
}

bool nearer(const glm::vec3& a, const glm::vec3& b) {
    return b == glm::vec3(0) || glm::dot(a, a) < glm::dot(b, b);
}

Beside nearestTwo(std::span<const glm::vec3> found) {
    Beside beside{glm::vec3(0), glm::vec3(0)};
    for (const glm::vec3& off : found)
        if (nearer(off, beside[0])) beside[0] = off;
    for (const glm::vec3& off : found)
        if (glm::dot(off, beside[0]) < 0 && nearer(off, beside[1])) beside[1] = off;
    return beside;
}

}  // namespace

std::vector<Beside> besides(std::span<const WireStation> stations, float reach) {
    const float longest = longestLink(stations), far = reach + 0.5f * longest;
    const Buckets buckets(stations, far);
    std::vector<Beside> result;
    std::vector<glm::vec3> found;
    for (const WireStation& s : stations) {
        found.clear();
        buckets.near(s.place, [&](int j) {
            const WireStation &a = stations[j], &b = stations[j + 1];
            const glm::vec3 middle = 0.5f * (a.place + b.place) - s.place;
            if (glm::dot(middle, middle) > far * far) return;
            const glm::vec3 off = nearestOn(a.place, b.place, s.place) - s.place;
            const float way = glm::length(off);
            if (way > reach || std::min(apart(a, s), apart(b, s)) < 1.5f * way + longest) return;
            found.push_back(off - s.tangent * glm::dot(off, s.tangent));
        });
        Beside beside = nearestTwo(found);
        const auto i = result.size();
        if (i > 0 && joined(stations[i - 1], s) &&
            glm::dot(beside[0] - beside[1], result[i - 1][0] - result[i - 1][1]) < 0)
            std::swap(beside[0], beside[1]);
        result.push_back(beside);
    }
    return result;
}

float Openness::at(float x, float y) const {
    const float rest = std::max(1 - x * x - y * y, 0.0f);
    return x * x * sides[x > 0 ? 0 : 2] + y * y * sides[y > 0 ? 1 : 3] +
           rest / 4 * (sides[0] + sides[1] + sides[2] + sides[3]);
}

namespace {

Openness opennessAt(std::span<const Smoke> levels, const WireStation& s) {
    const glm::vec3 across = glm::cross(s.tangent, s.director);
    return {{openTo(levels, s.place, s.director), openTo(levels, s.place, across),
             openTo(levels, s.place, -s.director), openTo(levels, s.place, -across)}};
}

}  // namespace

Openness mix(const Openness& a, const Openness& b, float s) {
    Openness result;
    for (std::size_t k = 0; k < 4; ++k) result.sides[k] = glm::mix(a.sides[k], b.sides[k], s);
    return result;
}

std::vector<Openness> opennessOf(std::span<const WireStation> stations, float width) {
    const std::vector<Smoke> levels = smokes(stations, width);
    std::vector<Openness> result(stations.size());
    std::size_t last = 0;  // that was worked out; it is blended to the next
    for (std::size_t i = 0; i < stations.size(); ++i) {
        const bool first = i == 0 || !joined(stations[i - 1], stations[i]),
                   ends = i + 1 == stations.size() || !joined(stations[i], stations[i + 1]);
        const float way = first ? 0 : stations[i].length - stations[last].length;
        if (!first && !ends && way < 12 * width) continue;
        result[i] = opennessAt(levels, stations[i]);
        for (std::size_t k = last + 1; !first && k < i; ++k)
            result[k] =
                mix(result[last], result[i], (stations[k].length - stations[last].length) / way);
        last = i;
    }
    return result;
}

}  // namespace plait
