// A sum whose error does not grow with the number of terms (Neumaier 1974, after Kahan): what
// rounding takes from the running sum is summed apart. Terms are added in the caller's order.
#pragma once

#include "../numbers/exact.h"
#include "../numbers/math.h"

namespace plait {

class CompensatedSum {
public:
    void add(double term) {
        const Twofold s = exactSum(sum_, term);
        sum_ = s.high;
        lost_ += s.low;
    }
    double value() const { return sum_ + lost_; }

private:
    double sum_ = 0, lost_ = 0;
};

class CompensatedVecSum {
public:
    void add(const Vec<double>& term) { x_.add(term.x), y_.add(term.y), z_.add(term.z); }
    Vec<double> value() const { return {x_.value(), y_.value(), z_.value()}; }

private:
    CompensatedSum x_, y_, z_;
};

}  // namespace plait
