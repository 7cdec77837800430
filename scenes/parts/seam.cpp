#include "seam.h"

#include <plait/numbers/elementary.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace plait {

namespace {

Vec<double> unit(const Vec<double>& a) { return divide(1.0, length(a)) * a; }

// The first harmonics of a closed line.
std::vector<Vec<double>> smoothed(const std::vector<Vec<double>>& line) {
    constexpr int harmonics = 5;
    const auto n = static_cast<int>(line.size());
    std::vector<Vec<double>> smooth(line.size(), Vec<double>{});
    for (int k = 0; k <= harmonics; ++k) {
        Vec<double> even{}, odd{};
        const double weight = (k ? 2.0 : 1.0) / n;
        for (int i = 0; i < n; ++i) {
            even += weight * cosine(2 * std::numbers::pi * k * i / n) * line[i];
            odd += weight * sine(2 * std::numbers::pi * k * i / n) * line[i];
        }
        for (int i = 0; i < n; ++i)
            smooth[i] += cosine(2 * std::numbers::pi * k * i / n) * even +
                         sine(2 * std::numbers::pi * k * i / n) * odd;
    }
    return smooth;
}

// Sums of the lengths before each part of a closed line, and all.
template <class Length>
std::vector<double> along(std::size_t n, const Length& length) {
    std::vector<double> sums{0};
    for (std::size_t i = 0; i < n; ++i) sums.push_back(sums.back() + length(i, (i + 1) % n));
    return sums;
}

// Which part of it s lies in, from 0, and how far into that.
double placeOf(double s, const std::vector<double>& sums) {
    const auto after = std::upper_bound(sums.begin() + 1, sums.end() - 1, s);
    return static_cast<double>(after - sums.begin() - 1) +
           (s - *(after - 1)) / (*after - *(after - 1));
}

}  // namespace

Seam::Seam(MovingSurface surface, const Frame& frame, double clearance, double flare, int points)
    : surface_(std::move(surface)), clearance_(clearance) {
    const std::vector<Place> section = sectionOf(frame);
    const std::vector<Vec<double>> line = above(section, 0);
    const std::vector<double> lengths =
        along(line.size(), [&](std::size_t i, std::size_t j) { return length(line[j] - line[i]); });
    const auto at = [&](double part) {
        const double place = placeOf(part * lengths.back(), lengths);
        const auto i = static_cast<std::size_t>(place);
        return between(section[i], section[(i + 1) % section.size()], place - double(i));
    };

    const std::size_t samples = 4 * static_cast<std::size_t>(points);
    std::vector<Place> even;
    for (std::size_t i = 0; i < samples; ++i) even.push_back(at(double(i) / double(samples)));
    const std::vector<Vec<double>> x = above(even, 0);
    std::vector<Vec<double>> out;
    for (std::size_t i = 0; i < samples; ++i)
        out.push_back(unit(cross(frame.up, x[(i + 1) % samples] - x[(i + samples - 1) % samples])));
    out = smoothed(out);
    for (Vec<double>& direction : out) direction = unit(direction);
    const std::vector<double> flared = along(samples, [&](std::size_t i, std::size_t j) {
        return length(x[j] - x[i]) + flare * length(out[j] - out[i]);
    });
    for (int i = 0; i < points; ++i) {
        const double place = placeOf(flared.back() * i / points, flared);
        const auto k = static_cast<std::size_t>(place);
        const double part = place - double(k);
        places_.push_back(at(place / double(samples)));
        outwards_.push_back(unit((1 - part) * out[k] + part * out[(k + 1) % samples]));
    }
}

// Of two places on edges of one triangle.
Seam::Place Seam::between(const Place& a, const Place& b, double part) {
    return {{a.corner[0], a.corner[1], b.corner[0], b.corner[1]},
            {(1 - part) * a.weight[0], (1 - part) * a.weight[1], part * b.weight[0],
             part * b.weight[1]}};
}

std::vector<Vec<double>> Seam::at(double t) const { return above(places_, t); }

// Goes from triangle to triangle through the edges that the plane cuts, those that a triangle
// itself goes down.
std::vector<Seam::Place> Seam::sectionOf(const Frame& frame) const {
    const std::vector<Vec<double>> x = surface_.positions(0);
    const auto height = [&](int v) { return dot(x[v] - frame.origin, frame.up); };
    std::map<std::pair<int, int>, std::pair<int, int>> downAfter;  // by the edge that goes down
    for (const auto& triangle : surface_.triangles) {
        std::pair<int, int> up{-1, -1}, down{-1, -1};
        for (int i = 0; i < 3; ++i) {
            const int a = triangle[i], b = triangle[(i + 1) % 3];
            if (height(a) < 0 && height(b) >= 0) up = {b, a};
            if (height(a) >= 0 && height(b) < 0) down = {a, b};
        }
        if (up.first >= 0) downAfter[up] = down;
    }
    std::vector<Place> nearest;
    double least = std::numeric_limits<double>::infinity();
    while (!downAfter.empty()) {
        std::vector<Place> line;
        Vec<double> sum{};
        const auto first = downAfter.begin()->first;
        auto edge = first;
        for (auto next = downAfter.find(edge); next != downAfter.end();
             next = downAfter.find(edge)) {
            const auto [a, b] = edge;
            const double part = height(a) / (height(a) - height(b));
            line.push_back({{a, b, a, a}, {1 - part, part, 0, 0}});
            sum += (1 - part) * x[a] + part * x[b];
            edge = next->second;
            downAfter.erase(next);
        }
        const double distance = length(divide(1.0, double(line.size())) * sum - frame.origin);
        if (edge != first || distance >= least) continue;
        least = distance;
        nearest = std::move(line);
    }
    if (nearest.empty()) throw std::invalid_argument("seam: the plane cuts no closed line");
    const auto out = [&](const Place& place) {
        return dot(place.weight[0] * x[place.corner[0]] + place.weight[1] * x[place.corner[1]],
                   frame.across);
    };
    std::ranges::rotate(nearest, std::ranges::max_element(nearest, {}, out));
    return nearest;
}

std::vector<Vec<double>> Seam::above(const std::vector<Place>& places, double t) const {
    const std::vector<Vec<double>> x = surface_.positions(t);
    std::vector<Vec<double>> normals(x.size(), Vec<double>{});
    for (const auto& [a, b, c] : surface_.triangles) {
        const Vec<double> normal = cross(x[b] - x[a], x[c] - x[a]);
        for (const int v : {a, b, c}) normals[v] += normal;
    }
    std::vector<Vec<double>> points;
    for (const auto& [corner, weight] : places) {
        Vec<double> point{}, out{};
        for (int i = 0; i < 4; ++i)
            point += weight[i] * x[corner[i]], out += weight[i] * normals[corner[i]];
        points.push_back(point + clearance_ / length(out) * out);
    }
    return points;
}

}  // namespace plait
