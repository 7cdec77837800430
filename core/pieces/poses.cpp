#include "poses.h"

#include "../numbers/convert.h"

namespace plait {
namespace {

// Three vertices far from each other and from one line: the triangle that is nearly the largest.
std::array<int, 3> baseOf(Range range, std::span<const Vec<double>> rest) {
    const auto farthest = [&](const auto& distance) {
        int best = range.first;
        for (int v = range.first; v < range.last; ++v)
            if (distance(v) > distance(best)) best = v;
        return best;
    };
    const int a = farthest([&](int v) { return length(rest[v] - rest[range.first]); });
    const int b = farthest([&](int v) { return length(rest[v] - rest[a]); });
    const int c =
        farthest([&](int v) { return length(cross(rest[v] - rest[a], rest[b] - rest[a])); });
    return {a, b, c};
}

// Its inverse, column by column.
Symmetric<double> inverseOf(const Symmetric<double>& a) {
    const Vec<double> x = a.solve({1, 0, 0}), y = a.solve({0, 1, 0}), z = a.solve({0, 0, 1});
    return {x.x, x.y, x.z, y.y, y.z, z.z};
}

// Trace of a less a.
Symmetric<double> momentOf(const Symmetric<double>& a) {
    Symmetric<double> moment = Symmetric<double>::diagonal(a.xx + a.yy + a.zz);
    moment.add(-1, a);
    return moment;
}

Body bodyOf(const World& world, Range range) {
    Body body{.vertices = range, .base = baseOf(range, world.rest)};
    double mass = 0, heavy = 0;
    bool pinned = false;
    for (int v = range.first; v < range.last; ++v) {
        mass += world.mass[v];
        body.centre += world.mass[v] * world.rest[v];
        pinned |= world.pinned[v] != 0;
    }
    body.centre = (1 / mass) * body.centre;
    Symmetric<double> second{};
    constexpr double firm = 1e6;
    for (int v = range.first; v < range.last; ++v) {
        const Vec<double> arm = world.rest[v] - body.centre;
        body.arm.push_back(arm);
        body.mass.push_back(world.pinned[v] ? firm * mass : world.mass[v]);
        second.addOuter(world.mass[v], arm);
        heavy += body.mass.back();
        body.heavy += body.mass.back() * arm;
    }
    body.heavy = (1 / heavy) * body.heavy;
    if (pinned) return body;
    body.inverseMass = 1 / mass;
    body.inverseInertia = inverseOf(momentOf(second));
    return body;
}

}  // namespace

Pieces::Pieces(const World& world, std::span<const Range> ranges) {
    if (ranges.empty()) return;
    of_.assign(world.rest.size(), -1);
    for (const Range& range : ranges) {
        for (int v = range.first; v < range.last; ++v) of_[v] = count();
        bodies_.push_back(bodyOf(world, range));
    }
}

// Newton's method on the rotation, from the frame of three vertices: quadratic, where dividing by
// the trace is linear, and slow for what is flat.
template <class At>
Pose Pieces::nearestPose(const Body& body, const At& at) const {
    const int first = body.vertices.first;
    const Vec<double> origin = at(first);
    Vec<double> centre{};
    double mass = 0;
    for (int i = 0; i < body.vertices.size(); ++i) {
        centre += body.mass[i] * (at(first + i) - origin);
        mass += body.mass[i];
    }
    centre = origin + (1 / mass) * centre;

    const auto frame = [&](const auto& where) {
        const auto& [a, b, c] = body.base;
        return frameOf(where(b) - where(a), where(c) - where(a));
    };
    Rotation turn = frame(at) * frame([&](int v) { return body.arm[v - first]; }).inverse();
    constexpr int rounds = 20;
    for (int round = 0; round < rounds; ++round) {
        Vec<double> torque{};
        Symmetric<double> second{};
        for (int i = 0; i < body.vertices.size(); ++i) {
            const Vec<double> arm = turn * (body.arm[i] - body.heavy);
            const Vec<double> is = at(first + i) - centre;
            torque += body.mass[i] * cross(arm, is);
            second.addOuter(body.mass[i] / 4, is + arm);  // of arm and is, its symmetric part
            second.addOuter(-body.mass[i] / 4, is - arm);
        }
        const Vec<double> w = momentOf(second).solve(torque);
        turn = straightened(turnBy(w) * turn);
        if (!(dot(w, w) > 1e-16)) break;  // the next would be its square
    }
    return {centre - turn * body.heavy, turn};
}

template <class Real>
Pose Pieces::poseOf(const Sweep<Real>& sweep, int piece) const {
    return nearestPose(bodies_[piece], [&](int v) {
        const Real* const p = sweep.particles + 8 * v;
        return three(p) + three(p + 4);
    });
}

template <class Real>
Pose Pieces::startOf(const Sweep<Real>& sweep, int piece) const {
    return nearestPose(bodies_[piece], [&](int v) {
        return three(sweep.particles + 8 * v) + three(sweep.before + 4 * v);
    });
}

template <class Real>
void Pieces::put(const Sweep<Real>& sweep, int piece, const Pose& pose) const {
    const Body& body = bodies_[piece];
    for (int i = 0; i < body.vertices.size(); ++i) {
        Real* const p = sweep.particles + 8 * (body.vertices.first + i);
        if (p[3] == Real(0)) continue;
        plait::put(p + 4, pose.centre + pose.turn * body.arm[i] - three(p));
    }
}

double yieldOf(const Body& body, const Pose& pose, const Vec<double>& lever, const Vec<double>& n) {
    const Vec<double> about = pose.turn.back(cross(lever, n));
    return body.inverseMass * dot(n, n) + dot(about, body.inverseInertia * about);
}

Pose pushed(const Body& body, const Pose& pose, const Vec<double>& lever,
            const Vec<double>& impulse) {
    const Vec<double> w = pose.turn * (body.inverseInertia * pose.turn.back(cross(lever, impulse)));
    return {pose.centre + body.inverseMass * impulse, straightened(turnBy(w) * pose.turn)};
}

PoseWay::PoseWay(const Pose& from, const Pose& to) : from_(from), way_(to.centre - from.centre) {
    const Rotation turn = to.turn * from.turn.inverse();
    const double cosine = 1 + turn.x.x + turn.y.y + turn.z.z;
    // By half a turn and more in a substep there is no telling about which axis.
    turn_ = (2 / (cosine > 1e-3 ? cosine : 1e-3)) *
            Vec<double>{turn.y.z - turn.z.y, turn.z.x - turn.x.z, turn.x.y - turn.y.x};
}

Pose PoseWay::at(double part) const {
    return {from_.centre + part * way_, turnBy(part * turn_) * from_.turn};
}

template Pose Pieces::startOf(const Sweep<float>&, int) const;
template Pose Pieces::startOf(const Sweep<double>&, int) const;
template Pose Pieces::poseOf(const Sweep<float>&, int) const;
template Pose Pieces::poseOf(const Sweep<double>&, int) const;
template void Pieces::put(const Sweep<float>&, int, const Pose&) const;
template void Pieces::put(const Sweep<double>&, int, const Pose&) const;

}  // namespace plait
