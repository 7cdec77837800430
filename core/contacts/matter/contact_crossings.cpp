// The last word of a substep: what still crosses.
#include "contact_set.h"
#include "reals.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace plait {
namespace {

constexpr int innerPasses = 5;  // M 4.2
// In a substep, before contacts give up: what goes back is in the way of others, so that each round
// reaches a ring of vertices further, and costs as much as looking for pairs. A sheet that falls on
// a ball in few substeps takes up to 27, a strip twisted ten turns 38, and less than a pair for
// five vertices in all; where a body jumps, tens of pairs a vertex cross again and again.
constexpr int mostBackRounds = 64, mostBackPairs = 16;  // the latter a vertex

// Others have their thickness for all that keeps them apart.
bool canCross(const Pairing& pair) { return pair.first + pair.second == 4; }

}  // namespace

// Adds the pair if its paths cross; particles and curves, which never quite do, if they come within
// a quarter of their gap.
template <class Real>
void ContactSet<Real>::check(const Pairing& pair, std::vector<Contact>& list) const {
    if (failures_ && failures_->leavesOut(pair)) return;
    const Rounding rounding = sections_.of(pair);
    const PairPoints start = rounding.to(startOf(pair)), end = rounding.to(headingOf(pair));
    if (!mayMeet(pair, start, end, 0)) return;
    const Nearest now = nearest(pair, start);
    const double distance = length(now.apart), gap = gapOf(pair, now);
    const double thickness = canCross(pair) ? 0 : leastPart * std::min(gap, distance);
    if (distance == 0 || !movesBy(distance - thickness, pair, start, end)) return;
    if (impactOf(pair, start, end, thickness))
        list.push_back({.pair = pair, .distance = distance, .gap = gap});
}

// Who is further from where it was heading than contacts reach: of all others, what crosses is
// among them. False where these are too many to be asked about one by one.
template <class Real>
bool ContactSet<Real>::findStrays(Workers& workers) {
    if (!ready_) return false;
    isStray_.resize(end_.size());
    std::atomic<bool> any{false};
    workers.forBlocks(static_cast<int>(end_.size()), 1024, [&](int begin, int end) {
        bool some = false;
        for (int v = begin; v < end; ++v) {
            const Vec<double> d = end_[v] - heading_[v];
            isStray_[v] = search_.surfaceOf(v) >= 0 && !(4 * dot(d, d) < slack_ * slack_);
            some |= isStray_[v] != 0;
        }
        if (some) any = true;
    });
    strays_.clear();
    if (!any) return true;
    const auto most = std::ssize(end_) / 64;
    for (int v = 0; v < std::ssize(end_) && std::ssize(strays_) <= most; ++v)
        if (isStray_[v]) strays_.push_back(v);
    return std::ssize(strays_) <= most;
}

// Finds where vertices are heading, and which of them elsewhere than when that was last asked in
// this substep: all, if it was not yet. Returns whether there are any.
template <class Real>
bool ContactSet<Real>::findMoved(const Sweep<Real>& sweep, Workers& workers) {
    locate(sweep, workers);
    const bool first = seen_.empty();
    seen_.resize(end_.size());
    moved_.resize(end_.size());
    std::atomic<bool> any{false};
    workers.forBlocks(static_cast<int>(end_.size()), 1024, [&](int begin, int end) {
        bool some = false;
        for (int v = begin; v < end; ++v) {
            moved_[v] = first || end_[v] != seen_[v];
            seen_[v] = end_[v];
            some |= moved_[v] != 0;
        }
        if (some) any = true;
    });
    return any;
}

// Replaces crossing_ by the pairs whose paths cross.
template <class Real>
void ContactSet<Real>::cross(const Sweep<Real>& sweep, Workers& workers) {
    if (findMoved(sweep, workers) || !crossing_.empty()) crossMoved(sweep, workers);
}

// Of those that have not moved the same cross as before.
template <class Real>
void ContactSet<Real>::crossMoved(const Sweep<Real>& sweep, Workers& workers) {
    if (!crossForeseen(sweep, workers)) {
        isElsewhere_ = true;
        counts_.searches += search_.cover(start_, end_, slack_, workers);
        search_.collect(
            parts_, 0.5 * widest_, workers,
            [&](const Pairing& pair, std::vector<Contact>& list) { check(pair, list); }, moved_);
    }
    for (const Contact& c : crossing_)
        if (!hasMoved(c.pair.vertices)) check(c.pair, parts_.front());
    sortParts(workers);
    crossing_.clear();
    for (const Contact* const c : ordered_) crossing_.push_back(*c);
    counts_.impacts += static_cast<long>(crossing_.size());
}

// Contacts, and what is round those that have strayed from where it was looked.
template <class Real>
bool ContactSet<Real>::crossForeseen(const Sweep<Real>& sweep, Workers& workers) {
    if (!findStrays(workers)) return false;
    std::optional<std::vector<Pairing>> round;
    if (!strays_.empty()) {
        if (isElsewhere_) return false;
        round = search_.around(strays_, start_, end_, slack_, workers);
        if (!round) return false;
    }
    const auto isAsked = [&](const std::array<int, 4>& v) {
        return hasMoved(v) &&
               !(isStray_[v[0]] || isStray_[v[1]] || isStray_[v[2]] || isStray_[v[3]]);
    };
    constexpr int block = 1024;
    parts_.resize(std::max(parts_.size(), std::size_t(foreseen_ / block + 1)));
    for (auto& part : parts_) part.clear();
    workers.forBlocks(foreseen_ / block + 1, 1, [&](int begin, int end) {
        for (int b = begin; b < end; ++b)
            for (int i = b * block; i < std::min((b + 1) * block, foreseen_); ++i)
                if (isAsked(watches_[i].vertices) && !clear(sweep, watches_[i]))
                    check(contacts_[i].pair, parts_[b]);
    });
    if (round)
        for (const Pairing& pair : *round)
            if (hasMoved(pair.vertices)) check(pair, parts_.front());
    return true;
}

template <class Real>
long ContactSet<Real>::finish(const Sweep<Real>& sweep, Workers& workers) {
    for (Contact& c : contacts_) counts_.limited += std::exchange(c.limited, false);
    if (options_.detection == Detection::end || gaveUp_) return 0;
    long work = 0;
    cross(sweep, workers);
    for (int pass = 0; pass < innerPasses && !crossing_.empty(); ++pass) {
        findPoses(sweep, workers);
        for (Contact& c : crossing_) {
            part(sweep, c);
            counts_.limited += std::exchange(c.limited, false);
        }
        work += static_cast<long>(crossing_.size());
        contacts_.insert(contacts_.end(), crossing_.begin(), crossing_.end());
        ++counts_.passes;
        cross(sweep, workers);
    }
    putAllBack(sweep, workers, false);
    return work;
}

template <class Real>
long ContactSet<Real>::holdBack(const Sweep<Real>& sweep, Workers& workers) {
    if (gaveUp_) return putEverythingBack(sweep);
    if (options_.detection == Detection::end || !findMoved(sweep, workers)) return 0;
    crossMoved(sweep, workers);
    return putAllBack(sweep, workers, true);
}

// Until nothing crosses but what is where the substep began; `hold`: all goes there, since others
// than contacts have put something there. Returns how many vertices that moves.
template <class Real>
long ContactSet<Real>::putAllBack(const Sweep<Real>& sweep, Workers& workers, bool hold) {
    long sum = 0;
    zones_.clear();
    while (!crossing_.empty()) {
        workers.askInterrupt();
        backPairs_ += std::ssize(crossing_);
        gaveUp_ = ++backRounds_ > mostBackRounds || backPairs_ > mostBackPairs * std::ssize(start_);
        if (gaveUp_) {
            sum += putEverythingBack(sweep);
            break;
        }
        const int held = putBack(sweep, hold);
        contacts_.insert(contacts_.end(), crossing_.begin(), crossing_.end());
        if (held == 0) {
            counts_.failed += static_cast<long>(crossing_.size());
            for (const Contact& c : crossing_)
                if (failures_) failures_->fail(c.pair, counts_);
            break;
        }
        sum += held;
        cross(sweep, workers);
    }
    counts_.heldBack += sum;
    return sum;
}

// What crosses goes back. Returns how many vertices that moves.
template <class Real>
int ContactSet<Real>::putBack(const Sweep<Real>& sweep, bool hold) {
    for (Contact& c : crossing_) {
        c.push = 1;  // pushed, for those who ask
        whole_.clear();
        for (int i = 0; i < c.pair.first + c.pair.second; ++i) {
            const int v = c.pair.vertices[i], piece = pieces_.of(v);
            const Range all = piece < 0 ? Range{v, v + 1} : pieces_.body(piece).vertices;
            for (int u = all.first; u < all.last; ++u) whole_.push_back(u);
        }
        zones_.join(whole_, pinned_, hold);
    }
    return zones_.put(sweep);
}

template <class Real>
long ContactSet<Real>::putEverythingBack(const Sweep<Real>& sweep) const {
    long held = 0;
    for (int v = 0; v < std::ssize(start_); ++v)
        held += (search_.surfaceOf(v) >= 0 || pieces_.of(v) >= 0) && !pinned_[v] &&
                plait::putBack(sweep, v);
    return held;
}

// Of what cannot cross, particles among each other and with curves, a pair is counted once, as it
// is pressed within a quarter of its gap.
template <class Real>
void ContactSet<Real>::conclude(const Sweep<Real>& sweep, Workers& workers) {
    counts_.givenUp += gaveUp_;
    if (!ready_ || gaveUp_ || !search_.hasRound()) return;
    std::atomic<long> pressed{0};
    workers.forBlocks(foreseen_, 256, [&](int begin, int end) {
        long count = 0;
        for (int n = begin; n < end; ++n) {
            const Contact& c = contacts_[n];
            if (canCross(c.pair) || clear(sweep, watches_[n])) continue;
            const Nearest now = nearest(c.pair, sections_.of(c.pair).to(endOf(sweep, c.pair)));
            const double least = leastPart * wholeGapOf(c.pair, now);
            count += length(now.apart) < least && c.distance >= least;
        }
        pressed += count;
    });
    counts_.pressed += pressed;
}

template class ContactSet<float>;
template class ContactSet<double>;

}  // namespace plait
