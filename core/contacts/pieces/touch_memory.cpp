#include "touch_memory.h"

#include "../../state.h"

#include <algorithm>
#include <tuple>

namespace plait {
namespace {

// What of the last push a pair begins with. Sweeps that have not converged leave a push that is off
// by what they have left, and what begins with all of that swings up: of five boxes at 240/s and 8
// palindromes some jump at 0.2 m/s with 0.9, rest with 0.5 to 0.7, and creep with 0.3.
constexpr double kept = 0.7;
// Part of what has slipped that is taken back in a substep.
constexpr double returned = 0.2;
constexpr std::size_t numbersEach = 16, integersEach = 2;

Vec<double> across(const Vec<double>& normal, const Vec<double>& a) {
    return a - dot(a, normal) * normal;
}

template <class Pair>
std::pair<int, int> keyOf(const Pair& pair) {
    return {pair.first, pair.second};
}

}  // namespace

template <class Real>
void TouchMemory::furnish(Drawer<Real>& drawer) const {
    drawer.numbers.assign(most_ * numbersEach, Real(0));
    drawer.integers.assign(most_ * integersEach, -1);
}

template <class Real>
void TouchMemory::read(const Drawer<Real>& drawer) {
    known_.clear();
    for (std::size_t i = 0; i < most_ && drawer.integers[integersEach * i] >= 0; ++i) {
        const std::int32_t* const pair = &drawer.integers[integersEach * i];
        const Real* number = &drawer.numbers[numbersEach * i];
        Known k{pair[0], pair[1]};
        for (Vec<double>* const v : {&k.at, &k.slip, &k.twist, &k.force, &k.torque}) {
            *v = {double(number[0]), double(number[1]), double(number[2])};
            number += 3;
        }
        k.lasting = double(*number);
        known_.push_back(k);
    }
}

template <class Real>
void TouchMemory::write(Drawer<Real>& drawer) const {
    std::fill_n(drawer.numbers.begin(), most_ * numbersEach, Real(0));
    std::fill_n(drawer.integers.begin(), most_ * integersEach, -1);
    for (std::size_t i = 0; i < std::min(most_, known_.size()); ++i) {
        const Known& k = known_[i];
        drawer.integers[integersEach * i] = k.first;
        drawer.integers[integersEach * i + 1] = k.second;
        Real* number = &drawer.numbers[numbersEach * i];
        for (const Vec<double>* const v : {&k.at, &k.slip, &k.twist, &k.force, &k.torque}) {
            number[0] = static_cast<Real>(v->x);
            number[1] = static_cast<Real>(v->y);
            number[2] = static_cast<Real>(v->z);
            number += 3;
        }
        *number = static_cast<Real>(k.lasting);
    }
}

// The points' pushes vary linearly and have that force and torque together, as far as points that
// lie so can: each pushes, by no more than all, and grips within friction.
void TouchMemory::lean(const Known& known, Touches& touches, const TouchedPair& pair,
                       const Pose& first, const Pose& second, double h) {
    const std::span<TouchedPoint> points = touches.of(pair);
    const Vec<double> n = Touches::normalOf(pair, first, second);
    const double each = 1 / static_cast<double>(points.size());
    const auto lever = [&](const TouchedPoint& p) { return first.turn * p.first; };
    Vec<double> middle{};
    for (const TouchedPoint& p : points) middle += each * lever(p);
    Symmetric<double> spread{};
    for (const TouchedPoint& p : points) spread.addOuter(1, across(n, lever(p) - middle));
    const double size = spread.xx + spread.yy + spread.zz;
    spread += Symmetric<double>::diagonal(1e-9 * size);

    const double part = known.lasting * kept * h * h,
                 push = std::max(0.0, part * dot(known.force, n));
    const Vec<double> grip = part * across(n, known.force);
    const Vec<double> torque = part * known.torque - cross(middle - known.at, push * n + grip);
    const Vec<double> tilt = spread.solve(cross(n, torque));
    const double spin = divide(dot(n, torque), size);
    double sum = 0;
    for (TouchedPoint& p : points)
        sum += p.push = std::clamp(each * push + dot(tilt, lever(p) - middle), 0.0, push);
    for (TouchedPoint& p : points) {
        p.push *= divide(push, sum);
        p.grip = each * grip + spin * cross(n, lever(p) - middle);
        const double most = pair.friction.standing * p.push, much = length(p.grip);
        if (much > most) p.grip = (most / much) * p.grip;
        p.rest -= returned * (known.slip + cross(known.twist, lever(p) - known.at));
    }
    touches.move(pair, [&](const TouchedPoint& p) { return p.push * n + p.grip; });
}

void TouchMemory::recall(Touches& touches, std::span<const Pose> start, double h) const {
    auto known = known_.begin();
    for (TouchedPair& pair : touches.pairs) {
        while (known != known_.end() && keyOf(*known) < keyOf(pair)) ++known;
        if (known == known_.end()) return;
        if (keyOf(*known) != keyOf(pair)) continue;
        lean(*known, touches, pair, start[pair.first], start[pair.second], h);
        pair.leant = true;
    }
}

// A point that slides has forgotten where it stuck.
TouchMemory::Known TouchMemory::knownOf(const Touches& touches, const TouchedPair& pair,
                                        double h) const {
    const Vec<double> n = touches.normalOf(pair);
    const Rotation& turn = touches.poses[pair.first].turn;
    Known known{pair.first, pair.second};
    double weight = 0, size = 0;
    for (const TouchedPoint& p : touches.of(pair)) {
        weight += p.push;
        known.at += p.push * (turn * p.first);
    }
    if (weight == 0) return known;
    known.at = (1 / weight) * known.at;
    const auto slipOf = [&](const TouchedPoint& p) {
        return p.slides ? Vec<double>{} : across(n, touches.apartOf(pair, p) - p.rest);
    };
    for (const TouchedPoint& p : touches.of(pair)) known.slip += (p.push / weight) * slipOf(p);
    double spin = 0;
    for (const TouchedPoint& p : touches.of(pair)) {
        const Vec<double> from = turn * p.first - known.at, force = p.push * n + p.grip;
        known.force += (1 / (h * h)) * force;
        known.torque += (1 / (h * h)) * cross(from, force);
        spin += p.push * dot(n, cross(from, slipOf(p) - known.slip));
        size += p.push * dot(across(n, from), across(n, from));
    }
    known.twist = divide(spin, size) * n;
    const auto old = std::ranges::lower_bound(before_, keyOf(pair), {}, keyOf<Known>);
    if (old == before_.end() || keyOf(*old) != keyOf(pair)) return known;
    const double was = length(old->force);
    known.lasting = std::min(1.0, divide(was, length(known.force)));
    double stuck = 0;
    for (const TouchedPoint& p : touches.of(pair)) stuck += p.slides ? 0 : p.push / weight;
    const double left = stuck * (1 - returned);
    known.slip += left * (old->slip + cross(old->twist, known.at - old->at));
    known.twist += left * old->twist;
    return known;
}

void TouchMemory::note(const Touches& touches, double h, std::span<const unsigned char> moves) {
    std::swap(before_, known_);
    known_.clear();
    for (const TouchedPair& pair : touches.pairs)
        if (const Known known = knownOf(touches, pair, h);
            dot(known.force, touches.normalOf(pair)) > 0)
            known_.push_back(known);
    for (const Known& known : before_)
        if (!moves[known.first] && !moves[known.second]) known_.push_back(known);
    // Of two that crossed besides, where they are pressed most.
    std::ranges::sort(known_, {}, [](const Known& k) {
        return std::tuple(k.first, k.second, -dot(k.force, k.force));
    });
    const auto more = std::ranges::unique(known_, {}, keyOf<Known>);
    known_.erase(more.begin(), more.end());
    if (known_.size() > most_) known_.resize(most_);
}

template void TouchMemory::furnish(Drawer<float>&) const;
template void TouchMemory::furnish(Drawer<double>&) const;
template void TouchMemory::read(const Drawer<float>&);
template void TouchMemory::read(const Drawer<double>&);
template void TouchMemory::write(Drawer<float>&) const;
template void TouchMemory::write(Drawer<double>&) const;

}  // namespace plait
