#include "collider_set.h"

#include "../../world.h"
#include "../checks.h"
#include "../friction.h"
#include "../matter/reals.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace plait {
namespace {

// Cosine of the angle between two sides that count as one: what has gone round an edge by less
// slides on, and cuts off no more than 0.026 of its radius.
constexpr double sameSide = 0.9;
constexpr int grain = 256;  // vertices a thread takes at least

Friction frictionOf(const Surface& s, const Collider& c) {
    return {c.staticFriction, s.staticFriction, c.dynamicFriction, s.dynamicFriction};
}

}  // namespace

template <class Real>
ColliderSet<Real>::ColliderSet(const World& world, const std::vector<Collider>& colliders,
                               const std::vector<Surface>& surfaces, const ColliderOptions& options)
    : options_(options), gravity_(world.gravity), surfaces_(surfaces) {
    for (const Collider& c : colliders) {
        const Placement at(c.motion ? c.motion(0) : c.frame, options.name);
        bodies_.push_back({c, at, at, {}, at, at, 0, 0});
        for (const Surface& s : surfaces)
            bouncy_ = bouncy_ || mean(c.restitution, s.restitution) > 0;
    }
    std::vector<bool> onTriangle(world.mass.size(), false);
    for (int t = 0; t < world.complex.count(2); ++t)
        for (const int v : world.complex.vertices(2, t)) onTriangle[v] = true;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        for (int v = surfaces[s].vertices.first; v < surfaces[s].vertices.last; ++v)
            if (!world.pinned[v])
                members_.push_back(
                    {v, static_cast<int>(s), thicknessAt(surfaces[s], v), !onTriangle[v]});
    rows_.resize(members_.size() * bodies_.size());
    free_.resize(rows_.size());
    reach_.resize(members_.size());
    kick_.resize(members_.size());
    bent_.resize(members_.size());
}

template <class Real>
void ColliderSet<Real>::beginFrame(double t0, double t1) {
    std::ranges::fill(reach_, Reach{.written = true});  // where vertices are may be another state's
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
    opens_ = substep.parts ? options_.recovery * h_ : 0;
    ready_ = false;
    moving_ = false;
    for (Body& body : bodies_) {
        if (!body.collider.motion) continue;
        body.before = body.now;
        body.now = between(body.from, body.to, body.turn, substep.frameFraction);
        const Placement &a = body.before, &b = body.now;
        const Vec<double> x = b.x - a.x, y = b.y - a.y, z = b.z - a.z;
        body.way = length(b.at - a.at);
        body.twist = squareRoot(dot(x, x) + dot(y, y) + dot(z, z));
        moving_ = moving_ || body.way > 0 || body.twist > 0;
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
    return std::min(member.thickness, start.distance + opens_);
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
    reach_[m].written = true;
    reach_[m].clear = 0;
    const double w = double(p[3]);
    const auto answerAlong = [w](const Vec<double>& n) { return dot(n, w * n); };
    const double push = std::max(sticks ? -held : 0.0,
                                 row.push - divide(plane.value(end), answerAlong(plane.normal)));
    Vec<double> moved = w * ((push - row.push) * plane.normal);
    const bool pushed = push > row.push;
    row.push = push;

    Vec<double> slip = end + moved - start;
    slip -= dot(slip, plane.normal) * plane.normal;
    const double slipped = length(slip);
    const Friction friction = frictionOf(surfaces_[member.surface], body.collider);
    if (friction && slipped > 0) {
        const double answers = answerAlong((1 / slipped) * slip);
        const double pressed = std::max(push, 0.0) + (sticks ? held : 0);
        const Vec<double> grip = friction.grip(row.grip, slip, answers, plane.normal, pressed);
        moved += w * (grip - row.grip);
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
            for (std::size_t b = 0; b < count && mayTouch(sweep, m); ++b)
                part(sweep, m, direction == Direction::forward ? b : count - 1 - b);
    });
}

// Whether a vertex moved too little to come near a body.
template <class Real>
bool ColliderSet<Real>::isFar(const Sweep<Real>& sweep, int m, std::size_t b) const {
    const int v = members_[m].vertex;
    const Vec<double> way = three(sweep.particles + 8 * v + 4) - three(sweep.before + 4 * v);
    return dot(way, way) < free_[m * bodies_.size() + b];
}

// From where to where a vertex goes in the substep, in the axes of a body.
template <class Real>
std::array<Vec<double>, 2> ColliderSet<Real>::wayOf(const Sweep<Real>& sweep, int m,
                                                    std::size_t b) const {
    const int v = members_[m].vertex;
    const Real* const p = sweep.particles + 8 * v;
    const Body& body = bodies_[b];
    return {body.before.own(three(p) + three(sweep.before + 4 * v)),
            body.now.own(three(p) + three(p + 4))};
}

// Whether a vertex came within a quarter of its gap: the rest of it gives way, as between other
// contacts, where lengths leave no room for both. What began inside comes out as slowly as it may.
template <class Real>
bool ColliderSet<Real>::passes(const Sweep<Real>& sweep, int m, std::size_t b) const {
    if (isFar(sweep, m, b)) return false;
    const Solid& solid = bodies_[b].collider.solid;
    const auto [start, end] = wayOf(sweep, m, b);
    const Side from = sideOf(solid, start);
    if (from.distance <= 0) return false;
    const double gap = leastPart * std::min(gapOf(members_[m], from), from.distance);
    return reaches(solid, start, end, gap).has_value();
}

// Whether a vertex came to be within a quarter of its thickness in this substep.
template <class Real>
bool ColliderSet<Real>::isPressed(const Sweep<Real>& sweep, int m, std::size_t b) const {
    if (isFar(sweep, m, b)) return false;
    const double least = leastPart * members_[m].thickness;
    const Solid& solid = bodies_[b].collider.solid;
    const auto [start, end] = wayOf(sweep, m, b);
    return sideOf(solid, end).distance < least && sideOf(solid, start).distance >= least;
}

// How often act(member, body) is true of those that pass.
template <class Real>
template <class Act>
long ColliderSet<Real>::whereItPasses(const Sweep<Real>& sweep, Workers& workers, const Act& act) {
    std::atomic<long> sum{0};
    workers.forBlocks(static_cast<int>(members_.size()), grain, [&](int begin, int end) {
        long count = 0;
        for (int m = begin; m < end; ++m)
            for (std::size_t b = 0; b < bodies_.size() && mayTouch(sweep, m); ++b)
                if (passes(sweep, m, b)) count += act(m, b);
        sum += count;
    });
    return sum;
}

template <class Real>
long ColliderSet<Real>::finish(const Sweep<Real>& sweep, Workers& workers) {
    return whereItPasses(sweep, workers, [&](int m, std::size_t b) { return part(sweep, m, b); });
}

// Where a collider moves over a vertex, going back would not keep it outside: then it has failed.
template <class Real>
long ColliderSet<Real>::holdBack(const Sweep<Real>& sweep, Workers& workers) {
    std::atomic<long> failed{0};
    const long held = whereItPasses(sweep, workers, [&](int m, std::size_t b) {
        Real* const d = sweep.particles + 8 * members_[m].vertex + 4;
        const std::array<Real, 3> was{d[0], d[1], d[2]};
        const bool moved = putBack(sweep, members_[m].vertex);
        if (moved && !passes(sweep, m, b)) return true;
        std::ranges::copy(was, d);
        ++failed;
        return false;
    });
    failed_ += failed;
    return held;
}

// Of a surface it is no failure before it is inside.
template <class Real>
void ColliderSet<Real>::conclude(const Sweep<Real>& sweep, Workers& workers) {
    std::atomic<long> pressed{0};
    workers.forBlocks(static_cast<int>(members_.size()), grain, [&](int begin, int end) {
        long count = 0;
        for (int m = begin; m < end; ++m) {
            if (mayTouch(sweep, m) && members_[m].isRound)
                for (std::size_t b = 0; b < bodies_.size(); ++b) count += isPressed(sweep, m, b);
            const int v = members_[m].vertex;
            const Vec<double> way =
                three(sweep.particles + 8 * v + 4) - three(sweep.before + 4 * v);
            // What is left of it, less what rounding may have added.
            const double left = reach_[m].room - (1 + 1e-6) * length(way);
            reach_[m].room = moving_ ? 0 : std::max(left, 0.0);
        }
        pressed += count;
    });
    failed_ += pressed;
}

template <class Real>
void ColliderSet<Real>::markTouched(std::vector<std::uint8_t>& touched) const {
    for (std::size_t r = 0; r < rows_.size(); ++r)
        touched[members_[r / bodies_.size()].vertex] |= rows_[r].push != 0;
}

template class ColliderSet<float>;
template class ColliderSet<double>;

}  // namespace plait
