// Chebyshev's semi-iteration over the columns of a substep (Golub and Varga 1961; for
// position-based dynamics Wang, "A Chebyshev semi-iterative approach", 2015).
//
// A palindrome G is self-adjoint in the masses with eigenvalues g from 0 to 1 (methods/README.md).
// After k columns a mode is at T_k(s(g)) / T_k(s(1)) of where it was, with s(g) = (2 g - rho) /
// rho, which takes [0, rho] to [-1, 1]: of all polynomials in G the one that is least there. Wang
// takes s(g) = g / rho, which spends as much on eigenvalues from -rho to 0 that no palindrome has.
//
// Modes between rho and 1 still decay faster than without. What limits rho is what is not linear:
// folds, one-sided sets. On a hanging sheet of 64 x 64 (strands, tethers and every edge swept, not
// mended, 20 substeps in 1/60 s) rho = 0.8 makes 5 columns as good as 10 (strain 0.06 %, mean of
// frames; 0.10 % without), and 10 no better than they are; two columns gain energy at 0.7 and
// explode at 0.8, three or more do at 0.95. Single edges can be worse for it in single frames: of
// 128 x 128 with 24 x 4, 3 % where it is 0.4 % without and the mean falls from 0.21 to 0.17 %.
// Mixing neither changes momentum nor moves pins. Contacts come after it in every column.
#pragma once

#include "../../kernels/workers.h"
#include "../../state.h"

#include <vector>

namespace plait {

template <class Real>
class Chebyshev {
public:
    Chebyshev(double rho, std::size_t vertices) : rho_(rho), past_(vertices), now_(vertices) {}

    // Before a column; 0 is the first of the substep.
    void begin(int column, const State<Real>& state) {
        if (column == 0) t_ = 1, earlier_ = 0;
        past_.swap(now_);
        for (std::size_t v = 0; v < now_.size(); ++v) now_[v] = state.particles[v].d;
        if (column == 0) past_ = now_;
    }

    // After the constraints of a column: T_k+1 = 2 s T_k - T_k-1, in differences, so that what
    // stands stays.
    void mix(State<Real>& state, Workers& workers) {
        const double sigma = (2 - rho_) / rho_;
        const double twice = earlier_ == 0 ? 1 : 2, next = twice * sigma * t_ - earlier_;
        const auto beyond = static_cast<Real>(2 * twice * t_ / (rho_ * next) - 1);
        const auto onward = static_cast<Real>(earlier_ / next);
        earlier_ = t_, t_ = next;
        workers.forBlocks(static_cast<int>(now_.size()), 1024, [&](int begin, int end) {
            for (auto v = static_cast<std::size_t>(begin); v < static_cast<std::size_t>(end); ++v) {
                Vec<Real>& d = state.particles[v].d;
                d += beyond * (d - now_[v]) + onward * (now_[v] - past_[v]);
            }
        });
    }

private:
    double rho_, t_ = 1, earlier_ = 0;  // T_k(s(1)), T_k-1(s(1))
    std::vector<Vec<Real>> past_, now_;
};

}  // namespace plait
