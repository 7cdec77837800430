// A camera between the poses of a view.
#pragma once

#include "scenes/view.h"

#include <glm/glm.hpp>

#include <span>

namespace plait {

struct CameraPose {
    glm::vec3 eye, target;  // m
    float fieldOfView;      // vertical, radians
    float across = 1;       // of the width of a picture of 16:9: what a narrower one keeps

    glm::vec3 forward() const { return glm::normalize(target - eye); }
    // Of a picture of this width over its height, whose field may have to be higher.
    CameraPose framed(float aspect) const;
    glm::mat4 matrix(float aspect) const;  // world to clip
};

// The pose at time t (s): cubic Hermite through the poses, at rest in the first and the last, so
// that two poses give a smooth step; before and after them it stands still. Times must ascend.
// Throws std::invalid_argument if there is no pose.
CameraPose poseAt(std::span<const Camera> cameras, double t);

// How far the point that the camera follows is from its home at time t (s), averaged; m.
glm::vec3 wayAt(const Follow& follow, double t);
// The pose at time t with what it follows.
CameraPose poseOf(const View& view, double t);

}  // namespace plait
