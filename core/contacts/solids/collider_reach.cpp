// How far vertices may go before they can touch a collider: most are too far away to be looked at,
// for many substeps to come.
#include "../matter/reals.h"
#include "collider_set.h"

#include <algorithm>

namespace plait {
namespace {

// Part of a thickness beyond it within which something sticks.
constexpr double stickyPart = 0.05;
constexpr int grain = 256;  // vertices a thread takes at least

}  // namespace

template <class Real>
void ColliderSet<Real>::prepare(const Sweep<Real>& sweep, Workers& workers) {
    workers.forBlocks(static_cast<int>(members_.size()), grain, [&](int begin, int end) {
        for (int m = begin; m < end; ++m) {
            Reach& reach = reach_[m];
            bent_[m] = 0;
            if (reach.written)
                for (std::size_t b = 0; b < bodies_.size(); ++b) rows_[m * bodies_.size() + b] = {};
            reach.written = reach.measured = false;
            reach.clear = reach.room * reach.room;
            if (moving_ || reach.room <= 2 * stickyPart * members_[m].thickness) measure(sweep, m);
        }
    });
    ready_ = true;
}

// How far a vertex may go, body by body.
template <class Real>
void ColliderSet<Real>::measure(const Sweep<Real>& sweep, int m) {
    const Member& member = members_[m];
    const Vec<double> start =
        three(sweep.particles + 8 * member.vertex) + three(sweep.before + 4 * member.vertex);
    Reach& reach = reach_[m];
    reach.measured = true;
    reach.clear = reach.room = infinity;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Body& body = bodies_[b];
        const Vec<double> p = body.before.own(start);
        const double distance = sideOf(body.collider.solid, p).distance;
        const bool sticks =
            distance <= (1 + stickyPart) * member.thickness && hold(member, body) > 0;
        const double room = distance - member.thickness - body.way - body.twist * length(p);
        const double free = sticks || room <= 0 ? 0 : room * room;
        free_[m * bodies_.size() + b] = free;
        reach.clear = std::min(reach.clear, free);
        reach.room = std::min(reach.room, std::max(room, 0.0));
    }
}

// False: a vertex moved too little to come near any body, and was not pushed.
template <class Real>
bool ColliderSet<Real>::mayTouch(const Sweep<Real>& sweep, int m) {
    const int v = members_[m].vertex;
    const Vec<double> way = three(sweep.particles + 8 * v + 4) - three(sweep.before + 4 * v);
    if (dot(way, way) < reach_[m].clear) return false;
    if (!reach_[m].measured) measure(sweep, m);
    return !(dot(way, way) < reach_[m].clear);
}

template <class Real>
double ColliderSet<Real>::partingTime(const Sweep<Real>& sweep, Workers&) {
    double most = 0;
    for (const Member& member : members_)
        for (const Body& body : bodies_) {
            const Real* const p = sweep.particles + 8 * member.vertex;
            const Side at = sideOf(body.collider.solid, body.now.own(three(p) + three(p + 4)));
            most = std::max(most, lackOf(at.distance, member.thickness));
        }
    return divide(most, options_.recovery);
}

template void ColliderSet<float>::prepare(const Sweep<float>&, Workers&);
template void ColliderSet<double>::prepare(const Sweep<double>&, Workers&);
template void ColliderSet<float>::measure(const Sweep<float>&, int);
template void ColliderSet<double>::measure(const Sweep<double>&, int);
template bool ColliderSet<float>::mayTouch(const Sweep<float>&, int);
template bool ColliderSet<double>::mayTouch(const Sweep<double>&, int);
template double ColliderSet<float>::partingTime(const Sweep<float>&, Workers&);
template double ColliderSet<double>::partingTime(const Sweep<double>&, Workers&);

}  // namespace plait
