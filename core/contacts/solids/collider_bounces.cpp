// Bounces off colliders: impacts bend paths before the columns, as in impacts.h.
#include "../matter/reals.h"
#include "collider_set.h"

#include <algorithm>
#include <atomic>

namespace plait {
namespace {

constexpr int grain = 256;  // vertices a thread takes at least

}  // namespace

// Bends the path at the first impact that it meets. The speed of an impact is that of its time, as
// in impacts.cpp.
template <class Real>
bool ColliderSet<Real>::strike(const Member& member, Path& path) const {
    const Surface& s = surfaces_[member.surface];
    const double least = std::max(options_.bounceThreshold, 2 * gravity_ * h_) * h_;
    const Body* first = nullptr;
    double time = 2;
    for (const Body& body : bodies_) {
        if (mean(body.collider.restitution, s.restitution) <= 0) continue;
        const Vec<double> start = body.before.own(path.start), end = body.now.own(path.end);
        const Vec<double> way = end - start, from = start + path.from * way;
        const auto met = reaches(body.collider.solid, from, end, member.thickness);
        if (!met) continue;
        const double t = path.from + *met * (1 - path.from);
        const Vec<double> out = sideOf(body.collider.solid, start + t * way).normal;
        if (t >= time || !(dot(out, way) < -least)) continue;
        time = t;
        first = &body;
    }
    if (!first) return false;
    const Collider& c = first->collider;
    const Vec<double> start = first->before.own(path.start), end = first->now.own(path.end);
    const Vec<double> way = end - start, at = start + time * way;
    const Vec<double> normal = sideOf(c.solid, at).normal;
    const double approach = dot(way, normal), gain = dot(first->now.ownWay(path.gain), normal);
    const double speed = std::min(approach + (time - 0.5) * gain, 0.0);
    const double push = -(1 + mean(c.restitution, s.restitution)) * speed;
    const double sliding = std::clamp(mean(c.dynamicFriction, s.dynamicFriction), 0.0, 1.0);
    const Vec<double> along = way - approach * normal;
    const double grip = std::min(length(along), sliding * push);
    const Vec<double> goes = way + push * normal - divide(grip, length(along)) * along;
    path = {first->before.world(at - time * goes), first->now.world(at + (1 - time) * goes),
            path.gain, time, true};
    return true;
}

template <class Real>
void ColliderSet<Real>::strike(const Sweep<Real>& sweep, const State<Real>& state,
                               const Drawer<Real>&, Workers& workers) {
    if (!bouncy_) return;
    prepare(sweep, workers);
    constexpr int limit = 8;
    std::atomic<long> cut{0};
    workers.forBlocks(static_cast<int>(members_.size()), grain, [&](int begin, int end) {
        for (int m = begin; m < end; ++m) {
            const int v = members_[m].vertex;
            Real* const p = sweep.particles + 8 * v;
            const Vec<double> base = three(p), before = three(sweep.before + 4 * v);
            Path path{.start = base + before, .end = base + three(p + 4)};
            if (state.hasPast)
                path.gain = path.end - path.start -
                            (three(&state.before[v].v.x) - three(&state.last[v].v.x));
            int bounces = 0;
            while (bounces < limit && strike(members_[m], path)) ++bounces;
            if (bounces == 0) continue;
            Path more = path;
            if (bounces == limit) cut += strike(members_[m], more);
            bent_[m] = 1;
            kick_[m] = (1 / h_) * (base + before - path.start);
            put(p + 4, path.end - base);
        }
    });
    failed_ += cut;
}

// The first-order velocity and a past that continues it, so that BDF2 extrapolates no bounce.
template <class Real>
void ColliderSet<Real>::rebound(State<Real>& state, Drawer<Real>&) const {
    for (std::size_t m = 0; m < members_.size(); ++m) {
        if (!bent_[m]) continue;
        const int v = members_[m].vertex;
        const Vec<Real> d = state.particles[v].d;
        Vec<Real> velocity{};
        put(&velocity.x, (1 / h_) * (three(&d.x) - three(&state.last[v].v.x)) + kick_[m]);
        state.velocity[v].v = velocity;
        if (!state.lastVelocity.empty()) state.lastVelocity[v].v = velocity;
        state.last[v].v = d - static_cast<Real>(h_) * velocity;
    }
}

template bool ColliderSet<float>::strike(const Member&, Path&) const;
template bool ColliderSet<double>::strike(const Member&, Path&) const;
template void ColliderSet<float>::strike(const Sweep<float>&, const State<float>&,
                                         const Drawer<float>&, Workers&);
template void ColliderSet<double>::strike(const Sweep<double>&, const State<double>&,
                                          const Drawer<double>&, Workers&);
template void ColliderSet<float>::rebound(State<float>&, Drawer<float>&) const;
template void ColliderSet<double>::rebound(State<double>&, Drawer<double>&) const;

}  // namespace plait
