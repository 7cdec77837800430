// What crosses when all else has been tried goes back to how it lay when the substep began, which
// was free of crossings: all that hangs together by crossings moves as one, by the mean of where it
// was going. So nothing of it crosses, its momentum stays, and it is the same for who flies along.
// (Rigid impact zones, Bridson, Fedkiw and Anderson, "Robust treatment of collisions", 2002; but
// without turning, on which what lies close could cross.)
#pragma once

#include "../../numbers/math.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

template <class Real>
struct Sweep;

class ImpactZones {
public:
    explicit ImpactZones(std::size_t vertices) : parent_(vertices, -1), zones_(vertices) {}

    void clear();
    // All of these cross. They go back to their places at the start if one is pinned, since that
    // does not come along, or if they are to be held.
    void join(std::span<const int> vertices, std::span<const unsigned char> pinned, bool held);
    // Of what was joined since the last time; what crosses although it was put goes back to its
    // place at the start. Returns how many vertices that moves.
    template <class Real>
    int put(const Sweep<Real>& sweep);

private:
    struct Zone {
        int members = 1;
        int put = 0;        // members when it was last put
        bool held = false;  // at its place at the start
        bool crosses = true;
        double mass = 0;           // kg
        Vec<double> way{0, 0, 0};  // kg m, from the start, of all members
    };

    int rootOf(int vertex);
    Zone& zoneOf(int vertex) { return zones_[rootOf(vertex)]; }

    std::vector<int> parent_;   // by vertex; -1: in no zone
    std::vector<Zone> zones_;   // by vertex, of those that are their own parents
    std::vector<int> members_;  // of all zones
};

}  // namespace plait
