// What pieces do after the last column: what crosses becomes contacts, and what crosses still goes
// back.
#include "../matter/reals.h"
#include "piece_contacts.h"

#include <algorithm>
#include <atomic>

namespace plait {
namespace {

constexpr double leastGap = 0.02;  // part of a gap: nearer than that they cross

}  // namespace

// Whether what is known of them says that they have not met: their ways are as foreseen, or the
// plane of their contact parts them at both ends.
template <class Real>
bool PieceContacts<Real>::parted(const NearPieces::Near& near) const {
    if (joined(near)) return true;
    const int first = near.first, second = near.second, pair = near.pair;
    if (!moved_[first] && !moved_[second]) return !near.crosses;
    if (pair < 0) return near.away && strayed_[first] + strayed_[second] < slack_;
    const TouchedPair& plane = touches_.pairs[pair];
    const double least = leastGap * gapOf(first, second);
    for (const std::vector<Pose>* const poses : {&touches_.poses, &starts_}) {
        const Pose &a = (*poses)[first], &b = (*poses)[second];
        const Vec<double> n = Touches::normalOf(plane, a, b);
        if (shapes_[first].lowest(a, n) + shapes_[second].lowest(b, -n) < least) return false;
    }
    return true;
}

// Whether two are as near as all but nothing, or have passed through each other, and where they
// meet. On their way arcs bulge beyond chords, so that they may come that much nearer than at both
// ends.
template <class Real>
bool PieceContacts<Real>::crosses(const NearPieces::Near& near, Meeting& meeting) const {
    const int first = near.first, second = near.second;
    const Convex &a = shapes_[first], &b = shapes_[second];
    const Pose &nowA = touches_.poses[first], &nowB = touches_.poses[second];
    const auto gapAt = [&](const Pose& one, const Pose& other) {
        meeting.first.put(a, one);
        meeting.second.put(b, other);
        return partingOf(meeting.first, meeting.second, 0).gap;
    };
    const double before = gapAt(starts_[first], starts_[second]);
    if (before <= 0) return false;  // it has crossed by now
    const double gap = gapOf(first, second), least = std::min(leastGap * gap, 0.9 * before);
    const PoseWay wayA(starts_[first], nowA), wayB(starts_[second], nowB);
    if (gapAt(nowA, nowB) >= least) {
        const double bulge =
            (a.radius * wayA.angle() * wayA.angle() + b.radius * wayB.angle() * wayB.angle()) / 8;
        if (!findMeeting(a, wayA, b, wayB, -gap - bulge, -infinity, meeting)) return false;
    }
    return findMeeting(a, wayA, b, wayB, least, least, meeting);
}

template <class Real>
void PieceContacts<Real>::check(NearPieces::Near& near, Found& found) const {
    if (parted(near)) return;
    thread_local Meeting meeting;
    near.crosses = crosses(near, meeting);
    if (!near.crosses) return;
    const int first = near.first, second = near.second;
    add(near, meeting, PoseWay(starts_[first], touches_.poses[first]),
        PoseWay(starts_[second], touches_.poses[second]), found);
}

// What crosses becomes contacts. Returns how many pairs do.
template <class Real>
long PieceContacts<Real>::findCrossing(Workers& workers) {
    std::atomic<bool> far{false};
    workers.forBlocks(pieces_.count(), 16, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) {
            const Pose& pose = touches_.poses[p];
            moved_[p] = !(pose == looked_[p]);
            if (!moved_[p]) continue;
            looked_[p] = pose;
            const Pose foreseen = ways_[p].at(1);
            strayed_[p] = static_cast<float>(length(pose.centre - foreseen.centre) +
                                             shapes_[p].radius * PoseWay(foreseen, pose).angle());
            if (2 * strayed_[p] < static_cast<float>(slack_)) continue;
            NearPieces::Bounds& known = near_.bounds[p];
            const NearPieces::Bounds now = boundsOf(p);
            if (known.holds(now)) continue;
            known.extend(now);
            far = true;
        }
    });
    if (far) near_.find(moves_);
    lookAtNear(workers, [&](NearPieces::Near& near, Found& found) { check(near, found); });
    const long crossing = take();
    counts_.impacts += crossing;
    return crossing;
}

template <class Real>
long PieceContacts<Real>::sweepOn(const Sweep<Real>& sweep, Workers& workers) {
    const int rounds = touches_.sweepOn(2 * leastGap, workers);
    if (rounds > 0) putAll(sweep, workers);
    counts_.passes += rounds;
    return rounds * size();
}

template <class Real>
long PieceContacts<Real>::finish(const Sweep<Real>& sweep, Workers& workers) {
    if (gaveUp_) return 0;
    constexpr int passes = 12;
    findPoses(sweep, workers);
    long work = sweepOn(sweep, workers);
    for (int pass = 0; const long crossing = findCrossing(workers); ++pass) {
        if (pass == passes) {
            putBack(sweep, workers, crossing, false);
            break;
        }
        touches_.colour();
        work += sweepOn(sweep, workers);
    }
    return work;
}

template <class Real>
long PieceContacts<Real>::holdBack(const Sweep<Real>& sweep, Workers& workers) {
    if (gaveUp_) return putEverythingBack(sweep);
    findPoses(sweep, workers);
    const long crossing = findCrossing(workers);
    return crossing > 0 ? putBack(sweep, workers, crossing, true) : 0;
}

// Until nothing crosses but what is where the substep began; the last pairs do.
template <class Real>
long PieceContacts<Real>::putBack(const Sweep<Real>& sweep, Workers& workers, long crossing,
                                  bool hold) {
    constexpr int mostRounds = 64;
    long sum = 0;
    zones_.clear();
    for (; crossing > 0; crossing = findCrossing(workers)) {
        workers.askInterrupt();
        if (++backRounds_ > mostRounds) {
            gaveUp_ = true;
            sum += putEverythingBack(sweep);
            break;
        }
        for (const TouchedPair& pair : std::span(touches_.pairs).last(crossing)) {
            whole_.clear();
            back_.push_back({pair.first, pair.second});
            for (const int piece : {pair.first, pair.second})
                for (const int p : touches_.members(touches_.leader(piece))) {
                    const Range& all = pieces_.body(p).vertices;
                    for (int v = all.first; v < all.last; ++v) whole_.push_back(v);
                }
            zones_.join(whole_, pinned_, hold);
            TouchedPoint& point = touches_.points[pair.from];
            point.push = std::max(point.push, 1e-30);  // for who asks
        }
        const int held = zones_.put(sweep);
        findPoses(sweep, workers);
        if (held == 0) {
            counts_.failed += crossing;
            break;
        }
        sum += held;
    }
    counts_.heldBack += sum;
    return sum;
}

template <class Real>
long PieceContacts<Real>::putEverythingBack(const Sweep<Real>& sweep) const {
    long held = 0;
    for (int p = 0; p < pieces_.count(); ++p) {
        if (!touches_.yields(p)) continue;
        const Range& all = pieces_.body(p).vertices;
        for (int v = all.first; v < all.last; ++v) held += plait::putBack(sweep, v);
    }
    return held;
}

template class PieceContacts<float>;
template class PieceContacts<double>;

}  // namespace plait
