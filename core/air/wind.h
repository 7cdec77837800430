// Wind: how fast the air moves, where and when [AW2].
#pragma once

#include "../numbers/math.h"

#include <cstdint>
#include <functional>

namespace plait {

struct Wind {
    // m/s at time t (s), called once a substep (M 3.1.2) on one thread; none: still air.
    std::function<Vec<double>(double t)> velocity = {};
    double noise = 0;        // m/s, root mean square of each component of the gusts
    double noiseLength = 1;  // m, a gust's size
    double noiseTime = 1;    // s, a gust's life
    // m/s at which gusts travel, usually that of the mean wind (frozen turbulence, Taylor 1938).
    Vec<double> noiseDrift{0, 0, 0};
    std::uint64_t seed = 1;
};

}  // namespace plait
