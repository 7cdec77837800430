// What a run has come to, for stability maps: the definitions of validation C7, in one place.
#pragma once

#include <algorithm>

namespace plait {

// In the order of how bad it is, and of the categories of a HeatMap.
enum class Outcome { ok, drifting, exploded, notFinite };

// Watches a run:
//   not finite  a number is not finite
//   exploded    E > 1.05 E0 + work, or a strain beyond 200 %
//   drifting    E > 1.01 E0 + work, or a strain beyond what the map allows
// E: energy of motion and gravity, and of springs where they are forces, in J, its zero so low that
// E0, that of the start, is positive. Work: what has come in from outside since the start.
class Judge {
public:
    Judge(double startEnergy, double allowedStrain)
        : startEnergy_(startEnergy), allowedStrain_(allowedStrain) {}

    // After a step. False where there is no more to be seen: the worst has come.
    bool see(double energy, double strain, double work = 0) {
        const double gained = energy - work;
        if (!(gained - gained == 0) || !(strain - strain == 0)) return worsen(Outcome::notFinite);
        if (gained > 1.05 * startEnergy_ || strain > 2) return worsen(Outcome::exploded);
        if (gained > 1.01 * startEnergy_ || strain > allowedStrain_)
            return worsen(Outcome::drifting);
        return true;
    }
    bool seeNotFinite() { return worsen(Outcome::notFinite); }
    // It is further from what is exact than the map allows.
    bool seeDrift() { return worsen(Outcome::drifting); }

    Outcome outcome() const { return outcome_; }

private:
    bool worsen(Outcome to) {
        outcome_ = std::max(outcome_, to);
        return outcome_ < Outcome::exploded;
    }

    double startEnergy_, allowedStrain_;
    Outcome outcome_ = Outcome::ok;
};

}  // namespace plait
