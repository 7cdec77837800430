// One contact: where two touch, and the impulses across and along that part them.
#include "../../numbers/lanes.h"
#include "../friction.h"
#include "answers.h"
#include "contact_set.h"
#include "reals.h"

#include <algorithm>
#include <type_traits>

namespace plait {

// While both together move by less than half of what is between them, they cannot have met, and the
// way from one to the other is where it was. Otherwise their paths are asked.
template <class Real>
auto ContactSet<Real>::touch(const Contact& contact, const PairPoints& start,
                             const PairPoints& end) const -> Touch {
    if (options_.detection == Detection::path && contact.distance > 0 &&
        movesBy(0.5 * contact.distance, contact.pair, start, end)) {
        const double meet = 0.5 * std::min(contact.gap, contact.distance);
        if (const Impact t = impactOf(contact.pair, start, end, meet)) {
            PairPoints then;
            for (std::size_t i = 0; i < 4; ++i) then[i] = (1 - *t) * start[i] + *t * end[i];
            const Nearest at = nearest(contact.pair, then);
            const Vec<double> normal = divide(1.0, length(at.apart)) * at.apart;
            Vec<double> apart{};
            for (std::size_t i = 0; i < 4; ++i) apart += at.weight[i] * end[i];
            return {at.weight, normal, dot(normal, apart) - contact.gap};
        }
    }
    const Nearest at = nearest(contact.pair, end);
    const double distance = length(at.apart);
    return {at.weight, divide(1.0, distance) * at.apart, distance - contact.gap};
}

// The least multiplier: below 0 where what touches sticks.
template <class Real>
double ContactSet<Real>::leastOf(const Contact& contact) const {
    if (contact.distance > 1.05 * contact.gap) return 0;
    const Surface& a = search_.surfaces()[search_.surfaceOf(contact.pair.vertices[0])];
    const Surface& b = search_.surfaces()[search_.surfaceOf(contact.pair.vertices[3])];
    return -mean(a.stickiness, b.stickiness) * h_ * h_;
}

// How high all are along `normal` when the substep begins.
template <class Real>
auto ContactSet<Real>::watchOf(const Contact& contact, const Rounding& rounding,
                               const Vec<double>& normal, const PairPoints& start) const -> Watch {
    const Pairing& pair = contact.pair;
    Watch watch{pair.vertices, {}, {}, leastOf(contact) < 0 ? 0 : pair.first};
    const Vec<double> way = rounding.back(normal);
    watch.normal = {static_cast<float>(way.x), static_cast<float>(way.y),
                    static_cast<float>(way.z)};
    for (int i = 0; i < 4; ++i) {
        const Vec<double> from = start[i] - start[3];
        const double height = dot(normal, from), wrong = 1e-6 * length(from);
        watch.height[i] =
            static_cast<float>(i < pair.first ? height - contact.gap - wrong : height + wrong);
    }
    return watch;
}

// By how much the first is higher than the second, less the gap.
template <class Real>
float ContactSet<Real>::room(const Watch& watch, const std::array<float, 4>& height) {
    const bool edge = watch.first == 2;
    const float low = edge ? std::min(height[0], height[1]) : height[0];
    return low - std::max({height[edge ? 2 : 1], height[2], height[3]});
}

// Whether a plane is still between the two, with the gap: then it was so all the way.
template <class Real>
bool ContactSet<Real>::clear(const Sweep<Real>& sweep, const Watch& watch) const {
    if (watch.first == 0) return false;
    std::array<float, 4> way, height;
    if constexpr (std::is_same_v<Real, float>) {
        using Four = Pack<4>;
        const Vec<Four> go = gather<Four>(sweep.particles + 4, watch.vertices.data(), 8).xyz -
                             gather<Four>(sweep.before, watch.vertices.data(), 4).xyz;
        store(way.data(), Four(watch.normal.x) * go.x + Four(watch.normal.y) * go.y +
                              Four(watch.normal.z) * go.z);
    } else {
        for (std::size_t i = 0; i < 4; ++i) {
            const Real* const d = sweep.particles + 8 * watch.vertices[i] + 4;
            const Real* const b = sweep.before + 4 * watch.vertices[i];
            way[i] = watch.normal.x * static_cast<float>(d[0] - b[0]) +
                     watch.normal.y * static_cast<float>(d[1] - b[1]) +
                     watch.normal.z * static_cast<float>(d[2] - b[2]);
        }
    }
    float wrong = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        height[i] = watch.height[i] + way[i];
        wrong += std::fabs(way[i]);
    }
    return room(watch, height) > 1e-6F * wrong;
}

// The same by a plane across the way between them as it is now; if so, it is watched from here on.
// Before, too, it must have had them on either side, and far enough apart that no impact is told.
template <class Real>
bool ContactSet<Real>::clearNow(Contact& contact, const Rounding& rounding, const PairPoints& start,
                                const PairPoints& end) const {
    const Nearest now = nearest(contact.pair, end);
    const double distance = length(now.apart);
    if (!(distance >= contact.gap && distance > 0)) return false;
    const Watch watch = watchOf(contact, rounding, divide(1.0, distance) * now.apart, start);
    const double least = 0.5 * std::min(contact.gap, contact.distance) - contact.gap;
    if (!(room(watch, watch.height) > least)) return false;
    contact.watch = watch;
    return true;
}

template <class Real>
void ContactSet<Real>::part(const Sweep<Real>& sweep, Contact& contact) {
    const auto& v = contact.pair.vertices;
    const Surface& a = search_.surfaces()[search_.surfaceOf(v[0])];
    const Surface& b = search_.surfaces()[search_.surfaceOf(v[3])];
    const double least = leastOf(contact);
    const PairPoints start = startOf(contact.pair), end = endOf(sweep, contact.pair);
    const Rounding rounding = sections_.of(contact.pair);
    const PairPoints roundStart = rounding.to(start), roundEnd = rounding.to(end);
    const bool idle = contact.push == 0 && least == 0;
    if (idle && clearNow(contact, rounding, roundStart, roundEnd)) return;
    Touch at = touch(contact, roundStart, roundEnd);
    if (idle && at.value >= 0) return;
    if (rounding.flat()) {
        const Vec<double> way = rounding.back(at.normal);
        const double steep = length(way);
        at.normal = divide(1.0, steep) * way;
        at.value = divide(at.value, steep);
    }
    const double shocked = 1 / options_.layerShock;
    const Answers<Real> answers(
        sweep, contact.pair, at.weight, end,
        {.inverseMass =
             options_.mass == ContactMass::legacy ? inverseMass_ : std::span<const double>{},
         .pieces = pieces_,
         .poses = poses_},
        {a.layer < b.layer ? shocked : 1, b.layer < a.layer ? shocked : 1});
    double push = std::max(least, contact.push - divide(at.value, answers.along(at.normal)));
    if (options_.displacementLimit > 0) {
        const double most = answers.within(options_.displacementLimit, at.normal);
        contact.limited = contact.limited || push > most;
        push = std::min(push, most);
    }
    answers.move((push - contact.push) * at.normal);
    contact.push = push;

    const double rub = frictionPart(a, b);
    const Friction friction(rub * a.staticFriction, rub * b.staticFriction, rub * a.dynamicFriction,
                            rub * b.dynamicFriction);
    if (!friction) return;
    const PairPoints now = endOf(sweep, contact.pair);
    Vec<double> slip{};
    for (std::size_t i = 0; i < 4; ++i) slip += at.weight[i] * (now[i] - start[i]);
    slip -= dot(slip, at.normal) * at.normal;
    const double way = length(slip);
    if (way == 0) return;
    const double answer = answers.along((1 / way) * slip);
    const Vec<double> grip =
        friction.grip(contact.grip, slip, answer, at.normal, std::max(push, 0.0) - least);
    answers.move(grip - contact.grip);
    contact.grip = grip;
}

template class ContactSet<float>;
template class ContactSet<double>;

}  // namespace plait
