// What points that move each for itself do as one.
#pragma once

#include "../numbers/symmetric.h"

namespace plait {

// How points move as one, with the momenta that they have.
class RigidMotion {
public:
    void add(double m, const Vec<double>& x, const Vec<double>& v) {
        mass_ += m;
        centre_ += m * x;
        momentum_ += m * v;
        angular_ += m * cross(x, v);
        second_ += Symmetric<double>::diagonal(m * dot(x, x));
        second_.addOuter(-m, x);
    }
    void solve() {
        if (mass_ == 0) return;
        centre_ = (1 / mass_) * centre_;
        velocity_ = (1 / mass_) * momentum_;
        angular_ -= cross(centre_, momentum_);
        second_ += Symmetric<double>::diagonal(-mass_ * dot(centre_, centre_));
        second_.addOuter(mass_, centre_);
        spin_ = second_.solve(angular_);
    }
    Vec<double> at(const Vec<double>& x) const { return velocity_ + cross(spin_, x - centre_); }

private:
    double mass_ = 0;
    Vec<double> centre_{}, momentum_{}, angular_{}, velocity_{}, spin_{};
    Symmetric<double> second_{};
};

}  // namespace plait
