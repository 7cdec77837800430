// The numbers of a run: what moves, and nothing about why.
#pragma once

#include "numbers/convert.h"
#include "numbers/finite.h"
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

// X + d with X the nearest number: what rounding takes from X is in d.
template <class Real>
void split(Particle<Real>& p, const Vec<double>& x) {
    p.x = as<Real>(x);
    p.d = as<Real>(x - as<double>(p.x));
}

// A vector with padding, so that a vertex is one aligned load.
template <class Real>
struct alignas(4 * sizeof(Real)) Padded {
    Vec<Real> v;
    Real unused;
};

template <class Real>
bool isFinite(const Particle<Real>& p) {
    return isFinite(p.x) && isFinite(p.d);
}
template <class Real>
bool isFinite(const Padded<Real>& p) {
    return isFinite(p.v);
}

// What one set, one force or the method keeps past a substep: it alone writes it, and it keeps
// nothing anywhere else, so that a run can be resumed, put back and repeated.
template <class Real>
struct Drawer {
    std::vector<Real> numbers;
    std::vector<std::int32_t> integers;
};

template <class Real>
struct State {
    // Every array by vertex has one entry more than there are vertices: a vertex without mass on
    // which rows that only fill up a block hang.
    std::vector<Particle<Real>> particles;
    std::vector<Padded<Real>> velocity;  // m/s
    std::vector<Padded<Real>> before;    // d when the substep began
    // Empty where nothing in the run asks for it: d one substep earlier, seen from the same x, and
    // velocity when the substep began.
    std::vector<Padded<Real>> last, lastVelocity;
    // Empty where nothing comes or goes (sources/). Which birth it is of its source, counted from
    // 0, and the substep that it came with; of what was there from the start 0 and 0; -1 and -1 of
    // what is not there.
    std::vector<std::int32_t> id, born;
    std::vector<Drawer<Real>> kept;  // by set, then by force, then the method's
    // What has come apart, in that order: edges of the world's complex; -1 - v where the copy v has
    // parted from its vertex for good (complex/cuts.h).
    std::vector<std::int32_t> cuts;
    bool hasPast = false;  // last and lastVelocity hold the substep before this one
    long substep = 0;      // since the start of the run

    int count() const { return static_cast<int>(particles.size()) - 1; }

    Vec<double> position(int i) const {
        const Particle<Real>& p = particles[static_cast<std::size_t>(i)];
        return {double(p.x.x) + double(p.d.x), double(p.x.y) + double(p.d.y),
                double(p.x.z) + double(p.d.z)};
    }

    // Every array by vertex, in the order in which files and hashes have them.
    template <class Self, class Body>
    static void forArrays(Self& state, const Body& body) {
        body(state.particles);
        body(state.velocity);
        body(state.before);
        body(state.last);
        body(state.lastVelocity);
    }

    std::size_t bytes() const {
        std::size_t sum = 0;
        const auto add = [&](const auto& array) { sum += array.size() * sizeof(array[0]); };
        forArrays(*this, add);
        add(id), add(born), add(cuts);
        for (const Drawer<Real>& drawer : kept) {
            add(drawer.numbers);
            add(drawer.integers);
        }
        return sum;
    }
};

}  // namespace plait
