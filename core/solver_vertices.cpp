// What the solver does vertex by vertex: integration and pins.
#include "numbers/convert.h"
#include "numbers/elementary.h"
#include "solver.h"

#include <cmath>

namespace plait {
namespace {

constexpr int grain = 1024;  // vertices a thread takes at least

// A vector with its padding in one register, since gcc's own way of pairing them is off (see
// CMakeLists.txt). Divisions by h stay divisions: the rounding of an inverse would speed up or slow
// down a free vertex by as much in every substep, by 5e-4 in 10,000 of them.
template <class Real>
struct FourOf {
    typedef Real V __attribute__((vector_size(4 * sizeof(Real))));
};
template <class Real>
using Four = typename FourOf<Real>::V;

// Of the four numbers that begin with `at`.
template <class Real>
Four<Real> four(const Vec<Real>& at) {
    Four<Real> v;
    __builtin_memcpy(&v, &at.x, sizeof v);
    return v;
}
template <class Real>
void put(Vec<Real>& at, const Four<Real>& v) {
    __builtin_memcpy(&at.x, &v, sizeof v);
}

template <class Real>
Real lengthOf(const Four<Real>& v) {
    return length(Vec<Real>{v[0], v[1], v[2]});
}

// a + b = sum + error exactly, whichever is larger (Knuth, TAOCP 2, 4.2.2).
template <class V>
V twoSum(const V& a, const V& b, V& error) {
    const V sum = a + b, part = sum - a;
    error = (a - (sum - part)) + (b - part);
    return sum;
}

}  // namespace

template <class Real>
void Solver<Real>::startVelocities(bool second) {
    if (state_.lastVelocity.empty()) return;
    workers_.forBlocks(state_.count(), grain, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            const Four<Real> v = four(state_.velocity[i].v), past = four(state_.lastVelocity[i].v);
            if (second) put(state_.velocity[i].v, v + (v - past) / Real(3));
            put(state_.lastVelocity[i].v, v);
        }
    });
}

template <class Real>
void Solver<Real>::predict(bool second) {
    const Real h = static_cast<Real>(h_);
    workers_.forBlocks(state_.count(), grain, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            Particle<Real>& p = state_.particles[i];
            const Four<Real> d = four(p.d);
            put(state_.before[i].v, d);
            if (p.w == Real(0)) continue;
            const Four<Real> step = h * four(state_.velocity[i].v);
            const auto ahead = [&] { return ((d - four(state_.last[i].v)) + 2 * step) / Real(3); };
            put(p.d, d + (second ? ahead() : step));
        }
    });
    if (blaming_) blame("the prediction");
}

template <class Real>
void Solver<Real>::movePins(double f) {
    for (const Pins& pins : pins_)
        for (std::size_t i = 0; i < pins.vertices.size(); ++i) {
            Particle<Real>& p = state_.particles[static_cast<std::size_t>(pins.vertices[i])];
            if (p.w != Real(0)) continue;  // let go
            const Vec<double> target = pins.from[i] + f * (pins.to[i] - pins.from[i]);
            p.d = as<Real>(target - as<double>(p.x));
        }
    if (blaming_) blame("the motion of a pin");
}

// Velocities and, with them, positions: X <- X + d, and what rounding leaves stays in d.
// Under BDF2 a vertex that was pushed and would accelerate beyond the limit, or that the method has
// found struck, takes the first-order velocity, and a past that continues it, so that no bounce is
// extrapolated (V) [IN20]. The past is damped as well: BDF2 would extrapolate the loss, and lose
// half as much again.
template <class Real>
void Solver<Real>::update(bool second) {
    const bool given = whole_ && whole_->setsVelocities();
    const bool bdf2 = options_.integrator == Integrator::bdf2;
    const bool hasLast = !state_.last.empty(), hasVelocity = !state_.lastVelocity.empty();
    const bool fallsBack = second && std::isfinite(options_.maxAcceleration);
    if (second) {
        std::fill(touched_.begin(), touched_.end(), std::uint8_t{0});
        std::fill(struck_.begin(), struck_.end(), std::uint8_t{0});
    }
    if (fallsBack)
        for (const auto& set : sets_) set->markTouched(touched_);
    if (second && whole_) whole_->markStruck(state_, state_.kept.back(), struck_);
    const Real h = static_cast<Real>(h_);
    const Real most = static_cast<Real>(options_.maxAcceleration * h_);
    const Real lost = static_cast<Real>(1 - power(1 - options_.damping, 24 * h_));
    workers_.forBlocks(state_.count(), grain, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            Particle<Real>& p = state_.particles[i];
            const Four<Real> before = four(state_.before[i].v), d = four(p.d), step = d - before;
            const Four<Real> old = hasVelocity ? four(state_.lastVelocity[i].v) : Four<Real>{};
            Four<Real> past = old;
            Four<Real> v = given ? four(state_.velocity[i].v) : step / h;
            if (second) {
                // (3 x - 4 x1 + x2) / 2 h, as differences of neighbours: no digits cancel [IN17].
                const Four<Real> earlier = before - four(state_.last[i].v);
                const Four<Real> v2 = (step + Real(0.5) * (step - earlier)) / h;
                const bool back = struck_[i] || (touched_[i] && lengthOf<Real>(v2 - old) > most);
                if (back) past = v;
                if (!back) v = v2;
            }
            if (options_.limitAcceleration) {
                const Real l = lengthOf<Real>(v - old);
                if (l > most) v = old + (most / l) * (v - old);
            }
            v = v - lost * v;
            put(state_.velocity[i].v, v);
            if (bdf2) put(state_.lastVelocity[i].v, past - lost * past);
            Four<Real> left;
            const Four<Real> x = twoSum(four(p.x), d, left);  // the fourth is w + 0
            put(p.x, x);
            put(p.d, left);
            if (hasLast) put(state_.last[i].v, before + (left - d));
        }
    });
    if (blaming_) blame("the update");
}

template <class Real>
std::vector<Vec<double>> Solver<Real>::positions() const {
    std::vector<Vec<double>> x;
    for (int i = 0; i < state_.count(); ++i) x.push_back(state_.position(i));
    return x;
}

template <class Real>
std::vector<Vec<double>> Solver<Real>::velocities() const {
    std::vector<Vec<double>> v;
    for (int i = 0; i < state_.count(); ++i)
        v.push_back(as<double>(state_.velocity[static_cast<std::size_t>(i)].v));
    return v;
}

template <class Real>
std::vector<double> Solver<Real>::ages() const {
    std::vector<double> ages;
    for (const std::int32_t born : state_.born)
        ages.push_back(born < 0 ? -1 : static_cast<double>(state_.substep - born) * h_);
    return ages;
}

template class Solver<float>;
template class Solver<double>;

}  // namespace plait
