#include "touches.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>
#include <utility>

namespace plait {
namespace {

constexpr double still = 1e-3;  // part of its gap by which a pair has moved that is not looked at

Symmetric<double> inverseOf(const Symmetric<double>& a) {
    const Vec<double> x = a.solve({1, 0, 0}), y = a.solve({0, 1, 0}), z = a.solve({0, 0, 1});
    return {x.x, x.y, x.z, y.y, y.z, z.z};
}

}  // namespace

Touches::Touches(const Pieces& pieces)
    : poses(place(pieces.count())),
      pieces_(&pieces),
      answers_(place(pieces.count())),
      leaders_(place(pieces.count())),
      starts_(place(pieces.count()) + 1),
      members_(place(pieces.count())),
      centres_(place(pieces.count())),
      motions_(place(pieces.count())),
      stirred_(place(pieces.count())),
      taken_(place(pieces.count())) {
    std::iota(leaders_.begin(), leaders_.end(), 0);
    std::iota(members_.begin(), members_.end(), 0);
    std::iota(starts_.begin(), starts_.end(), 0);
}

void Touches::begin(int piece, const Pose& start, double radius, bool held) {
    stirred_[piece] = 0;
    motions_[piece] = {};
    const Body& body = pieces_->body(piece);
    if (body.inverseMass == 0 || held) {
        answers_[piece] = {};
        return;
    }
    const auto column = [&](const Vec<double>& e) {
        return start.turn * (body.inverseInertia * start.turn.back(e));
    };
    const Vec<double> x = column({1, 0, 0}), y = column({0, 1, 0}), z = column({0, 0, 1});
    answers_[piece] = {radius, body.inverseMass, {x.x, x.y, x.z, y.y, y.z, z.z}};
}

void Touches::join(std::span<const std::int32_t> leaders, std::span<const Pose> start) {
    std::ranges::copy(leaders, leaders_.begin());
    std::ranges::fill(starts_, 0);
    for (const int l : leaders_) ++starts_[l + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<int> next(starts_);
    for (int p = 0; p < std::ssize(leaders_); ++p) members_[next[leaders_[p]]++] = p;
    for (int l = 0; l < std::ssize(leaders_); ++l) joinCluster(l, start);
}

void Touches::joinCluster(int leader, std::span<const Pose> start) {
    const std::span<const int> all = members(leader);
    centres_[leader] = {};
    if (all.size() < 2) return;
    double mass = 0, radius = 0;
    Vec<double> centre{};
    Symmetric<double> inertia{};
    const bool yielding = std::ranges::all_of(all, [&](int p) { return yields(p); });
    for (const int p : all) {
        const double m = divide(1.0, answers_[p].inverseMass);
        mass += m;
        centre += m * start[p].centre;
    }
    centre = divide(1.0, mass) * centre;
    for (const int p : all) {
        const Answer& own = answers_[p];
        const Vec<double> arm = start[p].centre - centre;
        const double m = divide(1.0, own.inverseMass);
        radius = std::max(radius, length(arm) + own.radius);
        if (!yielding) continue;
        inertia += inverseOf(own.inverseInertia);
        inertia += Symmetric<double>::diagonal(m * dot(arm, arm));
        inertia.addOuter(-m, arm);
    }
    const Answer answer =
        yielding ? Answer{radius, 1 / mass, inverseOf(inertia)} : Answer{.radius = radius};
    for (const int p : all) answers_[p] = answer;
    centres_[leader] = start[leader].turn.back(centre - start[leader].centre);
}

void Touches::colour() {
    std::ranges::fill(taken_, std::uint64_t{0});
    colors_.fill(0);
    for (TouchedPair& pair : pairs) {
        std::uint64_t taken = 0;
        for (const int p : {pair.first, pair.second})
            if (yields(p)) taken |= taken_[leader(p)];
        pair.color = std::countr_one(taken);
        if (pair.color < colorLimit)
            for (const int p : {pair.first, pair.second})
                taken_[leader(p)] |= std::uint64_t{1} << pair.color;
        ++colors_[pair.color + 1];
    }
    std::partial_sum(colors_.begin(), colors_.end(), colors_.begin());
    byColor_.resize(pairs.size());
    auto next = colors_;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        byColor_[next[pairs[i].color]++] = static_cast<int>(i);
}

Vec<double> Touches::normalOf(const TouchedPair& pair, const Pose& first, const Pose& second) {
    if (pair.face == TouchedPair::Face::none) return pair.normal;
    return (pair.face == TouchedPair::Face::first ? first : second).turn * pair.normal;
}

Vec<double> Touches::apartOf(const TouchedPoint& point, const Pose& first, const Pose& second) {
    return first.centre - second.centre + first.turn * point.first - second.turn * point.second;
}

Touches::Levers Touches::leversOf(const TouchedPair& pair, const TouchedPoint& point) const {
    const Pose &a = poses[pair.first], &b = poses[pair.second];
    const Vec<double> ca = centreOf(pair.first), cb = centreOf(pair.second);
    Levers levers{a.turn * point.first + (a.centre - ca), b.turn * point.second + (b.centre - cb)};
    const Vec<double> centres = ca - cb;
    switch (pair.face) {
        case TouchedPair::Face::first:
            levers.first = levers.second - centres;
            break;
        case TouchedPair::Face::second:
            levers.second = levers.first + centres;
            break;
        case TouchedPair::Face::none: {
            const Vec<double> half = 0.5 * (centres + levers.first - levers.second);
            levers.first -= half;
            levers.second += half;
        }
    }
    return levers;
}

void Touches::push(int piece, const Vec<double>& impulse, const Vec<double>& twist) {
    const Answer& answer = answers_[piece];
    if (answer.inverseMass == 0) return;
    const Vec<double> shift = answer.inverseMass * impulse, turn = answer.inverseInertia * twist;
    const int l = leader(piece);
    motions_[l].shift += shift;
    motions_[l].turn += turn;
    stirred_[l] += length(shift) + answer.radius * length(turn);
}

void Touches::linearise(Workers& workers) {
    workers.forBlocks(static_cast<int>(pairs.size()), 64, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            TouchedPair& pair = pairs[i];
            pair.across = normalOf(pair);
            const Answer &first = answers_[pair.first], &second = answers_[pair.second];
            for (TouchedPoint& point : of(pair)) {
                const Levers levers = leversOf(pair, point);
                point.leverFirst = levers.first;
                point.leverSecond = levers.second;
                point.apart = apartOf(pair, point);
                point.yield = yieldOf(first, second, point, pair.across);
            }
        }
    });
}

void Touches::apply(Workers& workers) {
    workers.forBlocks(static_cast<int>(poses.size()), 64, [&](int begin, int end) {
        for (int l = begin; l < end; ++l) {
            const Motion motion = std::exchange(motions_[l], {});
            if (motion.shift == Vec<double>{} && motion.turn == Vec<double>{}) continue;
            const Vec<double> centre = centreOf(l);
            const Rotation turn = turnBy(motion.turn);
            for (const int p : members(l)) {
                const Vec<double> arm = poses[p].centre - centre;
                poses[p] = {poses[p].centre + motion.shift + (turn * arm - arm),
                            straightened(turn * poses[p].turn)};
            }
        }
    });
}

double Touches::yieldOf(const Answer& first, const Answer& second, const TouchedPoint& point,
                        const Vec<double>& direction) {
    const Vec<double> a = cross(point.leverFirst, direction),
                      b = cross(point.leverSecond, direction);
    return first.inverseMass + second.inverseMass + dot(a, first.inverseInertia * a) +
           dot(b, second.inverseInertia * b);
}

void Touches::part(TouchedPair& pair, Direction direction) {
    pair.stirred = stirred(pair);
    const Answer &first = answers_[pair.first], &second = answers_[pair.second];
    const Vec<double>& n = pair.across;
    const std::span<TouchedPoint> all = of(pair);
    for (int i = 0; i < std::ssize(all); ++i) {
        TouchedPoint& point = all[direction == Direction::forward ? i : std::ssize(all) - 1 - i];
        const auto move = [&](const Vec<double>& impulse) {
            push(pair.first, impulse, cross(point.leverFirst, impulse));
            push(pair.second, -impulse, -cross(point.leverSecond, impulse));
        };
        const double over = dot(n, apartNow(pair, point)) - point.gap;
        if (point.push == 0 && over >= 0) continue;
        const double push = std::max(0.0, point.push - over / point.yield);
        move((push - point.push) * n);
        point.push = push;
        if (!pair.friction || !gripping_) continue;
        Vec<double> slip = apartNow(pair, point) - point.rest;
        slip -= dot(slip, n) * n;
        const double way = length(slip);
        if (way == 0) continue;
        const Vec<double> grip = pair.friction.grip(
            point.grip, slip, yieldOf(first, second, point, (1 / way) * slip), n, push);
        point.slides = length(grip) > (1 - 1e-6) * pair.friction.sliding * push;
        move(grip - point.grip);
        point.grip = grip;
    }
}

// visit(pair), of one colour side by side.
template <class Visit>
void Touches::forColours(Direction direction, Workers& workers, const Visit& visit) {
    for (int i = 0; i <= colorLimit; ++i) {
        const int c = direction == Direction::forward ? i : colorLimit - i;
        const int first = colors_[c], count = colors_[c + 1] - first;
        workers.forBlocks(count, c == colorLimit ? count : 32, [&](int begin, int end) {
            const bool back = c == colorLimit && direction == Direction::backward;
            for (int k = begin; k < end; ++k)
                visit(pairs[byColor_[first + (back ? end - 1 - (k - begin) : k)]]);
        });
    }
}

void Touches::sweep(Direction direction, Workers& workers) {
    linearise(workers);
    forColours(direction, workers, [&](TouchedPair& pair) { part(pair, direction); });
    apply(workers);
}

bool Touches::settled(double least, Workers& workers) const {
    std::atomic<bool> all{true};
    workers.forBlocks(static_cast<int>(pairs.size()), 256, [&](int begin, int end) {
        for (int i = begin; i < end; ++i)
            for (const TouchedPoint& point : of(pairs[i])) {
                const double apart = dot(pairs[i].across, apartNow(pairs[i], point));
                if (apart < std::min(least * pairs[i].gap, 0.9 * point.gap) ||
                    (gripping_ && point.push > 0 && apart > point.gap + (1 - least) * pairs[i].gap))
                    all = false;
            }
    });
    return all;
}

// The square of what the last two sweeps have changed.
double Touches::change() const {
    double sum = 0;
    for (const TouchedPoint& point : points) {
        const double push = point.push - point.pushWas;
        const Vec<double> grip = point.grip - point.gripWas;
        sum += push * push + dot(grip, grip);
    }
    return sum;
}

// On along the way of all sweeps so far, and the last two.
void Touches::goOn(double part, Workers& workers) {
    forColours(Direction::forward, workers, [&](TouchedPair& pair) {
        const Vec<double>& n = pair.across;
        move(pair, [&](TouchedPoint& point) {
            const double along = std::max(part * point.pushAlong, -point.push);
            const Vec<double> aside = part * point.gripAlong;
            point.pushAlong = along + point.push - point.pushWas;
            point.gripAlong = aside + point.grip - point.gripWas;
            point.push += along;
            point.grip += aside;
            return along * n + aside;
        });
    });
}

int Touches::sweepLinear(double least, int most, Workers& workers) {
    for (TouchedPoint& point : points) point.pushAlong = 0, point.gripAlong = {};
    double last = 0;
    int round = 0;
    for (; round < most && !settled(least, workers); ++round) {
        if (round > 0) {
            const double now = change(), grown = divide(now, last);
            goOn(grown > 1 ? 0 : grown, workers);
            last = now;
        }
        for (TouchedPoint& point : points) point.pushWas = point.push, point.gripWas = point.grip;
        for (const Direction direction : {Direction::forward, Direction::backward})
            forColours(direction, workers, [&](TouchedPair& pair) {
                if (stirred(pair) - pair.stirred > still * pair.gap || round == 0)
                    part(pair, direction);
            });
    }
    return round;
}

int Touches::sweepOn(double least, Workers& workers) {
    constexpr int times = 4, most = 32, mostWithout = 256;
    int sum = 0;
    for (int time = 0; time <= times; ++time) {
        linearise(workers);
        // Friction may go round in circles: pushes alone, a convex problem, part what is still
        // near.
        gripping_ = time < times;
        const int rounds = gripping_ ? sweepLinear(least, most, workers)
                                     : sweepLinear(least / 2, mostWithout, workers);
        if (rounds == 0) break;
        apply(workers);
        sum += rounds;
    }
    gripping_ = true;
    return sum;
}

}  // namespace plait
