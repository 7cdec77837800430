// Primitives without order, moving: what a broad phase may meet.
#pragma once

#include "tests/random.h"

#include <plait/collision/kdop.h>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace plait::test {

// Primitives of three vertices, some of which coincide: edges and points.
struct Soup {
    std::string name;
    std::vector<Vec<double>> start = {}, end = {};
    std::vector<int> ids = {};
    double radius = 0;
    Vec<double> origin{};

    int count() const { return static_cast<int>(ids.size()) / 3; }
    template <int k>
    auto bounds() const {
        return [this](int i) {
            return sweptBounds<k>(std::span(ids).subspan(3 * std::size_t(i), 3),
                                  {start, end, radius, origin});
        };
    }
    // Apart where they start and where they end.
    template <int k>
    auto movingBounds() const {
        return [this](int i) {
            const auto at = [&](const std::vector<Vec<double>>& x) {
                return sweptBounds<k>(std::span(ids).subspan(3 * std::size_t(i), 3),
                                      {x, x, radius, origin});
            };
            return MovingKDop<k>{at(start), at(end)};
        };
    }
    void add(const std::array<Vec<double>, 3>& from, const std::array<Vec<double>, 3>& to) {
        for (int c = 0; c < 3; ++c) {
            ids.push_back(static_cast<int>(start.size()));
            start.push_back(from[c]);
            end.push_back(to[c]);
        }
    }
};

// Triangles of `size` about places that `place` gives, which move by up to `motion`.
template <class Place>
Soup soup(const std::string& name, int n, double size, double motion, double radius, Place place) {
    Soup s{.name = name, .radius = radius};
    Random random(5);
    for (int i = 0; i < n; ++i) {
        const Vec<double> at = place(random), by = random.point(motion);
        std::array<Vec<double>, 3> from, to;
        for (int c = 0; c < 3; ++c) {
            from[c] = at + random.point(size);
            to[c] = from[c] + by + random.point(motion / 4);
        }
        if (i % 5 == 0) from[1] = from[0], to[1] = to[0];   // an edge
        if (i % 10 == 0) from[2] = from[0], to[2] = to[0];  // a point
        s.add(from, to);
    }
    return s;
}

// Of n primitives or a fraction, each for a difficulty of its own.
inline std::vector<Soup> soups(int n) {
    const auto anywhere = [](Random& r) { return r.point(1); };
    const auto clusters = [](Random& r) {
        Vec<double> sum = 3.0 * r.below(4) * Vec<double>{1, 1, 0};
        for (int i = 0; i < 4; ++i) sum += r.point(0.1);
        return sum;
    };
    const auto lattice = [](Random& r) {
        return Vec<double>{double(r.below(8)), double(r.below(8)), double(r.below(8))};
    };
    std::vector<Soup> all{
        soup("swept", n, 0.06, 0.1, 0.005, anywhere),
        soup("static", n, 0.06, 0, 0.005, anywhere),
        soup("zero thickness", n / 4, 0.1, 0.1, 0, anywhere),
        soup("particles", n / 4, 0, 0.05, 0.03, anywhere),
        soup("clustered", n / 4, 0.03, 0.03, 0.001, clusters),
        soup("equal", n / 16, 0, 0, 0, [](Random&) { return Vec<double>{1, 2, 3}; }),
        soup("lattice", n / 4, 0, 0, 0, lattice),
        soup("thick lattice", n / 4, 0, 0, 0.5, lattice)};
    for (int c = 0; c < static_cast<int>(all[6].start.size()); ++c)  // edges along it
        all[6].end[c].x += c % 3;
    Soup mixed = all[4], far = all[0];
    mixed.name = "clustered, large ones among them";
    for (int i = 0; i < mixed.count(); i += 50) mixed.start[3 * i] += {3, 7, 4};
    far.name = "1e6 m away";
    for (auto* x : {&far.start, &far.end})
        for (Vec<double>& p : *x) p += {1e6, -1e6, 1e6};
    Soup coarse = far;
    far.origin = far.start[0];
    coarse.name += ", seen from 0";
    coarse.ids.resize(3 * (n / 16));
    all.insert(all.end(), {mixed, far, coarse});
    return all;
}

}  // namespace plait::test
