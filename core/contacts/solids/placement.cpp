#include "placement.h"

#include "../../numbers/elementary.h"
#include "../../numbers/finite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace plait {

Placement::Placement(const Frame& frame, const std::string& who) : at(frame.origin) {
    const auto is = [](double a, double b) { return std::fabs(a - b) <= 1e-6; };
    if (!isFinite(frame.origin) || !is(dot(frame.across, frame.across), 1) ||
        !is(dot(frame.up, frame.up), 1) || !is(dot(frame.across, frame.up), 0))
        throw std::invalid_argument(
            who + ": a frame has a finite origin, and two perpendicular directions of length 1");
    x = (1 / length(frame.across)) * frame.across;
    y = frame.up - dot(frame.up, x) * x;
    y = (1 / length(y)) * y;
    z = cross(x, y);
}

// By way of a quaternion, divided by the largest of its parts: the axis of half a turn is sharp,
// and so is that of the least one (Shepperd, Quaternion from rotation matrix, 1978).
Vec<double> turnBetween(const Placement& a, const Placement& b) {
    // Columns are b's axes against a's.
    const Vec<double> x = a.ownWay(b.x), y = a.ownWay(b.y), z = a.ownWay(b.z);
    const std::array<double, 4> squares{1 + x.x + y.y + z.z, 1 + x.x - y.y - z.z,
                                        1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z};
    const double wx = y.z - z.y, wy = z.x - x.z, wz = x.y - y.x;
    const double xy = y.x + x.y, xz = z.x + x.z, yz = z.y + y.z;
    const std::array<std::array<double, 4>, 4> rows{{{squares[0], wx, wy, wz},
                                                     {wx, squares[1], xy, xz},
                                                     {wy, xy, squares[2], yz},
                                                     {wz, xz, yz, squares[3]}}};
    std::array<double, 4> q = rows[std::ranges::max_element(squares) - squares.begin()];
    if (q[0] < 0)
        for (double& part : q) part = -part;
    const Vec<double> axis{q[1], q[2], q[3]};
    const double sine = length(axis), angle = 2 * arctangent2(sine, q[0]);
    return a.worldWay(divide(angle, sine) * axis);
}

Placement between(const Placement& a, const Placement& b, const Vec<double>& turn, double f) {
    Placement now = a;
    now.at = a.at + f * (b.at - a.at);
    const double angle = length(turn), c = cosine(f * angle), s = sine(f * angle);
    const Vec<double> axis = divide(1.0, angle) * turn;
    for (Vec<double> Placement::* const side : {&Placement::x, &Placement::y, &Placement::z}) {
        const Vec<double>& d = a.*side;
        now.*side = c * d + s * cross(axis, d) + (1 - c) * dot(axis, d) * axis;
    }
    return now;
}

Posing keyed(const std::vector<Key>& keys) {
    if (keys.empty()) throw std::invalid_argument("keys: there are none");
    std::vector<Placement> places;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (!isFinite(keys[i].t) || (i > 0 && !(keys[i].t > keys[i - 1].t)))
            throw std::invalid_argument("keys: time " + std::to_string(keys[i].t) +
                                        " s does not come after the one before");
        places.emplace_back(keys[i].frame, "keys");
    }
    return [keys, places](double t) {
        const auto after =
            std::ranges::upper_bound(keys, t, {}, [](const Key& key) { return key.t; });
        if (after == keys.begin()) return keys.front().frame;
        if (after == keys.end()) return keys.back().frame;
        const auto i = static_cast<std::size_t>(after - keys.begin());
        const Placement &a = places[i - 1], &b = places[i];
        const double f = (t - keys[i - 1].t) / (keys[i].t - keys[i - 1].t);
        return between(a, b, turnBetween(a, b), f).frame();
    };
}

}  // namespace plait
