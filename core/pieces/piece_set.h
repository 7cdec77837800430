// Pieces as a set: each evaluation puts every piece to its nearest rigid pose, by mass (Müller et
// al. 2005, shape matching; without stiffness, so that it is the orthogonal projection on rigid
// motions). What its vertices were given besides is lost to the pose and to nothing else: momentum
// and angular momentum stay.
#pragma once

#include "poses.h"

namespace plait {

template <class Real>
class PieceSet : public Constraint<Real> {
public:
    explicit PieceSet(Pieces pieces) : pieces_(std::move(pieces)) {}

    void project(const Sweep<Real>& sweep, Direction, Workers& workers) override {
        workers.forBlocks(pieces_.count(), 16, [&](int begin, int end) {
            for (int p = begin; p < end; ++p)
                if (moves(sweep, p)) pieces_.put(sweep, p, pieces_.poseOf(sweep, p));
        });
    }
    // A pose is six numbers.
    long size() const override { return 6L * pieces_.count(); }

private:
    bool moves(const Sweep<Real>& sweep, int piece) const {
        const Range& all = pieces_.body(piece).vertices;
        for (int v = all.first; v < all.last; ++v)
            if (sweep.particles[8 * v + 3] != Real(0)) return true;
        return false;
    }

    Pieces pieces_;
};

}  // namespace plait
