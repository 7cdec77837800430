#include "rigid_chain.h"

#include "demos/tools/progress.h"
#include "runge_kutta.h"

#include <plait/numbers/elementary.h>

#include <stdexcept>

namespace plait {
namespace {

using Points = std::vector<Vec<double>>;

class RigidChain {
public:
    RigidChain(const World& world, const Vec<double>& gravity) : free_(world.start.size()) {
        for (std::size_t i = 0; i < free_.size(); ++i) {
            weight_.push_back(world.pinned[i] ? 0 : 1 / world.mass[i]);
            if (!world.pinned[i]) free_[i] = gravity;
            if (i > 0) rest_.push_back(length(world.rest[i] - world.rest[i - 1]));
        }
    }

    void step(Motions& at, double h) const {
        rungeKuttaStep(at, h, [&](const Motions& m) { return rate(m); });
        project(at);
    }

private:
    // Velocities and accelerations: each link keeps d.a = -|v|^2 of its ends' differences.
    Motions rate(const Motions& at) const {
        std::vector<double> residual;
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            const Vec<double> u = at.v[i + 1] - at.v[i];
            residual.push_back(dot(at.x[i + 1] - at.x[i], free_[i + 1] - free_[i]) + dot(u, u));
        }
        Motions rate{at.v, free_};
        pull(at.x, residual, rate.v);
        return rate;
    }

    void project(Motions& at) const {
        std::vector<double> residual(rest_.size());
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            const Vec<double> d = at.x[i + 1] - at.x[i];
            residual[i] = (dot(d, d) - rest_[i] * rest_[i]) / 2;
        }
        Points x = at.x;
        pull(at.x, residual, x);
        at.x = x;
        for (std::size_t i = 0; i < rest_.size(); ++i)
            residual[i] = dot(at.x[i + 1] - at.x[i], at.v[i + 1] - at.v[i]);
        pull(at.x, residual, at.v);
    }

    // Adds W J^T t to `what`, J W J^T t = -residual: row i of J is the link d_i.
    void pull(const Points& x, const std::vector<double>& residual, Points& what) const {
        const std::size_t n = rest_.size();
        std::vector<double> diagonal(n), beside(n), t(n);
        for (std::size_t i = 0; i < n; ++i) {
            const Vec<double> d = x[i + 1] - x[i];
            diagonal[i] = (weight_[i] + weight_[i + 1]) * dot(d, d);
            if (i + 1 < n) beside[i] = -weight_[i + 1] * dot(d, x[i + 2] - x[i + 1]);
            t[i] = -residual[i];
        }
        for (std::size_t i = 1; i < n; ++i) {
            const double factor = beside[i - 1] / diagonal[i - 1];
            diagonal[i] -= factor * beside[i - 1];
            t[i] -= factor * t[i - 1];
        }
        for (std::size_t i = n; i-- > 0;)
            t[i] = (t[i] - (i + 1 < n ? beside[i] * t[i + 1] : 0)) / diagonal[i];
        for (std::size_t i = 0; i < n; ++i) {
            const Vec<double> d = x[i + 1] - x[i];
            what[i] -= weight_[i] * t[i] * d;
            what[i + 1] += weight_[i + 1] * t[i] * d;
        }
    }

    std::vector<double> weight_, rest_;  // 1/kg, m
    Points free_;                        // m/s^2, without links
};

}  // namespace

Trajectory rigidChain(const World& world, const Vec<double>& gravity, double frameLength,
                      int frames, int stepsPerFrame) {
    if (world.start.size() < 2 || stepsPerFrame < 1)
        throw std::invalid_argument("a rigid chain needs a link and a step");
    const RigidChain chain(world, gravity);
    Motions at{world.start, world.velocity};
    Trajectory trajectory;
    for (int frame = 0; frame < frames; ++frame) {
        for (int i = 0; i < stepsPerFrame; ++i) chain.step(at, frameLength / stepsPerFrame);
        trajectory.push_back(at.x);
        frameSolved();
    }
    return trajectory;
}

Trajectory pendulumByAngle(const World& world, double g, double frameLength, int frames,
                           int stepsPerFrame) {
    const Vec<double> pin = world.start[0], arm = world.start[1] - pin;
    const double l = length(arm), h = frameLength / stepsPerFrame;
    // The angle and its rate.
    const auto rate = [&](Vec<double> z) { return Vec<double>{z.y, -g / l * sine(z.x), 0}; };
    Vec<double> z{arctangent2(arm.x, -arm.y), 0, 0};
    Trajectory trajectory;
    for (int frame = 0; frame < frames; ++frame) {
        for (int i = 0; i < stepsPerFrame; ++i) {
            const Vec<double> k1 = rate(z), k2 = rate(z + h / 2 * k1), k3 = rate(z + h / 2 * k2),
                              k4 = rate(z + h * k3);
            z += h / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        }
        trajectory.push_back({pin, pin + l * Vec<double>{sine(z.x), -cosine(z.x), 0}});
        frameSolved();
    }
    return trajectory;
}

}  // namespace plait
