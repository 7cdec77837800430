#include "camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <stdexcept>

namespace plait {
namespace {

using Numbers = std::array<double, 8>;

Numbers numbers(const Camera& c) {
    return {c.eye.x, c.eye.y, c.eye.z, c.target.x, c.target.y, c.target.z, c.focalLength, c.across};
}

// Rate of change of number k at pose i: of the parabola through its neighbours; 0 at the ends.
double slope(std::span<const Camera> cameras, std::size_t i, std::size_t k) {
    if (i == 0 || i + 1 == cameras.size()) return 0;
    const auto rate = [&](std::size_t j) {
        return (numbers(cameras[j + 1])[k] - numbers(cameras[j])[k]) /
               (cameras[j + 1].time - cameras[j].time);
    };
    const double before = cameras[i].time - cameras[i - 1].time;
    const double after = cameras[i + 1].time - cameras[i].time;
    return (after * rate(i - 1) + before * rate(i)) / (before + after);
}

Numbers between(std::span<const Camera> cameras, double t) {
    std::size_t i = 0;
    while (i + 1 < cameras.size() && cameras[i + 1].time <= t) ++i;
    if (t <= cameras[0].time || i + 1 == cameras.size()) return numbers(cameras[i]);
    const double h = cameras[i + 1].time - cameras[i].time, s = (t - cameras[i].time) / h;
    const Numbers a = numbers(cameras[i]), b = numbers(cameras[i + 1]);
    Numbers result;
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] =
            (1 + 2 * s) * (1 - s) * (1 - s) * a[k] + s * s * (3 - 2 * s) * b[k] +
            h * s * (1 - s) * ((1 - s) * slope(cameras, i, k) - s * slope(cameras, i + 1, k));
    return result;
}

}  // namespace

CameraPose poseAt(std::span<const Camera> cameras, double t) {
    if (cameras.empty()) throw std::invalid_argument("view: has no camera");
    const Numbers n = between(cameras, t);
    return {glm::vec3(n[0], n[1], n[2]), glm::vec3(n[3], n[4], n[5]),
            static_cast<float>(2 * std::atan(10.125 / n[6])), static_cast<float>(n[7])};
}

glm::vec3 wayAt(const Follow& follow, double t) {
    if (!follow.point) return glm::vec3(0);
    // Weights that rise and fall smoothly, so that no corner of the way is seen.
    constexpr int steps = 24;
    Vec<double> sum{0, 0, 0};
    double weights = 0;
    for (int i = 0; i < steps; ++i) {
        const double s = (2 * i + 1.0) / steps - 1, w = (1 - s * s) * (1 - s * s);
        sum += w * (follow.point(t + s * follow.smoothing) - follow.home);
        weights += w;
    }
    return {sum.x / weights, sum.y / weights, sum.z / weights};
}

CameraPose poseOf(const View& view, double t) {
    CameraPose pose = poseAt(view.cameras, t);
    const glm::vec3 way = wayAt(view.follow, t);
    const auto part = [&](const Vec<double>& v) { return glm::vec3(v.x, v.y, v.z) * way; };
    pose.eye += part(view.follow.eye);
    pose.target += part(view.follow.target);
    return pose;
}

CameraPose CameraPose::framed(float aspect) const {
    CameraPose pose = *this;
    const float taller = across * (16.0f / 9) / aspect;
    if (taller > 1) pose.fieldOfView = 2 * std::atan(taller * std::tan(fieldOfView / 2));
    return pose;
}

glm::mat4 CameraPose::matrix(float aspect) const {
    const float distance = glm::length(target - eye);
    return glm::perspective(fieldOfView, aspect, 0.05f * distance, 20 * distance) *
           glm::lookAt(eye, target, glm::vec3(0, 1, 0));
}

}  // namespace plait
