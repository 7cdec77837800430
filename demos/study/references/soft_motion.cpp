#include "soft_motion.h"

#include "demos/tools/progress.h"
#include "runge_kutta.h"

#include <plait/solver.h>

#include <stdexcept>

namespace plait {
namespace {

class SoftMotion {
public:
    SoftMotion(const World& world, const Vec<double>& gravity)
        : sets_(static_cast<int>(world.sets.size())),
          gravity_(gravity),
          solver_(world, {}),
          state_(solver_.state()) {
        for (int s = 0; s < sets_; ++s) {
            bool soft = solver_.set(s).terms(state_, false, terms_);
            for (int n = 0; soft && n < terms_.size(); ++n) soft = !terms_.rigid(n);
            if (!soft) throw std::invalid_argument("a set without compliance has no force");
        }
    }

    // a = g - W grad U, U the sum of C^2 / (2 alpha).
    Motions operator()(const Motions& at) {
        Motions rate{at.v, std::vector<Vec<double>>(at.x.size())};
        for (std::size_t i = 0; i < at.x.size(); ++i) {
            state_.particles[i].x = at.x[i];
            if (state_.particles[i].w > 0) rate.v[i] = gravity_;
        }
        for (int s = 0; s < sets_; ++s) {
            solver_.set(s).terms(state_, false, terms_);
            for (int a = 0; a < terms_.arity * terms_.size(); ++a) {
                const auto v = static_cast<std::size_t>(terms_.ids[a]);
                const int n = a / terms_.arity;
                const double pull = terms_.value[n] / terms_.compliance(n);
                rate.v[v] -= (state_.particles[v].w * pull) * terms_.gradient[a];
            }
        }
        return rate;
    }

private:
    int sets_;
    Vec<double> gravity_;
    Solver<double> solver_;  // for its sets, in the order of their colours
    State<double> state_;    // x alone, its d stays 0
    Terms<double> terms_;
};

}  // namespace

Trajectory softMotion(const World& world, const Vec<double>& gravity, double frameLength,
                      int frames, int stepsPerFrame) {
    if (stepsPerFrame < 1) throw std::invalid_argument("a motion needs a step");
    SoftMotion rate(world, gravity);
    Motions at{world.start, world.velocity};
    Trajectory trajectory;
    for (int frame = 0; frame < frames; ++frame) {
        for (int i = 0; i < stepsPerFrame; ++i)
            rungeKuttaStep(at, frameLength / stepsPerFrame,
                           [&](const Motions& m) { return rate(m); });
        trajectory.push_back(at.x);
        frameSolved();
    }
    return trajectory;
}

}  // namespace plait
