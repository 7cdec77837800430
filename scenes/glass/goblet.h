// A wine glass, as lumps that are to be cut: plates along its bowl and its foot, and a stem.
#pragma once

#include <plait/patterns/solid_pattern.h>

#include <cstdint>
#include <vector>

namespace plait {

struct Goblet {
    double spacing = 0.008;  // m, of sites along its walls
    std::uint64_t seed = 1;
    Vec<double> foot{};  // m, the middle of what it stands on
};

// 155 mm high, 76 mm wide, about an axis along y.
std::vector<Lump> lumpsOf(const Goblet& goblet);

}  // namespace plait
