// Where pieces touch: the plane of a pair, and the points along it.
#include "piece_contacts.h"

#include <algorithm>

namespace plait {
namespace {

// Part of what is too near that is taken back in a substep: all of it at once would leave with that
// speed. Where sweeps have not converged contacts are springs; a part r of them answers where
// things are, and what is remembered answers k / (1 - k) substeps late (k: kept, touch_memory.cpp),
// which takes the part r k / (1 - k) of what damps them, 0.23 here. At 0.47 a tower of ten with 100
// times the mass on top swayed ever farther, and what should rest shook at some mm/s.
constexpr double recovered = 0.1;

}  // namespace

// The plane where they meet, if it was between them where the substep began as well; else the one
// that was, unless that is there by now. So all contacts together allow what was, and pushes can
// only take motion away: planes through which both have turned contradict each other, and throw
// them.
template <class Real>
Parting PieceContacts<Real>::planeOf(const NearPieces::Near& near, const Meeting& meeting,
                                     const Pose& firstThere, const Pose& secondThere) const {
    using By = Parting::By;
    const int first = near.first, second = near.second;
    const Pose &a = starts_[first], &b = starts_[second];
    const Vec<double>& n = meeting.parting.normal;
    const Vec<double> began =
        meeting.parting.by == By::edges
            ? n
            : (meeting.parting.by == By::firstFace ? a.turn * firstThere.turn.back(n)
                                                   : b.turn * secondThere.turn.back(n));
    const double apart = shapes_[first].lowest(a, began) + shapes_[second].lowest(b, -began);
    if (near.pair >= 0 || apart > 0) return meeting.parting;
    thread_local Placed placedFirst, placedSecond;
    placedFirst.put(shapes_[first], a);
    placedSecond.put(shapes_[second], b);
    Parting best = partingOf(placedFirst, placedSecond, 0);
    if (best.gap <= apart) return meeting.parting;
    if (best.by == By::firstFace) best.normal = -meeting.first.normals[best.first];
    if (best.by == By::secondFace) best.normal = meeting.second.normals[best.second];
    return best;
}

template <class Real>
void PieceContacts<Real>::add(const NearPieces::Near& near, const Meeting& meeting,
                              const PoseWay& firstWay, const PoseWay& secondWay,
                              Found& found) const {
    const int first = near.first, second = near.second;
    const double gap = gapOf(first, second);
    const Pose a = firstWay.at(meeting.part), b = secondWay.at(meeting.part);
    Parting plane = planeOf(near, meeting, a, b);
    const Vec<double>& n = plane.normal;
    const double left = (1 - meeting.part) * (firstWay.along(-n, shapes_[first].radius) +
                                              secondWay.along(n, shapes_[second].radius));
    thread_local std::vector<TouchPoint> touch;
    findTouch(meeting.first, meeting.second, plane, gap + slack_ + std::max(left, 0.0), touch);
    if (touch.empty()) {  // that plane is far from where they meet
        plane = meeting.parting;
        findTouch(meeting.first, meeting.second, plane, infinity, touch);
    }
    const Surface &sa = surfaces_[first], &sb = surfaces_[second];
    using By = Parting::By;
    using Face = TouchedPair::Face;
    TouchedPair pair{
        first,
        second,
        plane.by == By::edges ? n : (plane.by == By::firstFace ? a.turn.back(n) : b.turn.back(n)),
        plane.by == By::edges ? Face::none
                              : (plane.by == By::firstFace ? Face::first : Face::second),
        gap,
        Friction(sa.staticFriction, sb.staticFriction, sa.dynamicFriction, sb.dynamicFriction),
        0.5 * (sa.restitution + sb.restitution)};
    const Pose &a0 = starts_[first], &b0 = starts_[second];
    const Vec<double> n0 = Touches::normalOf(pair, a0, b0);
    pair.from = static_cast<int>(found.points.size());
    for (const TouchPoint& at : touch) {
        TouchedPoint point{a.turn.back(at.first - a.centre), b.turn.back(at.second - b.centre)};
        point.rest = Touches::apartOf(point, a0, b0);
        const double start = dot(n0, point.rest), tooNear = gap - start;
        point.gap =
            tooNear > 0 ? start + std::min(recovered * tooNear, options_.recovery * h_) : gap;
        found.points.push_back(point);
    }
    pair.to = static_cast<int>(found.points.size());
    found.pairs.push_back(pair);
}

// Whether the plane that was last between them keeps them farther apart than contacts reach.
template <class Real>
bool PieceContacts<Real>::staysAway(const NearPieces::Near& near) const {
    if (joined(near)) return true;
    const int first = near.first, second = near.second;
    const Vec<double>& n = near.between;
    if (n == Vec<double>{}) return false;
    const double far = gapOf(first, second) + slack_ + bulgeOf(first) + bulgeOf(second);
    for (const std::vector<Pose>* const poses : {&touches_.poses, &starts_})
        if (shapes_[first].lowest((*poses)[first], n) +
                shapes_[second].lowest((*poses)[second], -n) <=
            far)
            return false;
    return true;
}

// What begins too near parts no faster than `recovery`.
template <class Real>
void PieceContacts<Real>::foresee(NearPieces::Near& near, Found& found) const {
    near.pair = -1;
    near.crosses = false;
    near.away = staysAway(near);
    if (near.away) return;
    thread_local Meeting meeting;
    const int first = near.first, second = near.second;
    const double gap = gapOf(first, second);
    const PoseWay &a = ways_[first], &b = ways_[second];
    near.away = !findMeeting(shapes_[first], a, shapes_[second], b, gap, gap + slack_, meeting);
    if (!near.away) add(near, meeting, a, b, found);
    near.between = meeting.parting.normal;
}

// What was found becomes contacts. Returns how many pairs that are.
template <class Real>
long PieceContacts<Real>::take() {
    const auto before = std::ssize(touches_.pairs);
    auto near = near_.pairs.begin();
    for (const Found& found : found_) {
        const int from = static_cast<int>(touches_.points.size());
        touches_.points.insert(touches_.points.end(), found.points.begin(), found.points.end());
        for (TouchedPair pair : found.pairs) {
            while (near->first != pair.first || near->second != pair.second) ++near;
            near->pair = static_cast<int>(touches_.pairs.size());
            pair.from += from;
            pair.to += from;
            touches_.pairs.push_back(pair);
        }
    }
    return std::ssize(touches_.pairs) - before;
}

template class PieceContacts<float>;
template class PieceContacts<double>;

}  // namespace plait
