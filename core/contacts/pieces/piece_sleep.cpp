// Pieces fall asleep and wake.
#include "../matter/reals.h"
#include "piece_contacts.h"

#include <algorithm>

namespace plait {

// In the state a sleeper has no inverse mass, but for what has just been let go by the world.
template <class Real>
void PieceContacts<Real>::holdSleepers(const Sweep<Real>& sweep) const {
    for (int p = 0; p < pieces_.count(); ++p) {
        if (!sleep_.asleep(p)) continue;
        const Range& all = pieces_.body(p).vertices;
        for (int v = all.first; v < all.last; ++v) {
            sweep.particles[8 * v + 3] = Real(0);
            plait::putBack(sweep, v);
        }
    }
}

// Of an awake one and a sleeper: they are going to press each other.
template <class Real>
bool PieceContacts<Real>::wakes(const TouchedPair& pair) const {
    const Vec<double> n = touches_.normalOf(pair);
    return std::ranges::any_of(touches_.of(pair), [&](const TouchedPoint& point) {
        return dot(n, touches_.apartOf(pair, point)) < pair.gap;
    });
}

// Before anything is moved, so that what strikes a sleeper does not meet a wall. Returns whether
// somebody woke.
template <class Real>
bool PieceContacts<Real>::wakeTouched(const Sweep<Real>& sweep) {
    std::vector<int> woken;
    const auto ask = [&](int first, int second, const auto& does) {
        for (const auto& [p, q] : {std::array{first, second}, {second, first}})
            if (sleep_.asleep(p) && !sleep_.asleep(q) && moves_[q] && does()) woken.push_back(p);
    };
    for (const TouchedPair& pair : touches_.pairs)
        ask(pair.first, pair.second, [&] { return wakes(pair); });
    memory_.forAll([&](int first, int second) {  // what it lies on has moved
        ask(first, second, [&] { return !touches_.yields(first) && !touches_.yields(second); });
    });
    for (const int p : woken) sleep_.wake(p);
    if (woken.empty()) return false;
    for (int p = 0; p < pieces_.count(); ++p) {
        if (!placed_[p] || sleep_.asleep(p)) continue;
        const Body& body = pieces_.body(p);
        for (int i = 0; i < body.vertices.size(); ++i)
            sweep.particles[8 * (body.vertices.first + i) + 3] =
                static_cast<Real>(1 / body.mass[i]);
        begin(sweep, p);
    }
    return true;
}

template <class Real>
void PieceContacts<Real>::joinIslands() {
    sleep_.begin();
    for (int p = 0; p < pieces_.count(); ++p) sleep_.join(p, touches_.leader(p));
    for (const TouchedPair& pair : touches_.pairs)
        if (touches_.yields(pair.first) && touches_.yields(pair.second) &&
            std::ranges::any_of(touches_.of(pair),
                                [](const TouchedPoint& point) { return point.push > 0; }))
            sleep_.join(pair.first, pair.second);
}

// Who has been slow for long enough, with all that it touches, stays where it is.
template <class Real>
void PieceContacts<Real>::rest(State<Real>& state, Drawer<Real>& kept) const {
    for (int p = 0; p < pieces_.count(); ++p) {
        const Range& all = pieces_.body(p).vertices;
        double speed = -1;
        for (int v = all.first; v < all.last && touches_.yields(p); ++v)
            speed = std::max(speed, double(length(state.velocity[v].v)));
        sleep_.note(p, speed, h_);
    }
    sleep_.fall(h_);
    for (int p = 0; p < pieces_.count(); ++p) {
        if (!sleep_.asleep(p) || !touches_.yields(p)) continue;
        const Range& all = pieces_.body(p).vertices;
        for (int v = all.first; v < all.last; ++v) {
            state.particles[v].w = Real(0);
            state.velocity[v].v = {};
            if (!state.lastVelocity.empty()) state.lastVelocity[v].v = {};
            if (!state.last.empty()) state.last[v].v = state.particles[v].d;
        }
    }
    sleep_.write(kept);
}

template class PieceContacts<float>;
template class PieceContacts<double>;

}  // namespace plait
