#include "solver.h"

#include "measure/hash.h"
#include "methods/sweeps/nucleus.h"
#include "methods/sweeps/xpbd.h"
#include "numbers/elementary.h"
#include "numbers/finite.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {

// One substep: S sections 5 and 6, XPBD (2016) algorithm 1, and V for the second order.
template <class Real>
void Solver<Real>::substep(double from, double fraction) {
    const bool second = options_.integrator == Integrator::bdf2 && state_.hasPast;
    if (partsStart()) partStart(from);  // x1, x2 <- apart, where the run began too near
    implied_ = second ? 2 * h_ / 3 : h_;
    startVelocities(second);  // v <- v, or (4 v - v1) / 3
    if (whole_) whole_->begin(state_);
    applyForces();  // v <- v + h W f
    do {
        predict(second);      // x <- x + h v, or (4 x - x1) / 3 + 2/3 h v
        movePins(fraction);   // x <- where the artist wants it
        beginSets(fraction);  // lambda <- 0
        carrying([&] {
            forContacts(
                [&](auto& set, int s) { set.strike(sweepOf(s), state_, drawerOf(s), workers_); });
        });
        if (whole_) {
            takeWhole();  // x <- where another method has it (methods/)
        } else {
            sweepColumns();  // x <- x + W J^T dlambda, set by set
            smooth();
        }
        carrying([&] { finishSets(); });
    } while (gaveWay());  // x <- x1, and again without what broke
    update(second);  // v <- (x - x1) / h, or (3 x - 4 x1 + x2) / 2 h
    forContacts([&](auto& set, int s) { set.rebound(state_, drawerOf(s)); });
    dampRates();
    for (std::size_t k = 0; k < sets_.size(); ++k)
        sets_[k]->settle(state_, state_.kept[k], time() + h_, h_);
    for (std::size_t f = 0; f < forces_.size(); ++f)
        forces_[f]->settle(state_, drawerOf(static_cast<int>(sets_.size() + f)), time() + h_, h_);
    state_.hasPast = true;
    ++state_.substep;
    comeApart(true);
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
        carrying([&] { sweep(plan_.contacts(column)); });
        ++column_;
    }
}

template <class Real>
void Solver<Real>::takeWhole() {
    schedule_.plan(state_.substep, plan_);
    const int columns = static_cast<int>(plan_.columns.size());
    WholeSubstep<Real> substep{state_,  state_.kept.back(), sets_,   h_, implied_,
                               columns, options_.sweeps,    workers_};
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
        if (blaming_) blame(nameOf(s));
    }
}

template <class Real>
Sweep<Real> Solver<Real>::sweepOf(int set) {
    Sweep<Real> sweep = options_.method == Method::nucleus
                            ? nucleusSweep<Real>(schedule_.strength(set))
                            : xpbdSweep<Real>(implied_);
    sweep.particles = &state_.particles[0].x.x;
    sweep.before = &state_.before[0].v.x;
    sweep.kept = drawerOf(set).numbers.data();
    sweep.keptIntegers = drawerOf(set).integers.data();
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
    auto finishing = std::ssize(contacts_);
    forContacts([&](const auto& set, int) { finishing -= !set.finishes(); });
    for (int round = 0; round < rounds; ++round) {
        long mended = 0, parted = 0;
        for (int s = 0; s < static_cast<int>(sets_.size()) && !whole_; ++s)
            if (std::ranges::find(contacts_, s) == contacts_.end())
                mended += sets_[s]->finish(sweepOf(s), workers_);
        if (round > 0 && mended == 0 && finishing == 1) break;
        for (const int s : contacts_) parted += sets_[s]->finish(sweepOf(s), workers_);
        evaluations_ += mended + parted;
        if (parted == 0) break;
    }
    for (bool held = true; held;) {
        held = false;
        forContacts([&](auto& set, int s) { held |= set.holdBack(sweepOf(s), workers_) > 0; });
    }
    forContacts([&](auto& set, int s) { set.conclude(sweepOf(s), workers_); });
}

// Whether something does not bear what contacts press with: then all is where the substep began.
template <class Real>
bool Solver<Real>::gaveWay() {
    if (world_->clusters < 0) return false;
    loads_.clear();
    forContacts([&](const auto& set, int) { set.addLoads(loads_); });
    bool gave = false;
    forContacts(
        [&](auto& set, int s) { gave |= set.giveWay(sweepOf(s), loads_, drawerOf(s), workers_); });
    for (int i = 0; gave && i < state_.count(); ++i) state_.particles[i].d = state_.before[i].v;
    return gave;
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
            if (blaming_) blame(nameOf(static_cast<int>(s)));
        }
        for (std::size_t i = 0; i < sums_.size(); ++i) state_.particles[i].d += sums_[i].v;
    }
    if (options_.smoothing > 0) carrying([&] { evaluate(contacts_, Direction::forward); });
}

template <class Real>
void Solver<Real>::dampRates() {
    for (std::size_t s = 0; s < sets_.size(); ++s) {
        const double damping = world_->sets[s].options.damping;
        if (damping <= 0) continue;
        Sweep<Real> sweep = sweepOf(static_cast<int>(s));
        sweep.strength = static_cast<Real>(1 - power(1 - damping, 24 * h_));
        sweep.out = &state_.velocity[0].v.x;
        sets_[s]->damp(sweep, workers_);
        if (options_.integrator == Integrator::bdf2) {
            sweep.out = &state_.lastVelocity[0].v.x;  // from which it extrapolates
            sets_[s]->damp(sweep, workers_);
        }
        if (blaming_) blame(nameOf(static_cast<int>(s)));
    }
}

template <class Real>
void Solver<Real>::applyForces() {
    for (std::size_t f = 0; f < forces_.size(); ++f)
        forces_[f]->prepare(state_, drawerOf(static_cast<int>(sets_.size() + f)), time(), h_,
                            workers_);
    for (const auto& force : forces_) {
        force->apply(state_, time(), implied_, workers_);
        if (blaming_) blame(force->name());
    }
}

template <class Real>
void Solver<Real>::beginSets(double fraction) {
    Vec<double> fall{0, 0, 0};
    for (const auto& force : forces_) fall += implied_ * implied_ * force->fall();
    for (const auto& set : sets_) set->begin({h_, fraction, fall, !partsStart()}, workers_);
}

template <class Real>
void Solver<Real>::frame() {
    const FlushDenormals flush;
    letGo();
    comeApart(false);
    checkpoint_ = state_;
    const long evaluations = evaluations_, failures = failuresSoFar();
    const auto putBack = [&] {
        state_ = checkpoint_;
        comeApart(false);
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
    frame_ = {timeIn(0), timeIn(n)};
    for (const auto& force : forces_) force->beginFrame(state_, frame_[0], frame_[1], workers_);
    for (int part = 0, done = 0; part < parts; ++part) {
        const int length = static_cast<int>(n * (part + 1L) / parts) - done;
        beginBaseStep(timeIn(0), timeIn(length));
        for (int i = 1; i <= length; ++i)
            substep(static_cast<double>(i - 1) / length, static_cast<double>(i) / length);
        done += length;
    }
}

template <class Real>
void Solver<Real>::beginBaseStep(double t0, double t1) {
    base_ = {t0, t1};
    for (Pins& pins : pins_)
        for (const auto& [t, positions] : {std::pair{t0, &pins.from}, {t1, &pins.to}}) {
            std::copy(pins.start.begin(), pins.start.end(), positions->begin());
            pins.animation(t, *positions);
        }
    for (const auto& set : sets_) set->beginFrame(t0, t1);
}

template <class Real>
long Solver<Real>::failuresSoFar() const {
    long sum = failuresBefore_;
    forContacts([&](const auto& set, int) { sum += set.failures(); });
    return sum;
}

template <class Real>
const std::string& Solver<Real>::nameOf(int set) const {
    return world_->sets[static_cast<std::size_t>(set)].options.name;
}

template <class Real>
bool Solver<Real>::finite() const {
    bool all = true;
    State<Real>::forArrays(state_, [&](const auto& array) { all = all && allFinite(array); });
    for (const Drawer<Real>& drawer : state_.kept) all = all && allFinite(drawer.numbers);
    return all;
}

template <class Real>
void Solver<Real>::blame(const std::string& culprit) const {
    if (!finite()) throw Diverged(culprit, state_.substep);
}

template <class Real>
void Solver<Real>::rewind() {
    setUp();
    evaluations_ = failures_ = 0;
}

template <class Real>
void Solver<Real>::restore(const State<Real>& state, long evaluations) {
    const auto sizesOf = [](const State<Real>& of) {
        std::vector<std::size_t> sizes;
        State<Real>::forArrays(of, [&](const auto& array) { sizes.push_back(array.size()); });
        sizes.push_back(of.born.size());
        for (const Drawer<Real>& drawer : of.kept)
            sizes.insert(sizes.end(), {drawer.numbers.size(), drawer.integers.size()});
        return sizes;
    };
    if (sizesOf(state) != sizesOf(state_))
        throw std::invalid_argument("a state of another world cannot be restored");
    state_ = state;
    evaluations_ = evaluations;
}

// `before` is what predict() makes anew, and of first order the past decides nothing but bounces.
template <class Real>
std::uint64_t Solver<Real>::hash() const {
    std::uint64_t hash = hashSeed;
    const auto add = [&](const auto& array) {
        if (!array.empty()) hash = hashOf(array, hash);
    };
    if (!finite()) throw std::logic_error("hash of a state not finite");
    add(state_.particles);
    add(state_.velocity);
    if (options_.integrator == Integrator::bdf2) {
        add(state_.last);
        add(state_.lastVelocity);
    }
    add(state_.id);
    add(state_.born);
    add(state_.cuts);
    for (const Drawer<Real>& drawer : state_.kept) {
        add(drawer.numbers);
        add(drawer.integers);
    }
    return hash;
}

template class Solver<float>;
template class Solver<double>;

}  // namespace plait
