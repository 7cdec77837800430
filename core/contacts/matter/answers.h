// How what meets in one contact answers impulses: vertex by vertex, but a piece as a whole.
#pragma once

#include "../../pieces/poses.h"
#include "../search/nearest.h"
#include "../search/paths.h"

#include <algorithm>

namespace plait {

// What answers depend on besides the state.
struct Yielding {
    std::span<const double> inverseMass;  // 1/kg, by vertex; empty: masses are physical
    const Pieces& pieces;
    std::span<Pose> poses;  // of them, as they are by now
};

template <class Real>
class Answers {
public:
    // `at`: where the vertices are; `yields`: of the first simplex and of the second, 1 but for
    // shocked layers.
    Answers(const Sweep<Real>& sweep, const Pairing& pair, const std::array<double, 4>& weight,
            const PairPoints& at, const Yielding& yielding, const std::array<double, 2>& yields)
        : sweep_(sweep), pair_(pair), weight_(weight), yielding_(yielding), yields_(yields) {
        for (std::size_t s = 0; s < 2; ++s) {
            piece_[s] = yielding.pieces.of(pair.vertices[s == 0 ? 0 : 3]);
            if (piece_[s] < 0) continue;
            Vec<double> point{};
            for (std::size_t i = 0; i < 4; ++i)
                if (sideOf(i) == s) point += std::fabs(weight[i]) * at[i];
            lever_[s] = point - yielding.poses[piece_[s]].centre;
        }
    }

    // The multiplier along n that moves none of them by more than this (m).
    double within(double limit, const Vec<double>& n) const {
        double most = 0;
        for (std::size_t s = 0; s < 2; ++s)
            if (piece_[s] >= 0) most = std::max(most, ofPiece(s, n));
        for (std::size_t i = 0; i < 4; ++i)
            if (counts(i)) most = std::max(most, length(of(i, weight_[i] * n)));
        return divide(limit, most);
    }
    // How far they part along n of unit length by an impulse of 1 along it. Next to a vertex that
    // is pinned a free one has no lever to part them by; without a limit it would be flung away.
    double along(const Vec<double>& n) const {
        constexpr double leastLever = 0.1;
        double sum = 0, most = 0;
        for (std::size_t s = 0; s < 2; ++s)
            if (piece_[s] >= 0) sum += ofPiece(s, n);
        for (std::size_t i = 0; i < 4; ++i) {
            if (!counts(i)) continue;
            const double answer = dot(n, of(i, n));
            sum += weight_[i] * weight_[i] * answer;
            most = std::max(most, answer);
        }
        return std::max(sum, leastLever * leastLever * most);
    }
    void move(const Vec<double>& impulse) const {
        for (std::size_t s = 0; s < 2; ++s)
            if (piece_[s] >= 0) movePiece(s, (s == 0 ? yields_[s] : -yields_[s]) * impulse);
        for (std::size_t i = 0; i < 4; ++i) {
            Real* const p = sweep_.particles + 8 * pair_.vertices[i];
            if (!counts(i) || p[3] == Real(0)) continue;
            const Vec<double> d = of(i, weight_[i] * impulse);
            p[4] += static_cast<Real>(d.x);
            p[5] += static_cast<Real>(d.y);
            p[6] += static_cast<Real>(d.z);
        }
    }

private:
    std::size_t sideOf(std::size_t i) const { return static_cast<int>(i) < pair_.first ? 0 : 1; }
    bool counts(std::size_t i) const { return weight_[i] != 0 && piece_[sideOf(i)] < 0; }

    // How far vertex i goes.
    Vec<double> of(std::size_t i, const Vec<double>& impulse) const {
        const int v = pair_.vertices[i];
        const double yield = yields_[sideOf(i)];
        if (!yielding_.inverseMass.empty()) return yield * (yielding_.inverseMass[v] * impulse);
        return yield * (double(sweep_.particles[8 * v + 3]) * impulse);
    }
    double ofPiece(std::size_t side, const Vec<double>& n) const {
        const int p = piece_[side];
        return yields_[side] *
               yieldOf(yielding_.pieces.body(p), yielding_.poses[p], lever_[side], n);
    }
    void movePiece(std::size_t side, const Vec<double>& impulse) const {
        const int p = piece_[side];
        const Body& body = yielding_.pieces.body(p);
        if (body.inverseMass == 0) return;
        yielding_.poses[p] = pushed(body, yielding_.poses[p], lever_[side], impulse);
        yielding_.pieces.put(sweep_, p, yielding_.poses[p]);
    }

    const Sweep<Real>& sweep_;
    const Pairing& pair_;
    const std::array<double, 4>& weight_;
    const Yielding yielding_;
    std::array<double, 2> yields_;
    std::array<int, 2> piece_;            // of either side; -1: its vertices answer one by one
    std::array<Vec<double>, 2> lever_{};  // m, from its centre to where it is touched
};

}  // namespace plait
