// What begins a run too near is parted where substeps begin, not where they end, so that velocities
// do not see it. Parted by the step it would fly on at ContactOptions::recovery, and so would all
// that links join to it: a taut rope that begins 0.1 mm within the drum it is wound about would be
// thrown off, and not grip for as long as it flies (tests/core/contacts/test_capstan.cpp).
//
// Only what begins the run: what a substep leaves too near under load has been pressed together by
// motion, and the next one may mend it by motion.
#include "solver.h"

#include <algorithm>
#include <cmath>

namespace plait {

// What links hold back takes longer than it would alone: twice as long has all of it in time.
// Pieces part by themselves, a little at a time (contacts/pieces/).
template <class Real>
void Solver<Real>::setUpParting() {
    constexpr double patience = 2, most = 1e15;
    parting_ = 0;
    if (contactSets_.empty() || !world_->pieces.empty()) return;
    implied_ = h_;
    std::vector<Padded<Real>> start(state_.particles.size());
    for (std::size_t i = 0; i < start.size(); ++i) start[i].v = state_.particles[i].d;
    double longest = 0;
    forContacts([&](auto& set, int s) {
        Sweep<Real> sweep = sweepOf(s);
        sweep.before = &start[0].v.x;
        set.begin({h_, 0}, workers_);
        longest = std::max(longest, set.partingTime(sweep, workers_));
    });
    if (!std::isfinite(longest)) return;
    parting_ = static_cast<long>(std::ceil(std::min(patience * longest / h_, most)));
    if (parting_ > 0) shift_.resize(start.size());
}

// A substep without forces and velocities, in which contacts part what is too near at `recovery`
// and all that others hold keeps its shape. Links have the last word on what contacts leave to
// later substeps: what they were stretched by would be velocity after all.
template <class Real>
void Solver<Real>::partStart(double fraction) {
    constexpr int rounds = 20;
    implied_ = h_;
    for (int i = 0; i < state_.count(); ++i) state_.before[i].v = state_.particles[i].d;
    for (const auto& set : sets_) set->begin({h_, fraction}, workers_);
    for (int round = 0; round < rounds; ++round) {
        carrying([&] {
            for (const int s : contacts_) {
                sets_[s]->project(sweepOf(s), Direction::forward, workers_);
                evaluations_ += sets_[s]->size();
            }
        });
        holdRates();
    }
    carrying([&] { finishSets(); });
    if (blaming_) blame("the parting of what begins too near");
    for (int i = 0; i < state_.count() && !state_.last.empty(); ++i)
        state_.last[i].v += state_.particles[i].d - state_.before[i].v;
}

// Takes out of the shift what would change any C but a contact's.
template <class Real>
void Solver<Real>::holdRates() {
    for (int i = 0; i < state_.count(); ++i)
        shift_[i].v = state_.particles[i].d - state_.before[i].v;
    for (int s = 0; s < static_cast<int>(sets_.size()); ++s) {
        if (std::ranges::find(contacts_, s) != contacts_.end()) continue;
        Sweep<Real> sweep = sweepOf(s);
        sweep.strength = 1;
        sweep.out = &shift_[0].v.x;
        sets_[s]->damp(sweep, workers_);
        evaluations_ += sets_[s]->size();
    }
    for (int i = 0; i < state_.count(); ++i)
        state_.particles[i].d = state_.before[i].v + shift_[i].v;
}

template class Solver<float>;
template class Solver<double>;

}  // namespace plait
