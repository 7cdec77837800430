#include "piece_bounces.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr double tiny = 1e-6;  // part of the speed of an impact that is none

// Two as they strike each other, by Gauss-Seidel over the points where they touch.
class PairImpact {
public:
    using Body = PieceBounces::Body;

    PairImpact(const PieceBounces::Pair& pair, const Body& first, const Body& second)
        : pair_(pair), first_(first), second_(second) {}

    PieceBounces::Kick kick;

    void add(const PieceBounces::Point& point, double restitution) {
        Touch t{point.at - first_.centre, point.at - second_.centre, 0, 0};
        t.wanted = restitution * std::max(0.0, -dot(pair_.normal, apartAt(t)));
        t.yield = yieldOf(t, pair_.normal);
        touches_.push_back(t);
    }
    void solve() {
        constexpr int sweeps = 100;
        for (int i = 0; i < sweeps; ++i) {
            changed_ = most_ = 0;
            for (Touch& t : touches_) visit(t);
            for (std::size_t k = touches_.size(); k-- > 0;) visit(touches_[k]);
            if (changed_ <= 1e-12 * most_) break;
        }
    }

private:
    struct Touch {
        Vec<double> leverFirst, leverSecond;
        double wanted, yield, push = 0;
        Vec<double> grip{};
    };

    double yieldOf(const Touch& t, const Vec<double>& n) const {
        const Vec<double> a = cross(t.leverFirst, n), b = cross(t.leverSecond, n);
        return first_.inverseMass + second_.inverseMass + dot(a, first_.inverseInertia * a) +
               dot(b, second_.inverseInertia * b);
    }
    // The speed of the first over the second.
    Vec<double> apartAt(const Touch& t) const {
        const Vec<double> firstSpin = first_.spin + first_.inverseInertia * kick.twistFirst;
        const Vec<double> secondSpin = second_.spin - second_.inverseInertia * kick.twistSecond;
        return first_.velocity - second_.velocity +
               (first_.inverseMass + second_.inverseMass) * kick.impulse +
               cross(firstSpin, t.leverFirst) - cross(secondSpin, t.leverSecond);
    }
    void press(const Touch& t, const Vec<double>& impulse) {
        kick.impulse += impulse;
        kick.twistFirst += cross(t.leverFirst, impulse);
        kick.twistSecond += cross(t.leverSecond, impulse);
    }
    void visit(Touch& t) {
        const Vec<double>& n = pair_.normal;
        const double off = dot(n, apartAt(t)) - t.wanted;
        const double push = std::max(0.0, t.push - divide(off, t.yield));
        changed_ = std::max(changed_, std::fabs(push - t.push));
        most_ = std::max(most_, push);
        press(t, (push - t.push) * n);
        t.push = push;
        Vec<double> slip = apartAt(t);
        slip -= dot(slip, n) * n;
        const double speed = length(slip);
        if (pair_.friction == 0 || speed == 0) return;
        Vec<double> grip = t.grip - divide(1.0, yieldOf(t, (1 / speed) * slip)) * slip;
        const double force = length(grip), held = pair_.friction * push;
        if (force > held) grip = (held / force) * grip;
        changed_ = std::max(changed_, length(grip - t.grip));
        press(t, grip - t.grip);
        t.grip = grip;
    }

    const PieceBounces::Pair& pair_;
    const Body &first_, &second_;
    std::vector<Touch> touches_;
    double changed_ = 0, most_ = 0;
};

}  // namespace

// Where they come fastest: with constant acceleration, by energy, so that a ball that is caught
// where it touched rises as high as restitution has it, wherever in the substep that was. Two of
// which one has been struck in this substep are at that moment.
auto PieceBounces::approachOf(const Pair& pair, double h) const -> Approach {
    const Body &first = body(pair.first), &second = body(pair.second);
    const bool fresh = !first.struck && !second.struck;
    const double closing = dot(pair.normal, second.gain - first.gain);
    Approach most{0, 0};
    for (const Point& point : pair.points) {
        const double began =
            dot(pair.normal, speedAt(pair.second, point.at) - speedAt(pair.first, point.at));
        if (!fresh || began <= 0 || point.way <= 0) {
            most.speed = std::max(most.speed, began);
            continue;
        }
        const double speed = std::sqrt(std::max(0.0, began * began + 2 * closing * point.way));
        if (speed <= most.speed) continue;
        most = {speed, std::clamp(divide(2 * point.way, began + speed), 0.0, h)};
    }
    return most;
}

void PieceBounces::strike(const Pair& pair, double time) {
    for (const int i : {pair.first, pair.second}) {
        Body& one = body(i);
        if (one.struck || one.inverseMass == 0) continue;
        one.velocity += time * one.gain;
        one.struck = true;
    }
}

void PieceBounces::move(const Pair& pair, const Kick& kick) {
    Body &first = body(pair.first), &second = body(pair.second);
    first.velocity += first.inverseMass * kick.impulse;
    first.spin += first.inverseInertia * kick.twistFirst;
    second.velocity -= second.inverseMass * kick.impulse;
    second.spin -= second.inverseInertia * kick.twistSecond;
}

// All points of the pair at once, so that what lands flat does not begin to spin: they part at no
// less than restitution asks, and press no more than that takes.
auto PieceBounces::kickOf(const Pair& pair, double restitution) const -> Kick {
    PairImpact impact(pair, body(pair.first), body(pair.second));
    for (const Point& point : pair.points) impact.add(point, restitution);
    impact.solve();
    return impact.kick;
}

// The kick of restitution, or as much of it as leaves no more energy than there was: friction and
// restitution, each by its own law, may add some (Kane 1984). Without restitution none is added.
auto PieceBounces::bounceOf(const Pair& pair) const -> Kick {
    const Body &first = body(pair.first), &second = body(pair.second);
    struct Speeds {
        Vec<double> firstSpeed, firstSpin, secondSpeed, secondSpin;
    };
    const auto motionOf = [&](const Kick& k) {
        return Speeds{first.inverseMass * k.impulse, first.inverseInertia * k.twistFirst,
                      -second.inverseMass * k.impulse, -(second.inverseInertia * k.twistSecond)};
    };
    const auto work = [](const Kick& k, const Speeds& m) {
        return dot(k.impulse, m.firstSpeed - m.secondSpeed) + dot(k.twistFirst, m.firstSpin) -
               dot(k.twistSecond, m.secondSpin);
    };
    const Kick stops = kickOf(pair, 0), whole = kickOf(pair, pair.restitution);
    const Kick more{whole.impulse - stops.impulse, whole.twistFirst - stops.twistFirst,
                    whole.twistSecond - stops.twistSecond};
    const Speeds before{first.velocity, first.spin, second.velocity, second.spin};
    const Speeds stopped = motionOf(stops);
    const double lost = -(2 * work(stops, before) + work(stops, stopped));
    const double along = work(more, before) + work(more, stopped);
    const double square = work(more, motionOf(more));
    const double root = std::sqrt(std::max(0.0, along * along + square * lost));
    const double part = std::clamp(divide(root - along, square), 0.0, 1.0);
    return {stops.impulse + part * more.impulse, stops.twistFirst + part * more.twistFirst,
            stops.twistSecond + part * more.twistSecond};
}

// What is left approaches too slowly to bounce, and stops. Returns whether it did.
bool PieceBounces::settle(double slow) {
    constexpr int sweeps = 16;
    for (int i = 0; i < sweeps; ++i) {
        bool any = false;
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const Pair& pair = pairs[i % 2 == 0 ? k : pairs.size() - 1 - k];
            if (!body(pair.first).struck && !body(pair.second).struck) continue;
            if (approachOf(pair, 0).speed <= slow) continue;
            any = true;
            strike(pair, 0);
            move(pair, kickOf(pair, 0));
        }
        if (!any) return true;
    }
    return false;
}

int PieceBounces::follow(double h, double slow, bool& cut) {
    const int limit = 16 + 4 * static_cast<int>(pairs.size());
    int count = 0;
    double fastest = 0;
    cut = false;
    approach_.resize(pairs.size());
    const auto ask = [&](const Pair& pair) {
        const bool follows = body(pair.first).struck || body(pair.second).struck;
        return pair.restitution > 0 || follows ? approachOf(pair, h).speed : 0.0;
    };
    for (std::size_t k = 0; k < pairs.size(); ++k) approach_[k] = ask(pairs[k]);
    while (!pairs.empty()) {
        const auto most = std::ranges::max_element(approach_);
        fastest = std::max(fastest, *most);
        if (*most <= std::max(slow, tiny * fastest)) break;
        if (count == limit) {
            cut = true;
            break;
        }
        const Pair& pair = pairs[static_cast<std::size_t>(most - approach_.begin())];
        strike(pair, approachOf(pair, h).time);
        move(pair, bounceOf(pair));
        ++count;
        for (std::size_t k = 0; k < pairs.size(); ++k)
            for (const int i : {pair.first, pair.second})
                if (body(i).inverseMass > 0 && (pairs[k].first == i || pairs[k].second == i))
                    approach_[k] = ask(pairs[k]);
    }
    if (count > 0) settle(tiny * fastest);
    return count;
}

}  // namespace plait
