// The set behind grip.h. Its drawer has what it does (0: waits, 1: holds, 2: has let go), and of
// each vertex what it weighed (1/kg) and its place in the hand: by axis a number and what rounding
// lost. What is held has no inverse mass, as what is pinned: links would pull it out of the hand.
#pragma once

#include "../constraint.h"
#include "grip.h"

#include <utility>

namespace plait {

template <class Real>
class GripSet final : public Constraint<Real> {
public:
    explicit GripSet(const Grip& grip)
        : grip_(grip), from_(grip.hand(0), "grip"), to_(from_), now_(from_) {}

    void furnish(Drawer<Real>& kept) const override { kept.numbers.assign(1 + 7 * count(), 0); }

    void beginFrame(double t0, double t1) override {
        from_ = Placement(grip_.hand(t0), "grip");
        to_ = Placement(grip_.hand(t1), "grip");
    }

    void begin(const Substep& substep, Workers&) override {
        now_ = between(from_, to_, turnBetween(from_, to_), substep.frameFraction);
    }

    void project(const Sweep<Real>& sweep, Direction, Workers&) override { hold(sweep); }
    long finish(const Sweep<Real>& sweep, Workers&) override { return hold(sweep) ? size() : 0; }

    void settle(State<Real>& state, Drawer<Real>& kept, double t, double) override {
        constexpr double rounding = 1e-9;  // s
        Real& doing = kept.numbers[0];
        if (doing == 0 && t > grip_.from - rounding) {
            doing = 1;
            take(state, &kept.numbers[1]);
        }
        if (doing == 1 && t > grip_.to - rounding) {
            doing = 2;
            for (std::size_t i = 0; i < count(); ++i)
                state.particles[place(i)].w = kept.numbers[1 + 7 * i];
        }
    }

    long size() const override { return static_cast<long>(count()); }

private:
    std::size_t count() const { return grip_.vertices.size(); }

    std::size_t place(std::size_t i) const { return static_cast<std::size_t>(grip_.vertices[i]); }

    void take(State<Real>& state, Real* kept) const {
        for (std::size_t i = 0; i < count(); ++i) {
            const Vec<double> own = now_.own(state.position(grip_.vertices[i]));
            *kept++ = std::exchange(state.particles[place(i)].w, Real(0));
            for (const double a : {own.x, own.y, own.z}) {
                *kept++ = static_cast<Real>(a);
                *kept++ = static_cast<Real>(a - double(static_cast<Real>(a)));
            }
        }
    }

    // Whether that moved anything.
    bool hold(const Sweep<Real>& sweep) const {
        if (sweep.kept[0] != 1) return false;
        bool moved = false;
        for (std::size_t i = 0; i < count(); ++i) {
            const Real* const own = sweep.kept + 1 + 7 * i;
            if (own[0] == 0) continue;  // pinned
            Real* const p = sweep.particles + 8 * place(i);
            const Vec<double> d =
                now_.world({double(own[1]) + double(own[2]), double(own[3]) + double(own[4]),
                            double(own[5]) + double(own[6])}) -
                Vec<double>{p[0], p[1], p[2]};
            for (const auto& [to, from] : {std::pair{d.x, p + 4}, {d.y, p + 5}, {d.z, p + 6}})
                moved |= std::exchange(*from, static_cast<Real>(to)) != static_cast<Real>(to);
        }
        return moved;
    }

    Grip grip_;
    Placement from_, to_, now_;
};

}  // namespace plait
