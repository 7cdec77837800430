// Pieces that move as one, and what contacts press them with.
#include "piece_contacts.h"

#include <algorithm>
#include <numeric>

namespace plait {

template <class Real>
void PieceContacts<Real>::joinClusters() {
    if (leaders_.empty()) return;
    touches_.join(leaders_, starts_);
    for (int p = 0; p < pieces_.count(); ++p) {
        const Range& all = pieces_.body(p).vertices;
        const bool yields = touches_.yields(p);
        std::fill(pinned_.begin() + all.first, pinned_.begin() + all.last, yields ? 0 : 1);
        moves_[p] = yields || !(starts_[p] == touches_.poses[p]);
    }
}

template <class Real>
void PieceContacts<Real>::addLoads(std::vector<Load>& loads) const {
    for (const TouchedPair& pair : touches_.pairs) {
        const int first = pair.first, second = pair.second;
        const Vec<double> n = touches_.normalOf(pair);
        const Pose a = ways_[first].at(1), b = ways_[second].at(1);
        for (const TouchedPoint& point : touches_.of(pair)) {
            if (point.push == 0) continue;
            const Vec<double> impulse = point.push * n + point.grip;
            const Vec<double> start = Touches::apartOf(point, starts_[first], starts_[second]);
            const double way = dot(n, start - Touches::apartOf(point, a, b));
            // What was open as the substep began is not stopped on its way to where it touches.
            const double open = std::max(0.0, dot(n, start) - point.gap);
            // In a substep's last hundredth what touches tells little of what it takes to stop it.
            const double taken = way > open ? std::max(0.01, 1 - open / way) : 1;
            const Vec<double> whole = (1 / taken) * impulse;
            const Touches::Levers levers = touches_.leversOf(pair, point);
            loads.push_back(
                {first, touches_.centreOf(first) + levers.first, impulse, whole, way / h_, second});
            loads.push_back({second, touches_.centreOf(second) + levers.second, -impulse, -whole,
                             way / h_, first});
        }
    }
    if (!back_.empty()) addHeld(loads);
}

// What is put back is stopped by what does not yield, which bears what of this contacts do not
// tell: all that hangs together by having been put back has one such push.
template <class Real>
void PieceContacts<Real>::addHeld(std::vector<Load>& loads) const {
    std::vector<int> zones(pieces_.count());
    std::iota(zones.begin(), zones.end(), 0);
    const auto zoneOf = [&](int piece) {
        int zone = touches_.leader(piece);
        while (zones[zone] != zone) zone = zones[zone] = zones[zones[zone]];
        return zone;
    };
    for (const auto& [first, second] : back_)
        if (touches_.yields(first) && touches_.yields(second))
            zones[zoneOf(first)] = zoneOf(second);
    std::vector<Vec<double>> left(pieces_.count());  // kg m
    std::vector<double> mass(pieces_.count());
    for (int p = 0; p < pieces_.count(); ++p) {
        if (!touches_.yields(p)) continue;
        const double m = 1 / pieces_.body(p).inverseMass;
        mass[zoneOf(p)] += m;
        left[zoneOf(p)] += m * (touches_.poses[p].centre - ways_[p].at(1).centre);
    }
    for (const Load& load : loads)
        if (touches_.yields(load.piece)) left[zoneOf(load.piece)] -= load.impulse;
    std::vector<int> holders(pieces_.count());
    for (const auto& [first, second] : back_)
        for (const auto& [p, q] : {std::pair{first, second}, {second, first}})
            if (touches_.yields(p) && !touches_.yields(q)) ++holders[zoneOf(p)];
    for (const auto& [first, second] : back_)
        for (const auto& [p, q] : {std::pair{first, second}, {second, first}}) {
            if (!touches_.yields(p) || touches_.yields(q)) continue;
            const int zone = zoneOf(p);
            const double speed = length(left[zone]) / (mass[zone] * h_);
            const Vec<double> impulse = (-1.0 / holders[zone]) * left[zone];
            loads.push_back({q, touches_.poses[p].centre, impulse, impulse, speed, p});
        }
}

template class PieceContacts<float>;
template class PieceContacts<double>;

}  // namespace plait
