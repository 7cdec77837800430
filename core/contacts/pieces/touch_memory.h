// What pieces remember of where they touched: how they were pressed together, and how far they have
// slipped from where they stuck.
//
// Sweeps that begin with no multipliers, and friction that forgets with each substep what it did
// not take back, let stacks creep. A pair is remembered as one, by force and torque about a point,
// whichever points it touches in next.
#pragma once

#include "touches.h"

namespace plait {

template <class Real>
struct Drawer;

class TouchMemory {
public:
    // Room for `partners` pairs for each piece that yields; what does not fit is forgotten.
    TouchMemory(int pieces, int partners) : most_(pieces * partners) {}

    template <class Real>
    void furnish(Drawer<Real>& drawer) const;
    template <class Real>
    void read(const Drawer<Real>& drawer);
    template <class Real>
    void write(Drawer<Real>& drawer) const;

    // A pair that has touched begins with most of the multipliers that it had, and part of what it
    // has slipped is taken back. In the order of (first, second), in a substep of h (s); `start`:
    // by piece.
    void recall(Touches& touches, std::span<const Pose> start, double h) const;
    // What they do now takes the place of what was known, but of two that do not move (by piece).
    void note(const Touches& touches, double h, std::span<const unsigned char> moves);
    // visit(first, second), of all that touched.
    template <class Visit>
    void forAll(const Visit& visit) const {
        for (const Known& known : known_) visit(known.first, known.second);
    }

private:
    struct Known {
        int first, second;              // pieces
        Vec<double> at{};               // m, from the centre of the first
        Vec<double> slip{}, twist{};    // m, rad: of the first over the second since they stuck
        Vec<double> force{}, torque{};  // N, N m about `at`: on the first
        double lasting = 0;             // part of these that was there a substep earlier
    };
    static void lean(const Known& known, Touches& touches, const TouchedPair& pair,
                     const Pose& first, const Pose& second, double h);
    Known knownOf(const Touches& touches, const TouchedPair& pair, double h) const;

    std::size_t most_;
    std::vector<Known> known_, before_;  // in the order of (first, second)
};

}  // namespace plait
