// By how much a surface has grown about its vertices.
#pragma once

#include <plait/numbers/math.h>

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <vector>

namespace plait {

class AreaStretch {
public:
    AreaStretch() = default;
    // `rest` (m) has a position for each vertex.
    AreaStretch(std::span<const std::array<int, 3>> triangles, std::span<const Vec<double>> rest);

    // The area of the triangles about each vertex over that at rest; 1 where there was none.
    void measure(std::span<const glm::vec3> positions, std::vector<float>& stretch) const;

private:
    std::vector<std::array<int, 3>> triangles_;
    std::vector<float> perArea_;  // 1/m^2, by vertex; 0: none
};

}  // namespace plait
