#include "grain_set.h"

#include "../numbers/convert.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plait {
namespace {

constexpr int grain = 128;

template <class Real>
Vec<Real> at(const Sweep<Real>& sweep, int v, const Vec<Real>& origin) {
    const Real* const p = sweep.particles + 8L * v;
    return {(p[0] - origin.x) + p[4], (p[1] - origin.y) + p[5], (p[2] - origin.z) + p[6]};
}

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

// Jacobi: what moves each is found from where all are, and only then do they move; so forward and
// backward are the same, and one of them is an evaluation.
template <class Real>
void GrainSet<Real>::project(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
    if (direction == Direction::backward && std::exchange(evaluated_, false)) return;
    evaluated_ = direction == Direction::forward;
    if (!std::exchange(looked_, true)) look(sweep, workers);
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
            each(i, [&](int k, const Near& found) { moves_[i] += correction(sweep, i, k, found); });
        }
    });
    workers.forBlocks(count, grain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            Real* const d = sweep.particles + 8L * (grains_.vertices.first + i) + 4;
            d[0] += moves_[i].x, d[1] += moves_[i].y, d[2] += moves_[i].z;
        }
    });
}

template <class Real>
bool GrainSet<Real>::mayMeet(int i, int j) const {
    return i != j && (grains_.pieces.empty() || grains_.pieces[i] < 0 ||
                      grains_.pieces[i] != grains_.pieces[j]);
}

template <class Real>
void GrainSet<Real>::look(const Sweep<Real>& sweep, Workers& workers) {
    const int first = grains_.vertices.first, count = grains_.vertices.size();
    present_.clear();
    for (int i = 0; i < count; ++i)
        if (!spare_[i] || sweep.particles[8L * (first + i) + 3] > 0) present_.push_back(i);
    const Real scale = static_cast<Real>(grains_.searchScale);
    const auto place = [&](int n) { return at(sweep, first + present_[n], origin_); };
    cells_.sort(static_cast<int>(present_.size()),
                2 * scale * largest_ + static_cast<Real>(grains_.cling), place, workers);
    for (std::vector<int>& found : found_) found.clear();
    workers.forBlocks(cells_.count(), grain, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            const int i = present_[cells_.order()[s]];
            cells_.around(cells_.point(s), [&](int other) {
                const int j = present_[cells_.order()[other]];
                const Real reach =
                    scale * (radii_[i] + radii_[j]) + static_cast<Real>(grains_.cling);
                const Vec<Real> apart = cells_.point(s) - cells_.point(other);
                if (mayMeet(i, j) && dot(apart, apart) < reach * reach) found_[i].push_back(j);
            });
            keepNearest(i, found_[i], sweep);
        }
    });
    neighbors_.clear();
    for (int i = 0; i < count; ++i) {
        neighbors_.insert(neighbors_.end(), found_[i].begin(), found_[i].end());
        start_[i + 1] = static_cast<int>(neighbors_.size());
    }
    touch_.assign(neighbors_.size(), {});
}

template <class Real>
void GrainSet<Real>::keepNearest(int i, std::vector<int>& found, const Sweep<Real>& sweep) const {
    const auto most = static_cast<std::size_t>(grains_.mostNeighbours);
    if (most == 0 || found.size() <= most) return;
    std::ranges::sort(found, {}, [&](int j) { return std::pair(near(sweep, i, j).gap, j); });
    found.resize(most);
}

template <class Real>
typename GrainSet<Real>::Near GrainSet<Real>::near(const Sweep<Real>& sweep, int i, int j) const {
    const int first = grains_.vertices.first;
    const Vec<Real> apart = at(sweep, first + i, origin_) - at(sweep, first + j, origin_);
    const Real reach = radii_[i] + radii_[j], gap = length(apart) - reach;
    const Real began = length(apart - slipOf(sweep, first + i, first + j)) - reach;
    return {apart, gap, std::min(Real(0), began + parts_)};
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

// Of i, by neighbour k. What a pair has pushed and rubbed in this substep is known to both alike: a
// push may be taken back and no more, and friction has all of it as its bound. Those in one place
// are left to others.
template <class Real>
Vec<Real> GrainSet<Real>::correction(const Sweep<Real>& sweep, int i, int k, const Near& near) {
    const int first = grains_.vertices.first, j = neighbors_[k];
    const Real wi = sweep.particles[8L * (first + i) + 3],
               wj = sweep.particles[8L * (first + j) + 3];
    const Vec<Real> normal = divide(Real(1), length(near.apart)) * near.apart;
    Real own = divide(wi, wi + wj);
    if (grains_.shock > 0) {
        const Real x = static_cast<Real>(
            std::clamp(grains_.shock * dot(as<double>(normal), grains_.up), -1.0, 1.0));
        const Real heavier = 1 + x * (1 + x * (Real(0.5) + x / 6));
        own = divide(heavier * wi, heavier * wi + wj);
    }
    const Real part = share(i, j) * static_cast<Real>(grains_.weight);
    if (near.gap > 0 && touch_[k].pushed == 0)
        return (own * part * static_cast<Real>(grains_.attraction) * -near.gap) * normal;
    Touch& touch = touch_[k];
    const Real wanted = part * static_cast<Real>(grains_.repulsion) * (near.wanted - near.gap);
    const Real push = std::max(wanted, -touch.pushed);
    touch.pushed += push;
    const Vec<Real> slip = slipOf(sweep, first + i, first + j),
                    before = touch.rubbed - dot(touch.rubbed, normal) * normal;
    Vec<Real> rubbed = before - part * (slip - dot(slip, normal) * normal);
    const Real most = length(rubbed);
    if (most > static_cast<Real>(grains_.staticFriction) * touch.pushed)
        rubbed = std::min(Real(1),
                          divide(static_cast<Real>(grains_.dynamicFriction) * touch.pushed, most)) *
                 rubbed;
    const Vec<Real> rub = rubbed - before;
    touch.rubbed = rubbed;
    return own * (push * normal + rub);
}

template <class Real>
void GrainSet<Real>::markTouched(std::vector<std::uint8_t>& touched) const {
    for (std::size_t i = 0; i < touching_.size(); ++i)
        if (touching_[i] > 0) touched[grains_.vertices.first + i] = 1;
}

template class GrainSet<float>;
template class GrainSet<double>;

}  // namespace plait
