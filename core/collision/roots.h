// Where a polynomial may be 0: no root is ever missed.
#pragma once

#include "bernstein.h"

namespace plait {

// Every root in [low, high]; if simple, there is exactly one, with a change of sign, and of a
// polynomial that is exact high - low is at most 1e-12.
template <class T = double>
struct Bracket {
    T low, high;
    bool simple;
};

// Brackets by time; they do not overlap. Where more than eight would be needed, the last is wider.
template <class T = double>
class Brackets {
public:
    static constexpr int capacity = 8;

    const Bracket<T>* begin() const { return item_; }
    const Bracket<T>* end() const { return item_ + count_; }
    int size() const { return count_; }
    const Bracket<T>& operator[](int i) const { return item_[i]; }

    void append(const Bracket<T>& next) {
        const bool touches = count_ > 0 && item_[count_ - 1].high >= next.low;
        if (touches || count_ == capacity) {
            Bracket<T>& last = item_[count_ - 1];
            last = {last.low, last.high < next.high ? next.high : last.high, false};
        } else {
            item_[count_++] = next;
        }
    }

private:
    Bracket<T> item_[capacity];
    int count_ = 0;
};

// Brackets that together hold every t in [0, 1] where some polynomial within p.error of p is 0;
// degrees 1 to 6. By subdivision: the coefficients of a part of [0, 1] change sign at least as
// often as the polynomial there (Lane, Riesenfeld, Bounds on a polynomial, 1981), and a coefficient
// counts as having a sign only if no rounding so far could have given it another. A bracket is not
// simple where rounding hides how many roots there are, [0, 1] itself if the polynomial is 0. Needs
// at most 512 parts, no memory but the stack's, and ends whatever the numbers are.
template <int n, class T>
Brackets<T> isolateRoots(const Bernstein<n, T>& p);

}  // namespace plait
