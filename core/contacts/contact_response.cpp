// One contact: where two touch, and the impulses across and along that part them.
#include "contact_set.h"
#include "friction.h"

#include <algorithm>

namespace plait {
namespace {

double mean(double a, double b) { return 0.5 * (a + b); }

// How the vertices of a contact answer impulses.
template <class Real>
struct Answers {
    const Sweep<Real>& sweep;
    const Pairing& pair;
    const std::array<double, 4>& weight;
    double yields[2];  // of the first simplex and of the second, 1 but for shocked layers

    // w I - q q^T, for vertex i.
    Vec<double> of(std::size_t i, const Vec<double>& impulse) const {
        const int v = pair.vertices[i];
        Vec<double> moved = double(sweep.particles[8 * v + 3]) * impulse;
        if (sweep.air) {
            const Real* const q = sweep.air + 4 * v;
            const Vec<double> along{double(q[0]), double(q[1]), double(q[2])};
            moved -= dot(along, impulse) * along;
        }
        return yields[static_cast<int>(i) >= pair.first] * moved;
    }
    // How far they part along n of unit length by an impulse of 1 along it. Next to a vertex that
    // is pinned a free one has no lever to part them by; without a limit it would be flung away.
    double along(const Vec<double>& n) const {
        constexpr double leastLever = 0.1;
        double sum = 0, most = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (weight[i] == 0) continue;
            const double answer = dot(n, of(i, n));
            sum += weight[i] * weight[i] * answer;
            most = std::max(most, answer);
        }
        return std::max(sum, leastLever * leastLever * most);
    }
    void move(const Vec<double>& impulse) const {
        for (std::size_t i = 0; i < 4; ++i) {
            Real* const p = sweep.particles + 8 * pair.vertices[i];
            if (weight[i] == 0 || p[3] == Real(0)) continue;
            const Vec<double> d = of(i, weight[i] * impulse);
            p[4] += static_cast<Real>(d.x);
            p[5] += static_cast<Real>(d.y);
            p[6] += static_cast<Real>(d.z);
        }
    }
};

}  // namespace

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

template <class Real>
void ContactSet<Real>::part(const Sweep<Real>& sweep, Contact& contact) const {
    const auto& v = contact.pair.vertices;
    const Surface& a = search_.surfaces()[search_.surfaceOf(v[0])];
    const Surface& b = search_.surfaces()[search_.surfaceOf(v[3])];
    const double hold = mean(a.stickiness, b.stickiness) * h_ * h_;
    const double least = contact.distance <= 1.05 * contact.gap ? -hold : 0;

    const PairPoints start = startOf(contact.pair), end = endOf(sweep, contact.pair);
    const bool idle = contact.push == 0 && least == 0;
    if (idle && !movesBy(contact.distance - contact.gap, contact.pair, start, end)) return;
    const Touch at = touch(contact, start, end);
    if (idle && at.value >= 0) return;
    const double shocked = 1 / options_.layerShock;
    const Answers<Real> answers{sweep,
                                contact.pair,
                                at.weight,
                                {a.layer < b.layer ? shocked : 1, b.layer < a.layer ? shocked : 1}};
    const double push = std::max(least, contact.push - divide(at.value, answers.along(at.normal)));
    answers.move((push - contact.push) * at.normal);
    contact.push = push;

    const Friction friction(a.staticFriction, b.staticFriction, a.dynamicFriction,
                            b.dynamicFriction);
    if (!friction) return;
    const PairPoints now = endOf(sweep, contact.pair);
    Vec<double> slip{};
    for (std::size_t i = 0; i < 4; ++i) slip += at.weight[i] * (now[i] - start[i]);
    slip -= dot(slip, at.normal) * at.normal;
    const double way = length(slip);
    if (way == 0) return;
    const double answer = answers.along((1 / way) * slip);
    const Vec<double> grip =
        friction.grip(contact.grip, slip, answer, at.normal, std::max(push, 0.0) + hold);
    answers.move(grip - contact.grip);
    contact.grip = grip;
}

template class ContactSet<float>;
template class ContactSet<double>;

}  // namespace plait
