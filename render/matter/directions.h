// Directions that are there even where what gives them vanishes.
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace plait {

inline glm::vec3 unit(const glm::vec3& v, const glm::vec3& otherwise) {
    const float l = glm::length(v);
    return l > 1e-20f ? v / l : otherwise;
}

// Of length 1, across t, which is so too.
inline glm::vec3 anyAcross(const glm::vec3& t) {
    const glm::vec3 axis = std::abs(t.y) < 0.9f ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0};
    return glm::normalize(axis - t * glm::dot(axis, t));
}

}  // namespace plait
