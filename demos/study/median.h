#pragma once

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace plait {

// The middle of them, or the mean of the two in the middle. Throws std::invalid_argument for none.
inline double median(std::vector<double> values) {
    if (values.empty()) throw std::invalid_argument("the median of nothing");
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

}  // namespace plait
