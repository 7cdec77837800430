// Where a rigid thing stands, and how it gets from there to where it stands next.
#pragma once

#include "../../complex/shapes.h"

#include <functional>
#include <string>
#include <vector>

namespace plait {

using Posing = std::function<Frame(double t)>;  // t in s

// Where something stands at a time (s).
struct Key {
    double t;
    Frame frame;
};

// Through these keys, in order of time: origins go straight and steadily from one to the next,
// turns are steady and the shorter way round. Before the first and after the last it stands still.
// Throws std::invalid_argument for no keys, times that do not grow, or what is no frame.
Posing keyed(const std::vector<Key>& keys);

// A frame as a map between the world's axes and its own, m.
struct Placement {
    Vec<double> at, x, y, z;  // the origin, and unit vectors along its axes

    // Throws std::invalid_argument, naming `who`, for what is no frame (to 1e-6).
    Placement(const Frame& frame, const std::string& who);

    Vec<double> own(const Vec<double>& p) const { return ownWay(p - at); }
    Vec<double> ownWay(const Vec<double>& d) const { return {dot(x, d), dot(y, d), dot(z, d)}; }
    Vec<double> world(const Vec<double>& p) const { return at + worldWay(p); }
    Vec<double> worldWay(const Vec<double>& d) const { return d.x * x + d.y * y + d.z * z; }
    Frame frame() const { return {at, x, y}; }
};

// The turn from a to b, the shorter way round: along its axis, in rad.
Vec<double> turnBetween(const Placement& a, const Placement& b);

// The part f of the way from a to b, which is turned by `turn` against a.
Placement between(const Placement& a, const Placement& b, const Vec<double>& turn, double f);

}  // namespace plait
