// Pieces that bounce: how they came, and how they leave.
#include "../matter/reals.h"
#include "piece_contacts.h"

#include <algorithm>

namespace plait {

// The speed with which the substep began, and what the prediction adds to it.
template <class Real>
void PieceContacts<Real>::noteComing(const Sweep<Real>& sweep, const State<Real>& state,
                                     int piece) {
    const Body& body = pieces_.body(piece);
    const auto place = [&](int i) {
        const int v = body.vertices.first + i;
        return three(sweep.particles + 8 * v) + three(sweep.before + 4 * v);
    };
    double mass = 0;
    Vec<double> centre{}, speed{}, gain{}, momentum{};
    for (int i = 0; i < body.vertices.size(); ++i) {
        mass += body.mass[i];
        centre += body.mass[i] * place(i);
    }
    centre = (1 / mass) * centre;
    for (int i = 0; i < body.vertices.size(); ++i) {
        const int v = body.vertices.first + i;
        const Vec<double> began = three(sweep.before + 4 * v);
        const Vec<double> step = three(sweep.particles + 8 * v + 4) - began;
        const Vec<double> last = began - three(&state.last[v].v.x);
        Vec<double> comes = (1 / h_) * (state.hasPast ? last : step);
        if (!state.lastVelocity.empty()) comes = three(&state.lastVelocity[v].v.x);
        speed += body.mass[i] / mass * comes;
        gain += body.mass[i] / (mass * h_) *
                ((1 / h_) * (state.hasPast ? step - last : step) -
                 (state.hasPast ? Vec<double>{} : comes));
        momentum += body.mass[i] * cross(place(i) - centre, comes);
    }
    coming_[piece] = {speed, momentum, gain};
}

template <class Real>
void PieceContacts<Real>::gatherBodies() {
    for (int l = 0; l < pieces_.count(); ++l) {
        if (touches_.leader(l) != l) continue;
        const Touches::Answer& answer = touches_.answerOf(l);
        PieceBounces::Body& body = bounces_.bodies[l];
        body = {touches_.centreOf(l), answer.inverseMass, answer.inverseInertia};
        if (!touches_.yields(l)) {
            const PoseWay way(starts_[l], touches_.poses[l]);
            body.velocity = (1 / h_) * way.shift();
            body.spin = (1 / h_) * way.turn();
            continue;
        }
        Vec<double> centre{}, momentum{};
        const auto part = [&](int p) { return answer.inverseMass / pieces_.body(p).inverseMass; };
        for (const int p : touches_.members(l)) {
            centre += part(p) * starts_[p].centre;
            body.velocity += part(p) * coming_[p].velocity;
            body.gain += part(p) * coming_[p].gain;
        }
        for (const int p : touches_.members(l))
            momentum += coming_[p].momentum +
                        cross((1 / pieces_.body(p).inverseMass) * (starts_[p].centre - centre),
                              coming_[p].velocity);
        body.spin = answer.inverseInertia * momentum;
    }
}

// Points that touch where the substep ends.
template <class Real>
void PieceContacts<Real>::gatherPairs() {
    constexpr double near = 1.05;  // gaps
    bounces_.pairs.clear();
    for (const TouchedPair& pair : touches_.pairs) {
        const int first = touches_.leader(pair.first), second = touches_.leader(pair.second);
        const Pose &a = starts_[pair.first], &b = starts_[pair.second];
        const Vec<double> n = touches_.normalOf(pair), n0 = Touches::normalOf(pair, a, b);
        PieceBounces::Pair bounce{
            first, second, n, pair.restitution, std::clamp(pair.friction.sliding, 0.0, 1.0), {}};
        for (const TouchedPoint& point : touches_.of(pair)) {
            const double apart = dot(n, touches_.apartOf(pair, point));
            if (point.push == 0 && apart > near * pair.gap) continue;
            const Touches::Levers levers = touches_.leversOf(pair, point);
            bounce.points.push_back({touches_.centreOf(pair.first) + levers.first,
                                     dot(n0, Touches::apartOf(point, a, b)) - apart});
        }
        if (!bounce.points.empty()) bounces_.pairs.push_back(std::move(bounce));
    }
}

template <class Real>
void PieceContacts<Real>::bounce() {
    gatherPairs();
    if (bounces_.pairs.empty()) return;
    gatherBodies();
    bool cut = false;
    const double slow = std::max(options_.bounceThreshold, 2 * gravity_ * h_);
    counts_.bounces += bounces_.follow(h_, slow, cut);
    counts_.cut += cut;
}

// With a past that continues its speed, turn and acceleration, so that BDF2 extrapolates no bounce.
template <class Real>
void PieceContacts<Real>::leave(State<Real>& state, int piece) const {
    const PieceBounces::Body& body = bounces_.bodies[touches_.leader(piece)];
    const Range& all = pieces_.body(piece).vertices;
    for (int v = all.first; v < all.last; ++v) {
        const Vec<double> aside = cross(body.spin, state.position(v) - body.centre);
        const Vec<double> speed = body.velocity + aside;
        const bool second = !state.lastVelocity.empty();
        const Vec<double> gain = second ? body.gain + cross(body.spin, aside) : Vec<double>{};
        put(&state.velocity[v].v.x, speed);
        if (second) put(&state.lastVelocity[v].v.x, speed - h_ * gain);
        put(&state.last[v].v.x, three(&state.particles[v].d.x) - h_ * (speed - 0.5 * h_ * gain));
    }
}

template class PieceContacts<float>;
template class PieceContacts<double>;

}  // namespace plait
