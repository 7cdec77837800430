#include "grain_set.h"

#include "../numbers/convert.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plait {
namespace {

constexpr int grain = 128;

// Part of what a pair has slipped that it takes back in a substep. It remembers no more than what
// two that rest overlap: farther it has slid. (A pair that slid once in a substep must not forget
// all: pushes that have not converged let each slide now and then.)
constexpr double returned = 0.2;

// How far it has come in the substep, m.
template <class Real>
Vec<Real> wayOf(const Sweep<Real>& sweep, int v) {
    const Real *const d = sweep.particles + 8L * v + 4, *const was = sweep.before + 4L * v;
    return {d[0] - was[0], d[1] - was[1], d[2] - was[2]};
}

template <class Real>
Vec<Real> slipOf(const Sweep<Real>& sweep, int a, int b) {
    return wayOf(sweep, a) - wayOf(sweep, b);
}

}  // namespace

template <class Real>
GrainSet<Real>::GrainSet(const World& world, const Grains& grains)
    : grains_(grains), origin_(as<Real>(world.start[grains.vertices.first])) {
    const auto n = static_cast<std::size_t>(grains.vertices.size());
    for (std::size_t i = 0; i < n; ++i)
        radii_.push_back(static_cast<Real>(grains.radii.empty() ? grains.radius : grains.radii[i]));
    largest_ = std::ranges::max(radii_);
    for (int v = grains.vertices.first; v < grains.vertices.last; ++v)
        spare_.push_back(world.isSpare(v));
    start_.assign(n + 1, 0);
    touching_.assign(n, 0);
    moves_.resize(n);
    found_.resize(n);
}

template <class Real>
void GrainSet<Real>::project(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
    if (!std::exchange(looked_, true)) {
        look(sweep, workers);
        recall(sweep, workers);
    }
    if (grains_.averaging == Averaging::inTurn) {
        sweepPairs(sweep, direction, workers);
        return;
    }
    // What moves each is found from where all are, and only then do they move; so forward and
    // backward are the same, and one of them is an evaluation.
    if (direction == Direction::backward && std::exchange(evaluated_, false)) return;
    evaluated_ = direction == Direction::forward;
    moveAtOnce(sweep, workers);
}

template <class Real>
void GrainSet<Real>::moveAtOnce(const Sweep<Real>& sweep, Workers& workers) {
    const int count = grains_.vertices.size();
    const auto each = [&](int i, const auto& visit) {
        for (int k = start_[i]; k < start_[i + 1]; ++k) {
            const Near found = near(sweep, i, neighbors_[k]);
            if (acts(found, k)) visit(k, found);
        }
    };
    workers.forBlocks(count, grain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            touching_[i] = 0;
            each(i, [&](int, const Near&) { ++touching_[i]; });
        }
    });
    workers.forBlocks(count, grain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            moves_[i] = {};
            each(i, [&](int k, const Near& found) {
                const int j = neighbors_[k];
                moves_[i] +=
                    partOf(sweep, i, j, found.normal) * exchange(sweep, i, k, found, share(i, j));
            });
        }
    });
    move(sweep, workers);
}

template <class Real>
void GrainSet<Real>::move(const Sweep<Real>& sweep, Workers& workers) {
    workers.forBlocks(grains_.vertices.size(), grain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            Real* const d = sweep.particles + 8L * (grains_.vertices.first + i) + 4;
            d[0] += moves_[i].x, d[1] += moves_[i].y, d[2] += moves_[i].z;
        }
    });
}

// A pair that touched begins with what it pushed and rubbed.
template <class Real>
void GrainSet<Real>::recall(const Sweep<Real>& sweep, Workers& workers) {
    const Real part = 1 / perSquare_;
    workers.forBlocks(grains_.vertices.size(), grain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            moves_[i] = {};
            for (int k = start_[i]; k < start_[i + 1]; ++k) {
                const int j = neighbors_[k];
                const auto known = PairMemories<Real>::of(sweep.keptIntegers, sweep.kept,
                                                          std::min(i, j), std::max(i, j));
                if (!known) continue;
                const Vec<Real> normal = near(sweep, i, j).normal;
                const Real sign = i < j ? Real(1) : Real(-1);
                const auto across = [&](const Vec<Real>& a) { return a - dot(a, normal) * normal; };
                touch_[k] = {.pushed = part * known->push,
                             .rubbed = (sign * part) * across(known->rub),
                             .back = (sign * static_cast<Real>(returned)) * across(known->slip)};
                moves_[i] +=
                    partOf(sweep, i, j, normal) * (touch_[k].pushed * normal + touch_[k].rubbed);
            }
        }
    });
    move(sweep, workers);
}

template <class Real>
PairMemory<Real> GrainSet<Real>::memoryOf(const Sweep<Real>& sweep, int i, int k,
                                          const std::optional<PairMemory<Real>>& old) const {
    const Touch& touch = touch_[k];
    PairMemory<Real> now{perSquare_ * touch.pushed, perSquare_ * touch.rubbed, {}};
    if (!old) return now;
    const int first = grains_.vertices.first;
    now.slip = (1 - static_cast<Real>(returned)) * old->slip +
               slipOf(sweep, first + i, first + neighbors_[k]) + touch.back;
    const Real far = length(now.slip),
               most = static_cast<Real>(grains_.slop) * (radii_[i] + radii_[neighbors_[k]]);
    if (far > most) now.slip = (most / far) * now.slip;
    return now;
}

template <class Real>
void GrainSet<Real>::settle(State<Real>& state, Drawer<Real>& kept, double, double) {
    Sweep<Real> sweep{};
    sweep.particles = &state.particles[0].x.x;
    sweep.before = &state.before[0].v.x;
    std::vector<typename PairMemories<Real>::Partner> now;
    for (int i = 0; i < grains_.vertices.size(); ++i) {
        now.clear();
        for (int k = start_[i]; k < start_[i + 1]; ++k) {
            const int j = neighbors_[k];
            if (j < i || !(touch_[k].pushed > 0)) continue;
            const auto old =
                PairMemories<Real>::of(kept.integers.data(), kept.numbers.data(), i, j);
            now.emplace_back(j, memoryOf(sweep, i, k, old));
        }
        PairMemories<Real>::write(kept, i, now);
    }
}

template <class Real>
void GrainSet<Real>::sweepPairs(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
    const bool forward = direction == Direction::forward;
    for (int n = 0; n < mostColors; ++n) {
        const int c = forward ? n : mostColors - 1 - n, first = colors_[c];
        const int count = colors_[c + 1] - first, together = c + 1 < mostColors ? grain : count;
        workers.forBlocks(count, std::max(1, together), [&](int begin, int end) {
            for (int p = begin; p < end; ++p) {
                const auto [i, k] = pairs_[first + (forward ? p : count - 1 - p)];
                pushPair(sweep, i, k);
            }
        });
    }
}

template <class Real>
void GrainSet<Real>::pushPair(const Sweep<Real>& sweep, int i, int k) {
    const int j = neighbors_[k], first = grains_.vertices.first;
    const Near found = near(sweep, i, j);
    if (!acts(found, k)) return;
    touching_[i] = touching_[j] = 1;
    const Vec<Real> by = exchange(sweep, i, k, found, 1);
    const auto shift = [&](int v, const Vec<Real>& way) {
        Real* const d = sweep.particles + 8L * (first + v) + 4;
        d[0] += way.x, d[1] += way.y, d[2] += way.z;
    };
    shift(i, partOf(sweep, i, j, found.normal) * by);
    shift(j, -partOf(sweep, j, i, -found.normal) * by);
}

template <class Real>
typename GrainSet<Real>::Near GrainSet<Real>::near(const Sweep<Real>& sweep, int i, int j) const {
    const int first = grains_.vertices.first;
    const Vec<Real> apart = at(sweep, i) - at(sweep, j);
    const Real reach = radii_[i] + radii_[j], gap = length(apart) - reach;
    const Real began = length(apart - slipOf(sweep, first + i, first + j)) - reach;
    const Real rest = -static_cast<Real>(grains_.slop) * reach;
    const Real wanted = began < rest ? std::min(rest, began + parts_) : std::min(Real(0), began);
    return {divide(Real(1), length(apart)) * apart, gap, wanted};
}

template <class Real>
bool GrainSet<Real>::acts(const Near& near, int k) const {
    const bool clings = grains_.attraction > 0 && near.gap > 0;
    return near.gap < near.wanted || touch_[k].pushed > 0 ||
           (clings && near.gap < static_cast<Real>(grains_.cling));
}

// By what a correction is divided.
template <class Real>
Real GrainSet<Real>::share(int i, int j) const {
    if (grains_.averaging == Averaging::none) return 1;
    const int of =
        grains_.averaging == Averaging::grain ? touching_[i] : std::max(touching_[i], touching_[j]);
    return Real(1) / static_cast<Real>(of);
}

// Of a pair's correction what is i's.
template <class Real>
Real GrainSet<Real>::partOf(const Sweep<Real>& sweep, int i, int j, const Vec<Real>& normal) const {
    const int first = grains_.vertices.first;
    const Real wi = sweep.particles[8L * (first + i) + 3],
               wj = sweep.particles[8L * (first + j) + 3];
    if (grains_.shock == 0) return divide(wi, wi + wj);
    const Real x = static_cast<Real>(
        std::clamp(grains_.shock * dot(as<double>(normal), grains_.up), -1.0, 1.0));
    const Real heavier = 1 + x * (1 + x * (Real(0.5) + x / 6));
    return divide(heavier * wi, heavier * wi + wj);
}

// m: how i moves against neighbour k. What a pair has pushed and rubbed in this substep is known to
// both alike: a push may be taken back and no more, and friction has all of it as its bound. Those
// in one place are left to others.
template <class Real>
Vec<Real> GrainSet<Real>::exchange(const Sweep<Real>& sweep, int i, int k, const Near& near,
                                   Real share) {
    const int first = grains_.vertices.first;
    const Vec<Real>& normal = near.normal;
    const Real part = share * static_cast<Real>(grains_.weight);
    Touch& touch = touch_[k];
    if (near.gap > 0 && touch.pushed == 0)
        return (part * static_cast<Real>(grains_.attraction) * -near.gap) * normal;
    const Real wanted = part * static_cast<Real>(grains_.repulsion) * (near.wanted - near.gap);
    const Real push = std::max(wanted, -touch.pushed);
    touch.pushed += push;
    const Vec<Real> slip = slipOf(sweep, first + i, first + neighbors_[k]) + touch.back;
    Vec<Real> rubbed = touch.rubbed - part * (slip - dot(slip, normal) * normal);
    rubbed -= dot(rubbed, normal) * normal;
    const Real most = length(rubbed);
    if (most > static_cast<Real>(grains_.staticFriction) * touch.pushed)
        rubbed = std::min(Real(1),
                          divide(static_cast<Real>(grains_.dynamicFriction) * touch.pushed, most)) *
                 rubbed;
    const Vec<Real> rub = rubbed - touch.rubbed;
    touch.rubbed = rubbed;
    return push * normal + rub;
}

template <class Real>
void GrainSet<Real>::markTouched(std::vector<std::uint8_t>& touched) const {
    for (std::size_t i = 0; i < touching_.size(); ++i)
        if (touching_[i] > 0) touched[grains_.vertices.first + i] = 1;
}

template class GrainSet<float>;
template class GrainSet<double>;

}  // namespace plait
