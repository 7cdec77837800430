// Sums of elements of one kind as plain data, in double: the volume inside a skin is one over its
// triangles, the length of a band one over its edges.
#pragma once

#include "../constraints/rows.h"
#include "../world.h"

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace plait {

// What holds C, the sum of its elements: with f the force along its gradient (multiplier / h^2),
// softness (f - load) + stiffness (C - rest) = 0. Neither is negative; softness 0 is rigid,
// stiffness 0 a steady load.
struct SumLaw {
    double rest = 0;  // of C
    double load = 0;  // of f; what it is at rest
    double softness = 0;
    double stiffness = 1;
};

template <class Kind>
struct Sums {
    Rows<Kind> elements;  // those of a sum one after another; nothing asks for their compliance
    std::vector<int> start{0};  // by sum and one more: its first element
    std::vector<SumLaw> laws;   // by sum
    // If there is one it is asked for the law of each sum in each substep: C where that begins and
    // its end t (s). A function of these alone.
    std::function<SumLaw(int sum, double value, double t)> law{};

    int size() const { return static_cast<int>(laws.size()); }
    void add(const Rows<Kind>& of, const SumLaw& held) {
        elements.ids.insert(elements.ids.end(), of.ids.begin(), of.ids.end());
        elements.rows.insert(elements.rows.end(), of.rows.begin(), of.rows.end());
        start.push_back(elements.size());
        laws.push_back(held);
    }
};

// Throws std::invalid_argument, naming the set, for what is not sound in a world of as many
// vertices.
template <class Kind>
void checkSums(const std::string& name, const Sums<Kind>& sums, std::size_t vertices) {
    checkRows(name, sums.elements, vertices);
    for (const auto& [rest, load, softness, stiffness] : sums.laws) {
        checkNumbers(name, std::array{rest, load, softness, stiffness});
        if (softness < 0 || stiffness < 0 || !(softness + stiffness > 0))
            throw std::invalid_argument(
                name + ": softness and stiffness of a sum are 0 or more, and one of them is more");
    }
}

}  // namespace plait
