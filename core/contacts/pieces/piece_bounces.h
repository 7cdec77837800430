// Impacts of pieces that bounce, as speeds: after the substep in which two have met, one impact
// after the other, the fastest first (S 7, figure 20; matter/impacts.h bends paths instead, vertex
// by vertex). What is struck takes the speed that its impact leaves, from the one with which it
// came, so that an impact runs along a row of balls as it does in Newton's cradle, where all
// impacts at once would part them all.
#pragma once

#include "../../numbers/symmetric.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

class PieceBounces {
public:
    // What moves as one. It comes at the speed with which the substep began and falls freely until
    // it is struck for the first time.
    struct Body {
        Vec<double> centre{};                // m, where the substep ends
        double inverseMass = 0;              // 1/kg; 0: it does not yield
        Symmetric<double> inverseInertia{};  // 1/(kg m^2)
        Vec<double> velocity{}, spin{};      // m/s, rad/s
        Vec<double> gain{};                  // m/s^2, while nothing strikes it
        bool struck = false;
    };
    struct Point {
        Vec<double> at;  // m, of both
        double way;      // m, by which the two have come nearer there since the substep began
    };
    struct Pair {
        int first, second;   // bodies
        Vec<double> normal;  // of unit length, to the first
        double restitution, friction;
        std::vector<Point> points;
    };

    // What two get from each other, the second the opposite: kg m/s, and kg m^2/s about either
    // centre.
    struct Kick {
        Vec<double> impulse{}, twistFirst{}, twistSecond{};
    };

    std::vector<Body> bodies;
    std::vector<Pair> pairs;

    // Follows all impacts from those on that bounce, in a substep of h (s). What approaches more
    // slowly than `slow` (m/s) does not bounce. Speed apart is restitution times the speed of
    // approach where they touched, which a free fall over the way would give; never more energy
    // than before, which friction and restitution together could bring. Returns how many bounced;
    // `cut`: more were left than are followed.
    int follow(double h, double slow, bool& cut);

private:
    struct Approach {
        double speed;  // m/s
        double time;   // s, in the substep
    };

    Body& body(int i) { return bodies[static_cast<std::size_t>(i)]; }
    const Body& body(int i) const { return bodies[static_cast<std::size_t>(i)]; }
    Vec<double> speedAt(int i, const Vec<double>& at) const {
        return body(i).velocity + cross(body(i).spin, at - body(i).centre);
    }
    Approach approachOf(const Pair& pair, double h) const;
    void strike(const Pair& pair, double time);
    Kick kickOf(const Pair& pair, double restitution) const;
    Kick bounceOf(const Pair& pair) const;
    void move(const Pair& pair, const Kick& kick);
    bool settle(double slow);

    std::vector<double> approach_;  // m/s, by pair
};

}  // namespace plait
