// Loop's subdivision, once: each fine vertex is a fixed weighted sum of coarse ones, so that a
// frame costs one pass over a table (Loop, Smooth Subdivision Surfaces Based on Triangles, 1987;
// interior weights of Warren 1995).
#pragma once

#include <plait/numbers/math.h>

#include <array>
#include <span>
#include <vector>

namespace plait {

class Subdivision {
public:
    Subdivision() = default;
    // Borders become smooth curves; border vertices where `rest` turns by more than 50 degrees stay
    // as they are, and so does what lies on an edge of three triangles or more. Without `refined`
    // vertices go to the same places, but none are added.
    Subdivision(std::span<const std::array<int, 3>> triangles, std::span<const Vec<double>> rest,
                bool refined = true);

    // Nothing is smoothed: a fine vertex for each side of a sharp edge (from 40 degrees on), in its
    // place.
    static Subdivision facets(std::span<const std::array<int, 3>> triangles,
                              std::span<const Vec<double>> rest);

    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
    int size() const { return static_cast<int>(start_.size()) - 1; }  // fine vertices

    // Anything with sums and products by float. Of what is smoothed, coarse vertices come first, in
    // their order.
    template <class T>
    void apply(std::span<const T> coarse, std::vector<T>& fine) const {
        fine.resize(static_cast<std::size_t>(size()));
        for (int i = 0; i < size(); ++i) {
            T sum{};
            for (int k = start_[i]; k < start_[i + 1]; ++k) sum += weight_[k] * coarse[vertex_[k]];
            fine[i] = sum;
        }
    }

private:
    void add(std::span<const int> vertices, std::span<const float> weights);

    std::vector<std::array<int, 3>> triangles_;
    std::vector<int> start_{0}, vertex_;
    std::vector<float> weight_;
};

}  // namespace plait
