// Gas that leaves through a hole, and what that does to the skin around it: a jet's thrust, and the
// mass of what is left.
#pragma once

#include "../gas/gas.h"
#include "../numbers/math.h"
#include "../state.h"

#include <array>
#include <vector>

namespace plait {

struct LeakOptions {
    // Triangles of the enclosure that are no matter, through which the gas leaves; empty: no leak.
    std::vector<std::array<int, 3>> hole;
    double opens = 0;        // s
    double discharge = 0.6;  // of a sharp edge: part of the hole that the jet fills
    double density = 1.2;    // kg/m^3, of the gas at the pressure outside; it does not warm or cool
    // m/s^2: what the world's gravity gives the gas inside, which the gas outside carries.
    Vec<double> gravity{0, -9.81, 0};
};

// The gas is as heavy as it is and rides on the skin, by area; it weighs nothing. At gauge pressure
// p it leaves by c rho A u, u = sqrt(2 p / rho) (Bernoulli; p far below the pressure outside), with
// the velocity of what it rode on, and pushes the rim of the hole by rho c A u^2 = 2 c p A. That is
// all: pressure acts on the hole's triangles as on all others, so that of itself it gives no force.
class Leak {
public:
    // `riding`: kg of gas on each vertex of the world when the hole opens, which is in `mass` (kg).
    Leak(LeakOptions options, const Gas& gas, std::vector<std::array<int, 3>> triangles,
         std::vector<double> riding, const std::vector<double>& mass);

    // What is kept: J of what is left, and what rounding lost of that.
    static constexpr int numbers = 2;
    template <class Real>
    static void keep(Real* kept, double amount) {
        kept[0] = static_cast<Real>(amount);
        kept[1] = static_cast<Real>(amount - double(kept[0]));
    }
    template <class Real>
    static double left(const Real* kept) {
        return double(kept[0]) + double(kept[1]);
    }
    // What leaves in the h seconds before t; until the hole opens there is `amount` (J).
    template <class Real>
    void settle(State<Real>& state, Real* kept, double amount, double t, double h) const;

private:
    template <class Real>
    void flow(State<Real>& state, Real* kept, double h) const;
    double joulesAKilogram() const { return gas_.outside / options_.density; }

    LeakOptions options_;
    Gas gas_;
    std::vector<std::array<int, 3>> triangles_;
    std::vector<double> riding_, skin_;  // kg, by vertex
    double all_ = 0;                     // J, when the hole opens
    std::vector<int> carriers_, rim_;    // vertices that gas rides on, and those of the hole
};

}  // namespace plait
