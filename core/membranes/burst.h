// Gas whose skin may come apart: it leaves through the openings of the tears.
#pragma once

#include "../gas/gas.h"
#include "../numbers/math.h"
#include "../state.h"

#include <array>
#include <vector>

namespace plait {

// Each opening is closed by a fan over its rim, which counts for the volume and bears no pressure:
// at gauge pressure p the gas leaves by c rho A sqrt(2 p / rho) (Bernoulli), with its momentum. Its
// mass is left out.
class Burst {
public:
    // The skin by its present names, caps included.
    Burst(const Gas& gas, const std::vector<std::array<int, 3>>& skin);

    bool open() const { return !fans_.empty(); }
    const std::vector<std::vector<std::array<int, 3>>>& fans() const { return fans_; }

    // What is kept: J of what is left, as Leak keeps it.
    template <class Real>
    void settle(const State<Real>& state, Real* kept, double amount, double h) const;

private:
    static constexpr double discharge = 0.6;  // of a sharp edge
    static constexpr double density = 1.2;    // kg/m^3, at the pressure outside

    Gas gas_;
    std::vector<std::array<int, 3>> skin_;
    std::vector<std::vector<std::array<int, 3>>> fans_;  // by opening
};

}  // namespace plait
