// Links that other sets hold, mended where those have left them too long: they and a few rings of
// neighbours are swept over and over, as nobody could afford to sweep them all. What a palindrome
// leaves of a sheet is off in few places, where it whips round, or where a load has no straight
// strand to go by; so its greatest strain falls several times for a hundredth of the work.
//
// First in a column by its order, it acts last, on the palindrome's way back, before the contacts;
// and where there are any, once more after all columns, so that of lengths and thicknesses, where a
// fold leaves no room for both, lengths are kept.
// A sweep of its own is a palindrome as well, and a product of two self-adjoint contractions has
// real eigenvalues from 0 to 1: it adds no energy either (README.md).
#pragma once

#include "../constraint.h"
#include "../constraints/rows.h"
#include "../sets/link_sweeps.h"
#include "../world.h"

#include <stdexcept>

namespace plait {

template <class Real>
class MendSet : public Constraint<Real> {
public:
    // Only what is too long is mended: to push what is too short would hold folds open. And it is
    // swept to half the tolerance: pulled to its length, it would jerk whatever hangs on it.
    // Throws std::invalid_argument for links that move or have compliance.
    MendSet(const Rows<Stretch>& set, int padding, KernelChoice kernels, const Mending& mending)
        : links_(set.ids, padding, kernels), mending_(mending) {
        if (set.animate) throw std::invalid_argument("mending: rest lengths cannot move");
        const double aim = 1 + mending.tolerance / 2;
        mending_.tolerance = (1 + mending.tolerance) / aim - 1;
        for (int i = 0; i < static_cast<int>(set.rows.size()); ++i) {
            const auto& row = set.rows[static_cast<std::size_t>(i)];
            if (row.compliance != 0) throw std::invalid_argument("mending: links must be rigid");
            links_.setRow(links_.slot(i),
                          {static_cast<Real>(aim * row.rest), Real(0), Real(slack)});
        }
    }

    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override {
        work_ = direction == Direction::backward ? links_.mend(sweep, mending_, workers) : 0;
    }
    // What contacts have pulled too long since. It may press them closer than their thickness, but
    // not through each other: that they look at after this.
    long finish(const Sweep<Real>& sweep, Workers& workers) override {
        return links_.mend(sweep, mending_, workers);
    }
    // Other methods find these links in the sets that hold them.
    bool termsOf(std::span<const int>, const State<Real>&, bool, Terms<Real>& out) const override {
        out.resize(0, 2, false);
        return true;
    }
    // Of the evaluation last made.
    long size() const override { return work_; }

private:
    LinkSweeps<Real> links_;
    Mending mending_;
    long work_ = 0;
};

// Those of these links that a column leaves too long, mended.
void mend(World& world, const Rows<Stretch>& set, SetOptions options, const Mending& mending = {});

}  // namespace plait
