#include "contact_set.h"

#include "../../numbers/convert.h"
#include "../../world.h"
#include "reals.h"

#include <algorithm>

namespace plait {
namespace {

double meanEdge(const World& world, const std::vector<Surface>& surfaces) {
    double sum = 0;
    long count = 0;
    for (int e = 0; e < world.complex.count(1); ++e) {
        const auto ids = world.complex.vertices(1, e);
        if (world.pinned[ids[0]] && world.pinned[ids[1]]) continue;
        for (const Surface& s : surfaces)
            if (ids[0] >= s.vertices.first && ids[0] < s.vertices.last) {
                sum += length(world.rest[ids[1]] - world.rest[ids[0]]);
                ++count;
            }
    }
    return count ? sum / static_cast<double>(count) : 0;
}

double thickest(const Surface& s) {
    double most = s.thickness.value_or(0);
    for (const double r : s.radii) most = std::max(most, r);
    return most;
}

double thickest(const std::vector<Surface>& surfaces) {
    double most = 0;
    for (const Surface& s : surfaces) most = std::max(most, thickest(s));
    return most;
}

double widest(const std::vector<Surface>& surfaces) {
    double most = thickest(surfaces);
    for (const Surface& s : surfaces)
        most = std::max(
            most, std::max(thickest(s), s.halfWidth) * (s.self != Self::none ? s.selfWidth : 1));
    return most;
}

double marginOf(const World& world, const std::vector<Surface>& surfaces, double asked) {
    return asked > 0 ? asked : std::max(0.2 * meanEdge(world, surfaces), 0.5 * thickest(surfaces));
}

}  // namespace

template <class Real>
ContactSet<Real>::ContactSet(const World& world, const std::vector<Surface>& surfaces,
                             const ContactOptions& options)
    : options_(options),
      search_(world.complex, surfaces, world.pinned, marginOf(world, surfaces, options.margin),
              world.wholes()),
      sections_(world, surfaces),
      rest_(world.rest),
      start_(world.start),
      end_(world.start),
      pinned_(world.pinned),
      pieces_(world),
      poses_(pieces_.count()),
      gravity_(world.gravity),
      zones_(world.start.size()),
      taken_(world.start.size()),
      slack_(thickest(surfaces)),
      widest_(widest(surfaces)) {
    for (int p = 0; p < pieces_.count(); ++p) {
        const Body& body = pieces_.body(p);
        for (int v = body.vertices.first; v < body.vertices.last && body.inverseMass == 0; ++v)
            pinned_[v] = 1;
    }
    for (const Surface& s : surfaces) bouncy_ = bouncy_ || s.restitution > 0;
    for (std::size_t v = 0; v < world.mass.size(); ++v)
        inverseMass_.push_back(world.pinned[v] ? 0 : 1 / world.mass[v]);
    if (Failures::needed(surfaces, options))
        failures_ = std::make_unique<Failures>(world, surfaces, options);
    if (options_.mass == ContactMass::physical) return;
    for (const Surface& s : surfaces)
        for (int v = s.vertices.first; v < s.vertices.last; ++v)
            inverseMass_[v] = world.pinned[v] ? 0 : 1 / s.pointMass;
}

template <class Real>
void ContactSet<Real>::begin(const Substep& substep, Workers&) {
    h_ = substep.h;
    opens_ = substep.parts ? options_.recovery * h_ : 0;
    backRounds_ = 0;
    backPairs_ = 0;
    contacts_.clear();
    crossing_.clear();
    seen_.clear();
    bent_.clear();
    ready_ = false;
}

template <class Real>
void ContactSet<Real>::locate(const Sweep<Real>& sweep, Workers& workers) {
    workers.forBlocks(static_cast<int>(start_.size()), 1024, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const Real* const p = sweep.particles + 8 * v;
            const Real* const b = sweep.before + 4 * v;
            start_[v] = three(p) + three(b);
            end_[v] = three(p) + three(p + 4);
        }
    });
    sections_.turn(start_);
}

template <class Real>
PairPoints ContactSet<Real>::startOf(const Pairing& pair) const {
    const auto& v = pair.vertices;
    return {start_[v[0]], start_[v[1]], start_[v[2]], start_[v[3]]};
}

template <class Real>
PairPoints ContactSet<Real>::headingOf(const Pairing& pair) const {
    const auto& v = pair.vertices;
    return {end_[v[0]], end_[v[1]], end_[v[2]], end_[v[3]]};
}

// Where a contact's vertices are by now.
template <class Real>
PairPoints ContactSet<Real>::endOf(const Sweep<Real>& sweep, const Pairing& pair) const {
    PairPoints x;
    for (std::size_t i = 0; i < 4; ++i) {
        const Real* const p = sweep.particles + 8 * pair.vertices[i];
        x[i] = three(p) + three(p + 4);
    }
    return x;
}

// Two of one sheet that lie nearer at rest stay as near.
template <class Real>
double ContactSet<Real>::wholeGapOf(const Pairing& pair, const Nearest& now) const {
    const auto& v = pair.vertices;
    double gap = 0;
    for (std::size_t i = 0; i < 4; ++i) gap += std::fabs(now.weight[i]) * search_.thickness(v[i]);
    if (search_.surfaceOf(v[0]) == search_.surfaceOf(v[3])) {
        gap *= search_.width(v[0], v[3]);
        const PairPoints rest =
            sections_.atRest(pair).to({rest_[v[0]], rest_[v[1]], rest_[v[2]], rest_[v[3]]});
        if (mayMeet(pair, rest, rest, gap)) gap = std::min(gap, length(nearest(pair, rest).apart));
    }
    return gap;
}

// What begins too near parts no faster than `recovery`, however thick it is (CC15, CC17), and flies
// on at that speed, but for what begins a run too near (solver_parting.cpp). No slower: what a
// substep leaves too near under load must be mended in the next. By what is left over 10 ms a stack
// sinks 2.6 % of its size, not 0.3 %, and knots are pulled through themselves.
template <class Real>
double ContactSet<Real>::gapOf(const Pairing& pair, const Nearest& now) const {
    return std::min(wholeGapOf(pair, now), length(now.apart) + opens_);
}

template <class Real>
void ContactSet<Real>::consider(const Pairing& pair, std::vector<Contact>& list) const {
    if (failures_ && failures_->leavesOut(pair)) return;
    const auto& v = pair.vertices;
    double thickness[2]{};
    for (int i = 0; i < pair.first + pair.second; ++i) {
        double& side = thickness[i >= pair.first];
        side = std::max(side, search_.thickness(v[i]));
    }
    const Rounding rounding = sections_.of(pair);
    const PairPoints start = rounding.to(startOf(pair)), end = rounding.to(headingOf(pair));
    const double reach = search_.width(v[0], v[3]) * (thickness[0] + thickness[1]) + slack_;
    if (!mayMeet(pair, start, end, reach)) return;
    const Nearest now = nearest(pair, start);
    if (!comesWithin(reach, pair, now, start, end)) return;
    Contact contact{.pair = pair, .distance = length(now.apart), .gap = gapOf(pair, now)};
    contact.watch = watchOf(contact, rounding, divide(1.0, contact.distance) * now.apart, start);
    list.push_back(contact);
}

template <class Real>
void ContactSet<Real>::prepare(const Sweep<Real>& sweep, Workers& workers) {
    locate(sweep, workers);
    counts_.searches += search_.cover(start_, end_, slack_, workers);
    counts_.pairs = std::max(counts_.pairs, search_.size());
    search_.collect(parts_, 2 * widest_ + slack_, workers,
                    [&](const Pairing& pair, std::vector<Contact>& list) { consider(pair, list); });
    sortParts(workers);
    colour(workers);
    counts_.contacts = std::max(counts_.contacts, static_cast<long>(contacts_.size()));
    foreseen_ = static_cast<int>(contacts_.size());
    heading_ = end_;
    isElsewhere_ = false;
    ready_ = true;
}

// What is pierced may be meant to stay so, or be drawn apart by others.
template <class Real>
double ContactSet<Real>::partingTime(const Sweep<Real>& sweep, Workers& workers) {
    if (failures_) return infinity;
    prepare(sweep, workers);
    double most = 0;
    for (const Contact& c : contacts_) {
        const Nearest now = nearest(c.pair, sections_.of(c.pair).to(startOf(c.pair)));
        most = std::max(most, lackOf(length(now.apart), wholeGapOf(c.pair, now)));
    }
    return divide(most, options_.recovery);
}

template <class Real>
void ContactSet<Real>::furnish(Drawer<Real>& kept) const {
    if (failures_) kept.integers = failures_->flags();
}

template <class Real>
void ContactSet<Real>::strike(const Sweep<Real>& sweep, const State<Real>& state,
                              const Drawer<Real>& kept, Workers& workers) {
    if (failures_) {
        locate(sweep, workers);
        failures_->begin(start_, kept.integers, counts_, workers);
    }
    if (!bouncy_ || gaveUp_) return;
    prepare(sweep, workers);
    bend(sweep, state);
}

// Paths end where bounces send them.
template <class Real>
void ContactSet<Real>::bend(const Sweep<Real>& sweep, const State<Real>& state) {
    paths_.resize(start_.size());
    for (std::size_t v = 0; v < paths_.size(); ++v) {
        paths_[v] = {.start = start_[v], .end = end_[v]};
        if (!state.hasPast) continue;
        const Vec<Real> way = state.before[v].v - state.last[v].v;
        paths_[v].gain = end_[v] - start_[v] - as<double>(way);
    }
    bounces_.clear();
    for (const Contact& c : contacts_) {
        const Surface& a = search_.surfaces()[search_.surfaceOf(c.pair.vertices[0])];
        const Surface& b = search_.surfaces()[search_.surfaceOf(c.pair.vertices[3])];
        const double restitution = 0.5 * (a.restitution + b.restitution);
        const double mean = 0.5 * frictionPart(a, b) * (a.dynamicFriction + b.dynamicFriction);
        const double sliding = std::clamp(mean, 0.0, 1.0);
        if (restitution > 0) bounces_.push_back({c.pair, c.gap, restitution, sliding});
    }
    const double slow = std::max(options_.bounceThreshold, 2 * gravity_ * h_) * h_;
    const int limit = 16 + 4 * static_cast<int>(bounces_.size());
    const Bounced bounced = bounce(bounces_, inverseMass_, paths_, slow, limit);
    counts_.bounces += bounced.count;
    counts_.cut += bounced.cut;
    for (std::size_t v = 0; v < paths_.size(); ++v) {
        if (!paths_[v].bent) continue;
        bent_.push_back(static_cast<int>(v));
        Real* const p = sweep.particles + 8 * v;
        put(p + 4, paths_[v].end - three(p));
    }
}

// The first-order velocity and a past that continues it, so that BDF2 extrapolates no bounce.
template <class Real>
void ContactSet<Real>::rebound(State<Real>& state, Drawer<Real>& kept) const {
    if (failures_) kept.integers = failures_->flags();
    for (const int v : bent_) {
        const Vec<double> kick = divide(1.0, h_) * (start_[v] - paths_[v].start);
        const Vec<Real> d = state.particles[v].d;
        const Vec<Real> velocity =
            static_cast<Real>(1 / h_) * (d - state.last[v].v) + as<Real>(kick);
        state.velocity[v].v = velocity;
        if (!state.lastVelocity.empty()) state.lastVelocity[v].v = velocity;
        state.last[v].v = d - static_cast<Real>(h_) * velocity;
    }
}

template <class Real>
void ContactSet<Real>::markTouched(std::vector<std::uint8_t>& touched) const {
    for (const Contact& c : contacts_) {
        if (c.push == 0) continue;
        for (const int v : c.pair.vertices) {
            const int piece = pieces_.of(v);
            const Range all = piece < 0 ? Range{v, v + 1} : pieces_.body(piece).vertices;
            std::fill(touched.begin() + all.first, touched.begin() + all.last, std::uint8_t{1});
        }
    }
}

template <class Real>
void ContactSet<Real>::findPoses(const Sweep<Real>& sweep, Workers& workers) {
    workers.forBlocks(pieces_.count(), 16, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) poses_[p] = pieces_.poseOf(sweep, p);
    });
}

template class ContactSet<float>;
template class ContactSet<double>;

}  // namespace plait
