// Where a run begins: what a solver makes of its world, when it is made and when it is rewound.
#include "constraints/constants.h"
#include "methods/methods.h"
#include "numbers/convert.h"
#include "numbers/finite.h"
#include "solver.h"

#include <cmath>

namespace plait {
namespace {

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
    : given_(std::move(world)),
      world_(given_),
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
    workers_.interrupt = options.interrupt;
    setUp();
}

template <class Real>
void Solver<Real>::setUp() {
    state_ = {};
    world_ = given_;
    releasedBy_ = -HUGE_VAL;
    apart_.clear();
    failuresBefore_ = 0;
    setUpState();
    setUpPins();
    setUpSets();
    setUpMethod();
    setUpDrawers();
    setUpChebyshev();
    takePast();
    setUpParting();
}

// All that knows what is pinned is made anew. Which releases have come follows from the time, so
// that a run that is resumed or rewound has the same.
template <class Real>
void Solver<Real>::letGo() {
    const double by = time() + h_ / 2;
    if (given_->releasesBy(by) == given_->releasesBy(releasedBy_)) return;
    releasedBy_ = by;
    remake();
    // Others keep theirs, which a set may have changed (Constraint::settle).
    for (std::size_t v = 0; v < world_->mass.size(); ++v) {
        Real& w = state_.particles[v].w;
        if (world_->pinned[v])
            w = 0;
        else if (w == 0 && (state_.born.empty() || state_.born[v] >= 0))
            w = static_cast<Real>(1 / world_->mass[v]);
    }
}

// What has come apart in the state and not yet in the world: all that knows which vertices there
// are is made anew. `now`: its copies begin where their vertices are; otherwise the state has them.
template <class Real>
void Solver<Real>::comeApart(bool now) {
    if (state_.cuts == apart_) return;
    const std::size_t before = now && world_->torn ? world_->torn->splits().size() : 0;
    remake();
    if (!now) return;
    for (const auto& [vertex, copy, cut] : world_->torn->splits().subspan(before)) {
        State<Real>::forArrays(state_, [&](auto& array) {
            if (!array.empty()) array[copy] = array[vertex];
        });
        state_.id[copy] = copy;
        state_.born[copy] = static_cast<std::int32_t>(state_.substep);
        for (const int v : {vertex, copy})
            state_.particles[v].w = static_cast<Real>(1 / world_->mass[v]);
    }
    for (const auto& set : sets_) set->beginFrame(base_[0], base_[1]);
    for (const auto& force : forces_) force->beginFrame(state_, frame_[0], frame_[1], workers_);
}

template <class Real>
void Solver<Real>::remake() {
    failuresBefore_ = failuresSoFar();
    world_ = std::make_shared<const World>(given_->releasedBy(releasedBy_).tornBy(state_.cuts));
    apart_ = state_.cuts;
    setUpSets();
    setUpMethod();
}

template <class Real>
void Solver<Real>::setUpMethod() {
    std::vector<NamedSet<Real>> named;
    for (std::size_t s = 0; s < sets_.size(); ++s)
        named.push_back({world_->sets[s].options.name, world_->sets[s].contact, sets_[s].get()});
    whole_ = makeWholeStep(options_, named, state_);
}

// What nobody in the run will read is not there.
template <class Real>
void Solver<Real>::setUpDrawers() {
    const bool bdf2 = options_.integrator == Integrator::bdf2;
    bool past = bdf2;
    state_.kept.resize(sets_.size() + forces_.size() + 1);
    for (std::size_t s = 0; s < sets_.size(); ++s) sets_[s]->furnish(state_.kept[s]);
    forContacts([&](const auto& set, int) { past = past || set.needsPast(); });
    for (std::size_t f = 0; f < forces_.size(); ++f)
        forces_[f]->furnish(state_.kept[sets_.size() + f]);
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
    if (world.spare.empty()) return;
    state_.id.resize(n, 0), state_.born.resize(n, 0);
    for (const Range& range : world.spare)
        for (int v = range.first; v < range.last; ++v) {
            state_.particles[v].w = 0;
            state_.id[v] = state_.born[v] = -1;
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

template class Solver<float>;
template class Solver<double>;

}  // namespace plait
