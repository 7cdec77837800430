// The numbers of a run: what moves, and nothing about why.
#pragma once

#include "numbers/math.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plait {

// A vertex is x + d. x is where it stood when a substep began, rounded; d is the rest, and what
// happens in the substep. Folding d into x leaves in d what rounding would have lost, and velocity
// is the change of d over h. Plain float positions lose it at small substeps: on a chain at 24,000
// substeps a second, 10 m from the origin, noise of 0.02 m/s against 1e-5 m/s.
template <class Real>
struct alignas(8 * sizeof(Real)) Particle {
    Vec<Real> x;  // m
    Real w;       // 1/kg, 0 where pinned
    Vec<Real> d;  // m
    Real unused;  // 0
};

// A vector with padding, so that a vertex is one aligned load.
template <class Real>
struct alignas(4 * sizeof(Real)) Padded {
    Vec<Real> v;
    Real unused;
};

template <class Real>
struct State {
    // Every array has one entry more than there are vertices: a vertex without mass on which rows
    // that only fill up a block hang.
    std::vector<Particle<Real>> particles;
    std::vector<Padded<Real>> velocity;      // m/s
    std::vector<Padded<Real>> before;        // d when the substep began
    std::vector<Padded<Real>> last;          // d one substep earlier, seen from the same x (BDF2)
    std::vector<Padded<Real>> lastVelocity;  // velocity when the substep began
    std::vector<Padded<Real>> air;  // q of the inverse inertia w I - q q^T of the last substep,
                                    // kg^(-1/2): added mass
    std::vector<Real> tension;      // N, by link, then contact, as the method numbers them (global)
    std::vector<std::uint8_t> disabled;  // by vertex, what is out of contacts
                                         // (contacts/failures.h); empty: nothing ever is
    bool hasAir = false;                 // false: every q is 0
    bool hasPast = false;                // last and lastVelocity hold the substep before this one
    long substep = 0;                    // since the start of the run

    int count() const { return static_cast<int>(particles.size()) - 1; }

    Vec<double> position(int i) const {
        const Particle<Real>& p = particles[static_cast<std::size_t>(i)];
        return {double(p.x.x) + double(p.d.x), double(p.x.y) + double(p.d.y),
                double(p.x.z) + double(p.d.z)};
    }
};

}  // namespace plait
