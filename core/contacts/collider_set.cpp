#include "collider_set.h"

#include "../world.h"
#include "friction.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace plait {
namespace {

// Cosine of the angle between two sides that count as one: what has gone round an edge by less
// slides on, and cuts off no more than 0.026 of its radius.
constexpr double sameSide = 0.9;
constexpr double gravity = 9.81;  // m/s^2: what rests approaches by its step
constexpr int grain = 256;        // vertices a thread takes at least

double mean(double a, double b) { return 0.5 * (a + b); }

template <class Real>
Vec<double> three(const Real* p) {
    return {double(p[0]), double(p[1]), double(p[2])};
}

template <class Real>
void put(Real* p, const Vec<double>& v) {
    p[0] = static_cast<Real>(v.x);
    p[1] = static_cast<Real>(v.y);
    p[2] = static_cast<Real>(v.z);
}

// w I - q q^T, how a vertex answers an impulse.
struct Answer {
    double w;
    Vec<double> q;
    Vec<double> of(const Vec<double>& impulse) const { return w * impulse - dot(q, impulse) * q; }
    double along(const Vec<double>& n) const { return dot(n, of(n)); }
};

}  // namespace

template <class Real>
ColliderSet<Real>::ColliderSet(const World& world, const std::vector<Collider>& colliders,
                               const std::vector<Surface>& surfaces, const ColliderOptions& options)
    : options_(options), surfaces_(surfaces) {
    for (const Collider& c : colliders) {
        const Placement at(c.motion ? c.motion(0) : c.frame, options.name);
        bodies_.push_back({c, at, at, {}, at, at, 0, 0});
        for (const Surface& s : surfaces)
            bouncy_ = bouncy_ || mean(c.restitution, s.restitution) > 0;
    }
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        for (int v = surfaces[s].vertices.first; v < surfaces[s].vertices.last; ++v) {
            const auto& radii = surfaces[s].radii;
            const double radius =
                radii.empty() ? surfaces[s].thickness : radii[v - surfaces[s].vertices.first];
            if (!world.pinned[v]) members_.push_back({v, static_cast<int>(s), radius});
        }
    rows_.resize(members_.size() * bodies_.size());
    free_.resize(rows_.size());
    kick_.resize(members_.size());
    bent_.resize(members_.size());
}

template <class Real>
void ColliderSet<Real>::beginFrame(double t0, double t1) {
    for (Body& body : bodies_) {
        if (!body.collider.motion) continue;
        body.from = body.now = Placement(body.collider.motion(t0), options_.name);
        body.to = Placement(body.collider.motion(t1), options_.name);
        body.turn = turnBetween(body.from, body.to);
    }
}

template <class Real>
void ColliderSet<Real>::begin(const Substep& substep, Workers&) {
    h_ = substep.h;
    ready_ = false;
    for (Body& body : bodies_) {
        if (!body.collider.motion) continue;
        body.before = body.now;
        body.now = between(body.from, body.to, body.turn, substep.frameFraction);
        const Placement &a = body.before, &b = body.now;
        const Vec<double> x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
        body.way = length(b.at - a.at);
        body.twist = squareRoot(dot(x, x) + dot(y, y) + dot(z, z));
    }
}

// N, times the square of the substep: what sticks is pulled by no more (S 7).
template <class Real>
double ColliderSet<Real>::hold(const Member& member, const Body& body) const {
    return mean(surfaces_[member.surface].stickiness, body.collider.stickiness) * h_ * h_;
}

// What begins inside, or too near, comes out no faster than `recovery` (CC15, CC17).
template <class Real>
double ColliderSet<Real>::gapOf(const Member& member, const Side& start) const {
    return std::min(member.thickness, start.distance + options_.recovery * h_);
}

template <class Real>
void ColliderSet<Real>::prepare(const Sweep<Real>& sweep, Workers& workers) {
    workers.forBlocks(static_cast<int>(members_.size()), grain, [&](int begin, int end) {
        for (int m = begin; m < end; ++m) {
            const Member& member = members_[m];
            bent_[m] = 0;
            const Vec<double> start = three(sweep.particles + 8 * member.vertex) +
                                      three(sweep.before + 4 * member.vertex);
            for (std::size_t b = 0; b < bodies_.size(); ++b) {
                const Body& body = bodies_[b];
                const Vec<double> p = body.before.own(start);
                const double distance = sideOf(body.collider.solid, p).distance;
                const bool sticks = distance <= 1.05 * member.thickness && hold(member, body) > 0;
                const double room = distance - member.thickness - body.way - body.twist * length(p);
                rows_[m * bodies_.size() + b] = {};
                free_[m * bodies_.size() + b] = sticks || room <= 0 ? 0 : room * room;
            }
        }
    });
    ready_ = true;
}

// Where the vertex is nearest now, unless it has gone in, or through, on another side: then it
// stays in front of where it went in. What is convex is all behind either plane.
template <class Real>
auto ColliderSet<Real>::touch(const Member& member, const Body& body, const Vec<double>& start,
                              const Vec<double>& end) const -> Plane {
    const Solid& solid = body.collider.solid;
    const Side from = sideOf(solid, start), now = sideOf(solid, end);
    const double gap = gapOf(member, from);
    const auto planeOf = [gap](const Side& side, const Vec<double>& x) {
        return Plane{side.normal, dot(side.normal, x) - side.distance + gap};
    };
    const Vec<double> way = end - start;
    double t = 0;
    if (from.distance > 0) {
        if (4 * dot(way, way) < from.distance * from.distance) return planeOf(now, end);
        const auto met = reaches(solid, start, end, 0.5 * std::min(gap, from.distance));
        if (!met) return planeOf(now, end);
        t = *met;
    }
    const Vec<double> in = start + t * way;
    const Side met = sideOf(solid, in);
    const bool same = now.distance <= gap && dot(met.normal, now.normal) > sameSide;
    return same ? planeOf(now, end) : planeOf(met, in);
}

// True if it was pushed.
template <class Real>
bool ColliderSet<Real>::part(const Sweep<Real>& sweep, int m, std::size_t b) {
    Row& row = rows_[m * bodies_.size() + b];
    const Member& member = members_[m];
    Real* const p = sweep.particles + 8 * member.vertex;
    const Vec<double> now = three(p + 4), before = three(sweep.before + 4 * member.vertex);
    const Vec<double> way = now - before;
    if (row.push == 0 && dot(way, way) < free_[m * bodies_.size() + b]) return false;

    const Body& body = bodies_[b];
    const Vec<double> start = body.before.own(three(p) + before);
    const Vec<double> end = body.now.own(three(p) + now);
    Plane plane = touch(member, body, start, end);
    // What lets go does so the way it was pushed: the nearest side may be another by now.
    if (row.push != 0 && plane.value(end) >= 0) plane = row.plane;
    const double held = hold(member, body);
    const bool sticks =
        held > 0 && sideOf(body.collider.solid, start).distance <= 1.05 * member.thickness;
    if (row.push == 0 && !sticks && plane.value(end) >= 0) return false;
    row.plane = plane;
    const Answer answer{double(p[3]), sweep.air
                                          ? body.now.ownWay(three(sweep.air + 4 * member.vertex))
                                          : Vec<double>{}};
    const double push = std::max(sticks ? -held : 0.0,
                                 row.push - divide(plane.value(end), answer.along(plane.normal)));
    Vec<double> moved = answer.of((push - row.push) * plane.normal);
    const bool pushed = push > row.push;
    row.push = push;

    const Surface& s = surfaces_[member.surface];
    const Collider& c = body.collider;
    const Friction friction(c.staticFriction, s.staticFriction, c.dynamicFriction,
                            s.dynamicFriction);
    Vec<double> slip = end + moved - start;
    slip -= dot(slip, plane.normal) * plane.normal;
    const double slipped = length(slip);
    if (friction && slipped > 0) {
        const Vec<double> grip =
            friction.grip(row.grip, slip, answer.along((1 / slipped) * slip), plane.normal,
                          std::max(push, 0.0) + (sticks ? held : 0));
        moved += answer.of(grip - row.grip);
        row.grip = grip;
    }
    put(p + 4, now + body.now.worldWay(moved));
    return pushed;
}

template <class Real>
void ColliderSet<Real>::project(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
    if (!ready_) prepare(sweep, workers);
    const std::size_t count = bodies_.size();
    workers.forBlocks(static_cast<int>(members_.size()), grain, [&](int begin, int end) {
        for (int m = begin; m < end; ++m)
            for (std::size_t b = 0; b < count; ++b)
                part(sweep, m, direction == Direction::forward ? b : count - 1 - b);
    });
}

template <class Real>
long ColliderSet<Real>::finish(const Sweep<Real>& sweep, Workers& workers) {
    std::atomic<long> pushed{0};
    workers.forBlocks(static_cast<int>(members_.size()), grain, [&](int begin, int end) {
        long count = 0;
        for (int m = begin; m < end; ++m)
            for (std::size_t b = 0; b < bodies_.size(); ++b) count += part(sweep, m, b);
        pushed += count;
    });
    return pushed;
}

// Bends the path at the first impact that it meets. The speed of an impact is that of its time, as
// in impacts.cpp.
template <class Real>
bool ColliderSet<Real>::strike(const Member& member, Path& path) const {
    const Surface& s = surfaces_[member.surface];
    const double least = std::max(options_.bounceThreshold, 2 * gravity * h_) * h_;
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
                               Workers& workers) {
    if (!bouncy_) return;
    prepare(sweep, workers);
    constexpr int limit = 8;
    workers.forBlocks(static_cast<int>(members_.size()), grain, [&](int begin, int end) {
        for (int m = begin; m < end; ++m) {
            const int v = members_[m].vertex;
            Real* const p = sweep.particles + 8 * v;
            const Vec<double> base = three(p), before = three(sweep.before + 4 * v);
            Path path{.start = base + before, .end = base + three(p + 4)};
            const Vec<Real>&was = state.before[v].v, &earlier = state.last[v].v;
            if (state.hasPast)
                path.gain = path.end - path.start - (three(&was.x) - three(&earlier.x));
            int bounces = 0;
            while (bounces < limit && strike(members_[m], path)) ++bounces;
            if (bounces == 0) continue;
            bent_[m] = 1;
            kick_[m] = (1 / h_) * (base + before - path.start);
            put(p + 4, path.end - base);
        }
    });
}

// The first-order velocity and a past that continues it, so that BDF2 extrapolates no bounce.
template <class Real>
void ColliderSet<Real>::rebound(State<Real>& state) const {
    for (std::size_t m = 0; m < members_.size(); ++m) {
        if (!bent_[m]) continue;
        const int v = members_[m].vertex;
        const Vec<Real> d = state.particles[v].d;
        Vec<Real> velocity{};
        put(&velocity.x, (1 / h_) * (three(&d.x) - three(&state.last[v].v.x)) + kick_[m]);
        state.velocity[v].v = state.lastVelocity[v].v = velocity;
        state.last[v].v = d - static_cast<Real>(h_) * velocity;
    }
}

template <class Real>
void ColliderSet<Real>::markTouched(std::vector<std::uint8_t>& touched) const {
    for (std::size_t r = 0; r < rows_.size(); ++r)
        touched[members_[r / bodies_.size()].vertex] |= rows_[r].push != 0;
}

template class ColliderSet<float>;
template class ColliderSet<double>;

}  // namespace plait
