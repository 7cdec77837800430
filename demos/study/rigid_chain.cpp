#include "study/rigid_chain.h"

#include "elementary.h"

#include <stdexcept>

namespace plait {
namespace {

using Points = std::vector<Vec<double>>;

struct Motions {
    Points x, v;
};

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
        const Motions k1 = rate(at), k2 = rate(ahead(at, k1, h / 2)),
                      k3 = rate(ahead(at, k2, h / 2)), k4 = rate(ahead(at, k3, h));
        for (std::size_t i = 0; i < at.x.size(); ++i) {
            at.x[i] += (h / 6) * (k1.x[i] + 2.0 * k2.x[i] + 2.0 * k3.x[i] + k4.x[i]);
            at.v[i] += (h / 6) * (k1.v[i] + 2.0 * k2.v[i] + 2.0 * k3.v[i] + k4.v[i]);
        }
        project(at);
    }

private:
    static Motions ahead(const Motions& at, const Motions& k, double h) {
        Motions next = at;
        for (std::size_t i = 0; i < at.x.size(); ++i) {
            next.x[i] += h * k.x[i];
            next.v[i] += h * k.v[i];
        }
        return next;
    }

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
    }
    return trajectory;
}

Trajectory pendulumByAngle(const World& world, double g, double frameLength, int frames,
                           int stepsPerFrame) {
    const Vec<double> pin = world.start[0], arm = world.start[1] - pin;
    const double l = length(arm), h = frameLength / stepsPerFrame;
    const auto pull = [&](double angle) { return -g / l * sine(angle); };
    double a = arctangent2(arm.x, -arm.y), w = 0;
    Trajectory trajectory;
    for (int frame = 0; frame < frames; ++frame) {
        for (int i = 0; i < stepsPerFrame; ++i) {
            const double w1 = w, k1 = pull(a);
            const double w2 = w + h / 2 * k1, k2 = pull(a + h / 2 * w1);
            const double w3 = w + h / 2 * k2, k3 = pull(a + h / 2 * w2);
            const double w4 = w + h * k3, k4 = pull(a + h * w3);
            a += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
            w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        trajectory.push_back({pin, pin + l * Vec<double>{sine(a), -cosine(a), 0}});
    }
    return trajectory;
}

}  // namespace plait
