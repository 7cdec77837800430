#include "solver.h"

#include "measure/hash.h"
#include "methods/nucleus.h"
#include "methods/xpbd.h"
#include "numbers/elementary.h"
#include "numbers/finite.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {

// One substep: S sections 5 and 6, XPBD (2016) algorithm 1, and V for the second order.
template <class Real>
void Solver<Real>::substep(double fraction) {
    const bool second = options_.integrator == Integrator::bdf2 && state_.hasPast;
    implied_ = second ? 2 * h_ / 3 : h_;
    startVelocities(second);  // v <- v, or (4 v - v1) / 3
    if (whole_) whole_->begin(state_);
    applyForces();        // v <- v + h W f
    predict(second);      // x <- x + h v, or (4 x - x1) / 3 + 2/3 h v
    movePins(fraction);   // x <- where the artist wants it
    beginSets(fraction);  // lambda <- 0
    for (const int s : contacts_) sets_[s]->strike(sweepOf(s), state_, workers_);
    if (whole_) {
        takeWhole();  // x <- where another method has it (methods/)
    } else {
        sweepColumns();  // x <- x + W J^T dlambda, set by set
        smooth();
    }
    finishSets();
    update(second);  // v <- (x - x1) / h, or (3 x - 4 x1 + x2) / 2 h
    for (const int s : contacts_) sets_[s]->rebound(state_);
    dampRates();
    state_.hasPast = true;
    ++state_.substep;
}

// Columns left to right, each top to bottom by order (S figure 11): its sets forward and then
// exactly backward, so that a sweep is self-adjoint in the masses and adds no energy; then its
// contacts likewise, which have the last word.
template <class Real>
void Solver<Real>::sweepColumns() {
    schedule_.plan(state_.substep, plan_);
    const bool turn = options_.sweeps == Sweeps::alternating && state_.substep % 2 == 1;
    const auto sweep = [&](std::span<const int> sets) {
        evaluate(sets, turn ? Direction::backward : Direction::forward);
        if (options_.sweeps == Sweeps::palindrome) evaluate(sets, Direction::backward);
    };
    column_ = 0;
    for (const SubstepPlan::Column& column : plan_.columns) {
        if (chebyshev_) chebyshev_->begin(column_, state_);
        sweep(plan_.constraints(column));
        if (chebyshev_) chebyshev_->mix(state_, workers_);
        sweep(plan_.contacts(column));
        ++column_;
    }
}

template <class Real>
void Solver<Real>::takeWhole() {
    schedule_.plan(state_.substep, plan_);
    const int columns = static_cast<int>(plan_.columns.size());
    WholeSubstep<Real> substep{state_, sets_, h_, implied_, columns, options_.sweeps, workers_};
    evaluations_ += whole_->take(substep);
    if (blaming_) blame("the method");
}

template <class Real>
void Solver<Real>::evaluate(std::span<const int> sets, Direction direction) {
    const bool back = direction == Direction::backward;
    // Forward and backward are one evaluation, noted once.
    const bool noted = log && !(back && options_.sweeps == Sweeps::palindrome);
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const int s = sets[back ? sets.size() - 1 - i : i];
        Constraint<Real>& set = *sets_[static_cast<std::size_t>(s)];
        set.project(sweepOf(s), direction, workers_);
        evaluations_ += set.size();
        if (noted) log->push_back({state_.substep, column_, s});
        if (blaming_) blame(setOptions_[static_cast<std::size_t>(s)].name);
    }
}

template <class Real>
Sweep<Real> Solver<Real>::sweepOf(int set) {
    Sweep<Real> sweep = options_.method == Method::nucleus
                            ? nucleusSweep<Real>(schedule_.strength(set))
                            : xpbdSweep<Real>(implied_);
    sweep.particles = &state_.particles[0].x.x;
    sweep.air = state_.hasAir ? &state_.air[0].v.x : nullptr;
    sweep.before = &state_.before[0].v.x;
    return sweep;
}

// Until neither leaves the other anything to do, or contacts have had the last word often enough:
// what one set of them parts, the next may press together. After five rounds a link of a whirling
// skirt was left 11 % too long in one frame of sixty. Where another method took the substep,
// contacts alone: it knows nothing of mending.
template <class Real>
void Solver<Real>::finishSets() {
    if (contacts_.empty()) return;
    constexpr int rounds = 20;
    for (int round = 0; round < rounds; ++round) {
        long mended = 0, parted = 0;
        for (int s = 0; s < static_cast<int>(sets_.size()) && !whole_; ++s)
            if (std::ranges::find(contacts_, s) == contacts_.end())
                mended += sets_[s]->finish(sweepOf(s), workers_);
        if (round > 0 && mended == 0 && contacts_.size() == 1) break;
        for (const int s : contacts_) parted += sets_[s]->finish(sweepOf(s), workers_);
        evaluations_ += mended + parted;
        if (parted == 0) break;
    }
    for (bool held = true; held;) {
        held = false;
        for (const int s : contacts_) held |= sets_[s]->holdBack(sweepOf(s), workers_) > 0;
    }
}

// Jacobi iterations: slower than the columns, but what error is left is spread out (V) [SC16]. Each
// correction is divided by the constraints at its busiest vertex, which keeps momentum; dividing
// vertex by vertex would not.
template <class Real>
void Solver<Real>::smooth() {
    for (int iteration = 0; iteration < options_.smoothing; ++iteration) {
        std::fill(sums_.begin(), sums_.end(), Padded<Real>{});
        for (std::size_t s = 0; s < sets_.size(); ++s) {
            Sweep<Real> sweep = sweepOf(static_cast<int>(s));
            sweep.out = &sums_[0].v.x;
            sets_[s]->smooth(sweep, workers_);
            evaluations_ += sets_[s]->size();
            if (blaming_) blame(setOptions_[s].name);
        }
        for (std::size_t i = 0; i < sums_.size(); ++i) state_.particles[i].d += sums_[i].v;
    }
    if (options_.smoothing > 0) evaluate(contacts_, Direction::forward);
}

template <class Real>
void Solver<Real>::dampRates() {
    for (std::size_t s = 0; s < sets_.size(); ++s) {
        if (setOptions_[s].damping <= 0) continue;
        Sweep<Real> sweep = sweepOf(static_cast<int>(s));
        sweep.strength = static_cast<Real>(1 - power(1 - setOptions_[s].damping, 24 * h_));
        sweep.out = &state_.velocity[0].v.x;
        sets_[s]->damp(sweep, workers_);
        if (options_.integrator == Integrator::bdf2) {
            sweep.out = &state_.lastVelocity[0].v.x;  // from which it extrapolates
            sets_[s]->damp(sweep, workers_);
        }
        if (blaming_) blame(setOptions_[s].name);
    }
}

template <class Real>
void Solver<Real>::applyForces() {
    for (const auto& force : forces_) force->prepare(state_, workers_);
    for (const auto& force : forces_) {
        force->apply(state_, time(), implied_, workers_);
        if (blaming_) blame(force->name());
    }
}

template <class Real>
void Solver<Real>::beginSets(double fraction) {
    for (const auto& set : sets_) set->begin({h_, fraction}, workers_);
}

template <class Real>
void Solver<Real>::frame() {
    const FlushDenormals flush;
    checkpoint_ = state_;
    const long evaluations = evaluations_, failures = failuresSoFar();
    const auto putBack = [&] {
        state_ = checkpoint_;
        evaluations_ = evaluations;
        blaming_ = false;
    };
    try {
        try {
            advance();
            failures_ = failuresSoFar() - failures;
            if (finite()) return;  // what is not a number stays none
        } catch (const std::invalid_argument&) {
            if (finite()) throw;  // contacts refuse what is not a number
        }
        // The run is deterministic, so the frame is taken again to see what breaks it.
        putBack();
        blaming_ = true;
        advance();
    } catch (...) {
        putBack();
        throw;
    }
    putBack();
    throw Diverged("something that did so only once", state_.substep);
}

template <class Real>
void Solver<Real>::advance() {
    const int n = options_.schedule.substeps, parts = std::min(options_.baseSteps, n);
    const auto timeIn = [&](int substeps) {
        return static_cast<double>(state_.substep + substeps) * h_;
    };
    for (const auto& force : forces_) force->beginFrame(state_, timeIn(0), timeIn(n), workers_);
    for (int part = 0, done = 0; part < parts; ++part) {
        const int length = static_cast<int>(n * (part + 1L) / parts) - done;
        beginBaseStep(timeIn(0), timeIn(length));
        for (int i = 1; i <= length; ++i) substep(static_cast<double>(i) / length);
        done += length;
    }
}

template <class Real>
void Solver<Real>::beginBaseStep(double t0, double t1) {
    for (Pins& pins : pins_)
        for (const auto& [t, positions] : {std::pair{t0, &pins.from}, {t1, &pins.to}}) {
            std::copy(pins.start.begin(), pins.start.end(), positions->begin());
            pins.animation(t, *positions);
        }
    for (const auto& set : sets_) set->beginFrame(t0, t1);
}

template <class Real>
long Solver<Real>::failuresSoFar() const {
    long sum = 0;
    for (const int s : contacts_) sum += sets_[s]->failures();
    return sum;
}

template <class Real>
bool Solver<Real>::finite() const {
    for (std::size_t i = 0; i < state_.particles.size(); ++i)
        if (!isFinite(state_.particles[i].d) || !isFinite(state_.velocity[i].v)) return false;
    return true;
}

template <class Real>
void Solver<Real>::blame(const std::string& culprit) const {
    if (!finite()) throw Diverged(culprit, state_.substep);
}

template <class Real>
void Solver<Real>::rewind() {
    state_ = start_;
    evaluations_ = 0;
}

template <class Real>
void Solver<Real>::restore(const State<Real>& state, long evaluations) {
    for (const auto* array :
         {&state.velocity, &state.before, &state.last, &state.lastVelocity, &state.air})
        if (array->size() != state_.velocity.size() ||
            state.particles.size() != state_.particles.size() ||
            state.tension.size() != state_.tension.size() ||
            (!state.disabled.empty() && state.disabled.size() + 1 != state_.particles.size()))
            throw std::invalid_argument("a state of another world cannot be restored");
    state_ = state;
    evaluations_ = evaluations;
}

template <class Real>
std::uint64_t Solver<Real>::hash() const {
    std::uint64_t hash = hashSeed;
    for (const Particle<Real>& p : state_.particles)
        if (!isFinite(p.x) || !isFinite(p.d)) throw std::logic_error("hash of a state not finite");
    for (const auto* array :
         {&state_.velocity, &state_.before, &state_.last, &state_.lastVelocity, &state_.air})
        for (const Padded<Real>& p : *array)
            if (!isFinite(p.v)) throw std::logic_error("hash of a state not finite");
    hash = hashOf(std::span<const Particle<Real>>(state_.particles), hash);
    hash = hashOf(std::span<const Padded<Real>>(state_.velocity), hash);
    if (options_.integrator == Integrator::bdf2) {
        hash = hashOf(std::span<const Padded<Real>>(state_.last), hash);
        hash = hashOf(std::span<const Padded<Real>>(state_.lastVelocity), hash);
    }
    for (const Real tension : state_.tension)
        if (!std::isfinite(tension)) throw std::logic_error("hash of a state not finite");
    if (!state_.tension.empty()) hash = hashOf(std::span<const Real>(state_.tension), hash);
    if (!state_.disabled.empty())
        hash = hashOf(std::span<const std::uint8_t>(state_.disabled), hash);
    // How the sheet stood in the last substep decides what its air takes in the next.
    if (state_.hasAir) hash = hashOf(std::span<const Padded<Real>>(state_.air), hash);
    return hash;
}

template class Solver<float>;
template class Solver<double>;

}  // namespace plait
