// Lists of integers of different lengths, end to end: list i is item[start[i]] .. item[start[i +
// 1]].
#pragma once

#include <span>
#include <vector>

namespace plait {

struct Csr {
    std::vector<int> start{0};
    std::vector<int> item;

    int size() const { return static_cast<int>(start.size()) - 1; }

    std::span<const int> operator[](int i) const {
        return std::span(item).subspan(start[i], start[i + 1] - start[i]);
    }
};

}  // namespace plait
