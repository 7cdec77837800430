// What the solver does vertex by vertex: integration, pins, and where a run begins.
#include "constraints/constants.h"
#include "methods/methods.h"
#include "numbers/convert.h"
#include "numbers/elementary.h"
#include "numbers/finite.h"
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

// X + d with X the nearest number: what rounding takes from X is in d.
template <class Real>
void split(Particle<Real>& p, const Vec<double>& x) {
    p.x = as<Real>(x);
    p.d = as<Real>(x - as<double>(p.x));
}

// a + b = sum + error exactly, whichever is larger (Knuth, TAOCP 2, 4.2.2).
template <class V>
V twoSum(const V& a, const V& b, V& error) {
    const V sum = a + b, part = sum - a;
    error = (a - (sum - part)) + (b - part);
    return sum;
}

std::vector<ScheduledSet> scheduledSets(const World& world) {
    std::vector<ScheduledSet> sets;
    for (const World::Set& set : world.sets)
        sets.push_back({.name = set.options.name,
                        .order = set.options.order,
                        .importance = set.options.importance,
                        .contact = set.contact,
                        .secondaryInterval = set.options.secondaryInterval});
    return sets;
}

}  // namespace

template <class Real>
Solver<Real>::Solver(std::shared_ptr<const World> world, const SolverOptions& options)
    : world_(std::move(world)),
      options_(options),
      schedule_(scheduledSets(*world_), options.schedule),
      workers_(options.threads) {
    if (!(options.timeScale > 0) || !std::isfinite(options.timeScale))
        throw std::invalid_argument("time scale must be positive");
    if (!(options.damping >= 0 && options.damping <= 1))
        throw std::invalid_argument("damping must be in [0, 1]");
    if (!(options.maxAcceleration > 0))
        throw std::invalid_argument("max acceleration must be positive");
    if (options.baseSteps < 1) throw std::invalid_argument("there must be a base step");
    if (options.smoothing < 0) throw std::invalid_argument("smoothing must not be negative");
    const FrameRate rate = options.schedule.frameRate;
    h_ = options.timeScale * rate.seconds / (double(rate.frames) * options.schedule.substeps);
    for (const int s : schedule_.order())
        if (world_->sets[static_cast<std::size_t>(s)].contact) contacts_.push_back(s);
    setUp();
}

template <class Real>
void Solver<Real>::setUp() {
    state_ = {};
    setUpState();
    setUpPins();
    setUpSets();
    std::vector<NamedSet<Real>> named;
    for (std::size_t s = 0; s < sets_.size(); ++s)
        named.push_back({world_->sets[s].options.name, world_->sets[s].contact, sets_[s].get()});
    const bool inertia = std::any_of(forces_.begin(), forces_.end(),
                                     [](const auto& force) { return force->hasInertia(); });
    whole_ = makeWholeStep(options_, named, state_, inertia);
    setUpDrawers();
    setUpChebyshev();
    takePast();
}

// What nobody in the run will read is not there.
template <class Real>
void Solver<Real>::setUpDrawers() {
    const bool bdf2 = options_.integrator == Integrator::bdf2;
    bool past = bdf2;
    state_.kept.resize(sets_.size() + forces_.size() + 1);
    forContacts([&](const auto& set, int s) {
        set.furnish(drawerOf(s));
        past = past || set.needsPast();
    });
    for (std::size_t f = 0; f < forces_.size(); ++f) {
        const int place = static_cast<int>(sets_.size() + f);
        if (forces_[f]->hasInertia()) {
            if (state_.inertia >= 0) continue;
            state_.inertia = place;
        }
        forces_[f]->furnish(drawerOf(place));
    }
    if (whole_) whole_->furnish(state_.kept.back());
    if (past) state_.last.resize(state_.particles.size(), Padded<Real>{});
    if (bdf2 || options_.limitAcceleration || whole_)
        state_.lastVelocity.resize(state_.particles.size(), Padded<Real>{});
}

template <class Real>
void Solver<Real>::setUpChebyshev() {
    if (options_.chebyshev == 0) return;
    const auto need = [](bool met, const std::string& what) {
        if (!met) throw std::invalid_argument("chebyshev " + what);
    };
    need(options_.chebyshev > 0 && options_.chebyshev < 1, "must be in [0, 1)");
    need(options_.method == Method::xpbd, "is for method xpbd");
    need(options_.sweeps == Sweeps::palindrome &&
             options_.schedule.mode == ScheduleMode::interleaved,
         "needs palindromes, interleaved");
    need(options_.schedule.iterations >= 3, "needs 3 iterations or more");
    const auto yields = [](Real compliance) { return compliance > 0 && compliance < Real(slack); };
    Terms<Real> terms;
    for (std::size_t s = 0; s < sets_.size(); ++s) {
        const ScheduledSet& set = schedule_.sets()[s];
        if (set.contact || !sets_[s]->terms(state_, false, terms)) continue;
        need(std::none_of(terms.above.begin(), terms.above.end(), yields) &&
                 std::none_of(terms.below.begin(), terms.below.end(), yields),
             "mixes no multipliers, and set " + set.name + " has compliance");
    }
    chebyshev_ = std::make_unique<Chebyshev<Real>>(options_.chebyshev, state_.particles.size());
}

template <class Real>
void Solver<Real>::setUpState() {
    const World& world = *world_;
    const std::size_t n = world.start.size(), all = n + 1;
    if (world.rest.size() != n || world.velocity.size() != n || world.mass.size() != n ||
        world.pinned.size() != n)
        throw std::invalid_argument("a world must have one entry a vertex in each of its arrays");
    state_.particles.resize(all, Particle<Real>{});
    state_.velocity.resize(all, Padded<Real>{});
    state_.before.resize(all, Padded<Real>{});
    if (options_.smoothing > 0) sums_.resize(all);
    touched_.resize(all);
    struck_.resize(all);
    for (std::size_t i = 0; i < n; ++i) {
        const double mass = world.mass[i];
        Particle<Real>& p = state_.particles[i];
        split(p, world.start[i]);
        p.w = world.pinned[i] ? 0 : static_cast<Real>(1 / mass);
        state_.velocity[i].v = as<Real>(world.velocity[i]);
        if (!world.pinned[i] && !(mass > 0 && std::isfinite(mass) && std::isfinite(p.w)))
            throw std::invalid_argument("vertex " + std::to_string(i) + " has no mass");
        if (!isFinite(p.x) || !isFinite(state_.velocity[i].v))
            throw std::invalid_argument("vertex " + std::to_string(i) +
                                        " does not start at a number");
    }
}

template <class Real>
void Solver<Real>::setUpPins() {
    pins_.clear();
    for (const World::Pins& pins : world_->pins) {
        if (!pins.animation) continue;
        Pins moving{pins.vertices, pins.animation, {}, {}, {}};
        for (const int v : pins.vertices)
            moving.start.push_back(world_->start[static_cast<std::size_t>(v)]);
        moving.from = moving.to = moving.start;
        pins_.push_back(std::move(moving));
    }
}

template <class Real>
void Solver<Real>::setUpSets() {
    sets_.clear();
    forces_.clear();
    std::vector<int> counts(world_->start.size() + 1, 0);
    for (const World::Set& set : world_->sets) {
        sets_.push_back(set.recipe.make<Real>(*world_, options_.kernels));
        sets_.back()->countAt(counts);
    }
    for (const auto& set : sets_) set->relaxBy(counts);
    contactSets_.clear();
    for (const int s : contacts_)
        if (auto* const set = dynamic_cast<ContactConstraint<Real>*>(sets_[s].get()))
            contactSets_.emplace_back(set, s);
    for (const Recipe<Force>& force : world_->forces)
        forces_.push_back(force.make<Real>(*world_, options_.kernels));
}

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
void Solver<Real>::setPast(std::span<const Vec<double>> positions,
                           std::span<const Vec<double>> velocities) {
    const auto n = static_cast<std::size_t>(state_.count());
    if (positions.size() != n || velocities.size() != n)
        throw std::invalid_argument("the past must have one position and velocity a vertex");
    if (!allFinite(positions) || !allFinite(velocities))
        throw std::invalid_argument("the past must be finite");
    pastPositions_.assign(positions.begin(), positions.end());
    pastVelocities_.assign(velocities.begin(), velocities.end());
    takePast();
}

template <class Real>
void Solver<Real>::takePast() {
    if (pastPositions_.empty()) return;
    for (std::size_t i = 0; i < pastPositions_.size(); ++i) {
        if (!state_.last.empty())
            state_.last[i].v = as<Real>(pastPositions_[i] - as<double>(state_.particles[i].x));
        if (!state_.lastVelocity.empty()) state_.lastVelocity[i].v = as<Real>(pastVelocities_[i]);
    }
    state_.hasPast = true;
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

template class Solver<float>;
template class Solver<double>;

}  // namespace plait
