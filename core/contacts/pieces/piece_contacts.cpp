#include "piece_contacts.h"

#include "../../world.h"
#include "../checks.h"

#include <algorithm>
#include <stdexcept>

namespace plait {
namespace {

constexpr int partners = 8;  // pairs a piece is remembered in, in the mean

Convex shapeOf(const World& world, const Body& body, const Surface& surface,
               const std::string& name) {
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < world.complex.count(2); ++t) {
        std::array<int, 3> v = world.complex.triangle(t);
        if (v[0] < surface.vertices.first || v[0] >= surface.vertices.last) continue;
        for (int& corner : v) corner -= surface.vertices.first;
        triangles.push_back(v);
    }
    const std::span<const Vec<double>> rest(world.rest);
    return convexOf(rest.subspan(surface.vertices.first, surface.vertices.size()), triangles,
                    body.centre, name);
}

}  // namespace

template <class Real>
PieceContacts<Real>::PieceContacts(const World& world, std::vector<Surface> surfaces,
                                   const ContactOptions& options, const SleepOptions& sleep)
    : options_(options),
      pieces_(world),
      clusters_(world.clusters),
      surfaces_(std::move(surfaces)),
      pinned_(world.pinned),
      moves_(pieces_.count()),
      placed_(pieces_.count()),
      ways_(pieces_.count()),
      starts_(pieces_.count()),
      looked_(pieces_.count()),
      leant_(pieces_.count()),
      struck_(pieces_.count()),
      moved_(pieces_.count()),
      strayed_(pieces_.count()),
      near_(pieces_.count()),
      touches_(pieces_),
      memory_(pieces_.count(), partners),
      sleep_(pieces_.count(), sleep),
      left_(world.start.size()),
      zones_(world.start.size()),
      gravity_(world.gravity) {
    if (sleep && std::ranges::count(world.sets, true, &World::Set::contact) > 1)
        throw std::invalid_argument(options.name + ": what falls asleep may meet pieces alone");
    double size = 0;
    for (int p = 0; p < pieces_.count(); ++p) {
        const Body& body = pieces_.body(p);
        shapes_.push_back(shapeOf(world, body, surfaces_[p], options.name));
        thickness_.push_back(surfaces_[p].thickness.value_or(0));
        slack_ = std::max(slack_, thickness_[p]);
        bouncy_ = bouncy_ || surfaces_[p].restitution > 0;
        if (body.inverseMass == 0)
            for (int v = body.vertices.first; v < body.vertices.last; ++v) pinned_[v] = 1;
        else
            size = size == 0 ? shapes_[p].radius : std::min(size, shapes_[p].radius);
    }
    slack_ = std::max(2 * slack_, 0.02 * size);
    if (bouncy_) {
        coming_.resize(pieces_.count());
        bounces_.bodies.resize(pieces_.count());
    }
}

template <class Real>
void PieceContacts<Real>::begin(const Substep& substep, Workers&) {
    h_ = substep.h;
    touches_.pairs.clear();
    touches_.points.clear();
    ready_ = false;
    backRounds_ = 0;
    back_.clear();
    for (PieceBounces::Body& body : bounces_.bodies) body.struck = false;
}

template <class Real>
void PieceContacts<Real>::strike(const Sweep<Real>& sweep, const State<Real>& state,
                                 const Drawer<Real>& kept, Workers& workers) {
    memory_.read(kept);
    if (clusters_ >= 0) leaders_ = std::span(state.kept[clusters_].integers).first(pieces_.count());
    if (sleep_) {
        sleep_.read(kept);
        holdSleepers(sweep);
    }
    if (!bouncy_) return;
    workers.forBlocks(pieces_.count(), 16, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) noteComing(sweep, state, p);
    });
}

// All that comes near a piece on its way is within these, with half of what contacts reach beyond.
template <class Real>
NearPieces::Bounds PieceContacts<Real>::boundsOf(int piece) const {
    const Convex& shape = shapes_[piece];
    constexpr double most = 1e30;
    Vec<double> low{most, most, most}, high = -low;
    for (const Pose& pose : {starts_[piece], touches_.poses[piece]})
        for (const Vec<double>& corner : shape.corners) {
            const Vec<double> x = pose.centre + pose.turn * corner;
            low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
            high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
        }
    const double beyond = bulgeOf(piece) + thickness_[piece] + slack_ / 2;
    const Vec<double> reach{beyond, beyond, beyond};
    return {low - reach, high + reach};
}

template <class Real>
double PieceContacts<Real>::gapOf(int first, int second) const {
    return thickness_[first] + thickness_[second];
}

template <class Real>
void PieceContacts<Real>::prepare(const Sweep<Real>& sweep, Workers& workers) {
    workers.forBlocks(pieces_.count(), 16, [&](int first, int last) {
        for (int p = first; p < last; ++p) begin(sweep, p);
    });
    do {
        joinClusters();
        foreseeAll(workers);
    } while (sleep_ && wakeTouched(sweep));
    counts_.contacts = std::max(counts_.contacts, std::ssize(touches_.points));
    touches_.linearise(workers);
    memory_.recall(touches_, starts_, h_);
    touches_.apply(workers);
    leant_ = touches_.poses;
    touches_.colour();
    ready_ = true;
}

template <class Real>
void PieceContacts<Real>::begin(const Sweep<Real>& sweep, int piece) {
    const bool asleep = sleep_.asleep(piece);
    if (!placed_[piece]) {
        starts_[piece] = looked_[piece] = pieces_.startOf(sweep, piece);
        touches_.poses[piece] = pieces_.poseOf(sweep, piece);
        noteLeft(sweep, piece);
        ways_[piece] = PoseWay(starts_[piece], touches_.poses[piece]);
        near_.bounds[piece] = boundsOf(piece);
    }
    placed_[piece] = asleep;
    touches_.begin(piece, starts_[piece], shapes_[piece].radius, asleep);
    if (sleep_) {
        const Range& all = pieces_.body(piece).vertices;
        std::fill(pinned_.begin() + all.first, pinned_.begin() + all.last,
                  touches_.yields(piece) ? 0 : 1);
    }
    moves_[piece] = touches_.yields(piece) || !(starts_[piece] == touches_.poses[piece]);
    moved_[piece] = 1;
}

template <class Real>
void PieceContacts<Real>::foreseeAll(Workers& workers) {
    touches_.pairs.clear();
    touches_.points.clear();
    near_.find(moves_);
    ++counts_.searches;
    counts_.pairs = std::max(counts_.pairs, static_cast<long>(near_.pairs.size()));
    for (NearPieces::Near& near : near_.pairs) near.pair = -1;
    lookAtNear(workers, [&](NearPieces::Near& near, Found& found) { foresee(near, found); });
    take();
}

template <class Real>
void PieceContacts<Real>::noteLeft(const Sweep<Real>& sweep, int piece) {
    const Range& all = pieces_.body(piece).vertices;
    for (int v = all.first; v < all.last; ++v)
        std::copy_n(sweep.particles + 8 * v + 4, 3, &left_[v].x);
}

template <class Real>
void PieceContacts<Real>::putAll(const Sweep<Real>& sweep, Workers& workers) {
    workers.forBlocks(pieces_.count(), 16, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) {
            if (!touches_.yields(p)) continue;
            pieces_.put(sweep, p, touches_.poses[p]);
            noteLeft(sweep, p);
        }
    });
}

template <class Real>
void PieceContacts<Real>::project(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
    if (gaveUp_) return;
    if (ready_)
        findPoses(sweep, workers);
    else
        prepare(sweep, workers);
    touches_.sweep(direction, workers);
    putAll(sweep, workers);
}

template <class Real>
void PieceContacts<Real>::findPoses(const Sweep<Real>& sweep, Workers& workers) {
    if (!ready_) return prepare(sweep, workers);
    workers.forBlocks(pieces_.count(), 16, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) {
            const Range& all = pieces_.body(p).vertices;
            bool there = true;
            for (int v = all.first; v < all.last && there; ++v)
                there = std::equal(&left_[v].x, &left_[v].x + 3, sweep.particles + 8 * v + 4);
            if (there) continue;
            touches_.poses[p] = pieces_.poseOf(sweep, p);
            noteLeft(sweep, p);
        }
    });
}

// What changes its speed by more than what it weighs does has been struck.
template <class Real>
void PieceContacts<Real>::conclude(const Sweep<Real>&, Workers&) {
    counts_.givenUp += gaveUp_;
    const double least =
        std::max(0.01 * slack_, std::max(options_.bounceThreshold, 2 * gravity_ * h_) * h_);
    std::ranges::fill(struck_, 0);
    for (int p = 0; p < pieces_.count() && ready_; ++p) {
        const Pose& pose = touches_.poses[p];
        if (pose == leant_[p]) continue;
        const double way = length(pose.centre - leant_[p].centre) +
                           shapes_[p].radius * PoseWay(leant_[p], pose).angle();
        if (way > least) struck_[touches_.leader(p)] = 1;
    }
    spreadStruck();
    memory_.note(touches_, h_, moves_);
    if (sleep_) joinIslands();
    if (bouncy_ && ready_ && !gaveUp_) bounce();
}

// To all that press each other: where one of two took the first-order velocity alone, what they
// gave each other would not be the same.
template <class Real>
void PieceContacts<Real>::spreadStruck() {
    const auto spread = [&](const TouchedPair& pair) {
        const int first = touches_.leader(pair.first), second = touches_.leader(pair.second);
        if (struck_[first] == struck_[second] || !touches_.yields(first) ||
            !touches_.yields(second) ||
            (!pair.leant && std::ranges::none_of(touches_.of(pair), [](const TouchedPoint& p) {
                return p.push != 0;
            })))
            return false;
        struck_[first] = struck_[second] = 1;
        return true;
    };
    for (bool more = true; more;) {
        more = false;
        for (const TouchedPair& pair : touches_.pairs) more |= spread(pair);
    }
}

// The first-order velocity, and a past that continues it: BDF2 would make half a bounce of what
// comes to a stop.
template <class Real>
void PieceContacts<Real>::rebound(State<Real>& state, Drawer<Real>& kept) const {
    memory_.write(kept);
    if (!state.last.empty()) leaveAll(state);
    if (sleep_ && ready_ && !gaveUp_) rest(state, kept);
}

template <class Real>
void PieceContacts<Real>::leaveAll(State<Real>& state) const {
    for (int p = 0; p < pieces_.count(); ++p) {
        if (bouncy_ && bounces_.bodies[touches_.leader(p)].struck) {
            leave(state, p);
            continue;
        }
        if (!struck_[touches_.leader(p)] || !touches_.yields(p)) continue;
        const Range& all = pieces_.body(p).vertices;
        for (int v = all.first; v < all.last; ++v) {
            const Vec<Real> step = state.particles[v].d - state.last[v].v;
            state.velocity[v].v = static_cast<Real>(1 / h_) * step;
            if (!state.lastVelocity.empty()) state.lastVelocity[v].v = state.velocity[v].v;
        }
    }
}

template <class Real>
void PieceContacts<Real>::markTouched(std::vector<std::uint8_t>& touched) const {
    for (const TouchedPair& pair : touches_.pairs) {
        if (std::ranges::none_of(touches_.of(pair),
                                 [](const TouchedPoint& p) { return p.push != 0; }))
            continue;
        for (const int p : {pair.first, pair.second}) {
            const Range& all = pieces_.body(p).vertices;
            std::fill(touched.begin() + all.first, touched.begin() + all.last, std::uint8_t{1});
        }
    }
}

template class PieceContacts<float>;
template class PieceContacts<double>;

void meetPieces(World& world, std::vector<Surface> surfaces, const ContactOptions& options,
                const SleepOptions& sleep) {
    if (surfaces.size() != world.pieces.size())
        throw std::invalid_argument(options.name + ": there must be one surface a piece");
    for (Surface& s : surfaces) {
        s = checked(world, s, options.name);
        if (!s.ignores.empty() || options.otherFriction != 1)
            throw std::invalid_argument(options.name +
                                        ": pieces ignore no others, and no friction");
    }
    if (!isMeasure(sleep.speed) || !isMeasure(sleep.delay))
        throw std::invalid_argument(options.name + ": speed and delay of sleep are from 0 on");
    const auto recipeFor = [&](const std::vector<Surface>& terms) {
        return recipeOf<Constraint>(
            [terms, options, sleep]<class Real>(const World& made, KernelChoice) {
                return std::make_unique<PieceContacts<Real>>(made, terms, options, sleep);
            });
    };
    Recipe<Constraint> recipe = recipeFor(surfaces);
    for (const LesserSurfaces& form : lesserForms(surfaces))
        if (form.without == "friction" || form.without == "restitution")  // all that pieces know
            recipe.offer("without " + form.without, recipeFor(form.surfaces));
    world.constrain(
        std::move(recipe),
        {.name = options.name, .order = options.order, .importance = options.importance}, true);
}

}  // namespace plait
