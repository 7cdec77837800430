// The rotation nearest to what many points have done.
#pragma once

#include "../numbers/rotation.h"
#include "../numbers/symmetric.h"

namespace plait {

inline Symmetric<double> traceLess(const Symmetric<double>& a) {
    Symmetric<double> moment = Symmetric<double>::diagonal(a.xx + a.yy + a.zz);
    moment.add(-1, a);
    return moment;
}

// Sum of m x a^T, column by column.
struct Outer {
    Vec<double> x{}, y{}, z{};

    void add(double m, const Vec<double>& is, const Vec<double>& arm) {
        x += (m * arm.x) * is, y += (m * arm.y) * is, z += (m * arm.z) * is;
    }
    // The same of arms that are turned.
    Outer turned(const Rotation& r) const {
        return {r.x.x * x + r.y.x * y + r.z.x * z, r.x.y * x + r.y.y * y + r.z.y * z,
                r.x.z * x + r.y.z * y + r.z.z * z};
    }
};

// The rotation nearest to a sum of m x a^T, where x is what arms a should be turned to. Newton's
// method from a guess, as for single pieces (pieces/poses.cpp), on sums alone.
inline Rotation nearestTurn(const Outer& sum, Rotation turn) {
    constexpr int rounds = 20;
    for (int round = 0; round < rounds; ++round) {
        const Outer s = sum.turned(turn);  // column j: of arms' component j
        const Vec<double> torque{s.y.z - s.z.y, s.z.x - s.x.z, s.x.y - s.y.x};
        const Symmetric<double> second{s.x.x, (s.x.y + s.y.x) / 2, (s.x.z + s.z.x) / 2,
                                       s.y.y, (s.y.z + s.z.y) / 2, s.z.z};
        const Vec<double> w = traceLess(second).solve(torque);
        turn = straightened(turnBy(w) * turn);
        if (!(dot(w, w) > 1e-16)) break;  // the next would be its square
    }
    return turn;
}

}  // namespace plait
