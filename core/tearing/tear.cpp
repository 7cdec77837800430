#include "tear.h"

#include "../numbers/elementary.h"
#include "../numbers/splitmix.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

// Times what it costs, from which on a tear need not wait until the lips behind it have parted: on
// an irregular mesh an edge may cost more than it sets free, which the next ones pay for.
constexpr double insists = 1.12;
constexpr double leastAhead = 0.7;  // cosine of how far a tear may turn at a vertex

Range spareOf(const World& world, const Tearing& tearing) {
    for (const Tearable& tearable : world.tearable)
        if (tearable.matter.first == tearing.cloth.first) return tearable.spare;
    return {};
}

}  // namespace

template <class Real>
Tear<Real>::Tear(const World& world, const TornMembrane& membrane)
    : tearing_(membrane.tearing),
      spare_(spareOf(world, tearing_)),
      cuts_(world.torn ? *world.torn : world.uncut()),
      rest_(world.rest),
      stress_(cuts_, membrane.rubber, rest_),
      sites_(sitesOf(cuts_, rest_)),
      parts_(rest_.size(), 1),
      scatter_(rest_.size(), 1) {
    Splitmix random(tearing_.seed);
    for (int v = tearing_.cloth.first; v < spare_.first; ++v) {
        if (tearing_.map) parts_[v] = tearing_.map(rest_[v]);
        scatter_[v] = 1 + tearing_.scatter * random.both();
    }
    double mass = 0, stiffness = 0;
    for (int v = tearing_.cloth.first; v < tearing_.cloth.last; ++v)
        if (v < spare_.first || cuts_.original(v) != v) mass += world.mass[v];
    for (int t = 0; t < cuts_.whole().count(2); ++t)
        if (stress_.has(t)) stiffness += stress_.volume(t) * stress_.shearModulus(t);
    waveSpeed_ = std::sqrt(stiffness / mass);
}

template <class Real>
void Tear<Real>::furnish(Drawer<Real>& kept) const {
    kept.numbers.assign(2 * static_cast<std::size_t>(spare_.size()), Real(0));
    kept.integers.assign(1, 0);
}

template <class Real>
bool Tear<Real>::mayGoOn(const State<Real>& state, const Drawer<Real>& kept, const Site& site,
                         double times, double t) const {
    for (const Spoke& spoke : site.spokes) {
        if (spoke.triangles > 1 || spoke.end < spare_.first || spoke.end >= spare_.last) continue;
        const Real* const parting = &kept.numbers[2L * (spoke.end - spare_.first)];
        if ((t - double(parting[0])) * waveSpeed_ < spoke.length) return false;
        const auto split = std::ranges::find(cuts_.splits(), spoke.end, &VertexSplit::copy);
        const double opened = length(state.position(spoke.end) - state.position(split->vertex));
        if (times < insists && opened < double(parting[1])) return false;
    }
    return true;
}

// Notes when what a cut has split did so, and how far it has to open until it bears half of what it
// did: what it costs over the force.
template <class Real>
void Tear<Real>::note(const State<Real>& state, const Cuts& cuts, const VertexSplit& split,
                      double t, Drawer<Real>& kept) const {
    const int whole = cuts.original(split.copy);
    const auto ends = cuts.whole().vertices(1, split.cut);
    const double span = length(rest_[ends[1]] - rest_[ends[0]]);
    Vec<double> force{0, 0, 0};
    double thickness = 0;
    for (const int n : cuts.around(whole)) {
        if (!stress_.has(n)) continue;
        thickness = std::max(thickness, stress_.thickness(n));
        if (cuts.nameIn(n, whole) != split.copy) continue;
        const auto corners = cuts.whole().vertices(2, n);
        force += stress_.forces(
            n, placesOf(state, n))[std::ranges::find(corners, whole) - corners.begin()];
    }
    const double cost = tearing_.toughness * parts_[whole] * thickness * span, far = 2 * span;
    Real* const parting = &kept.numbers[2L * (split.copy - spare_.first)];
    parting[0] = static_cast<Real>(t);
    parting[1] = static_cast<Real>(cost < far * length(force) ? cost / length(force) : far);
}

template <class Real>
void Tear<Real>::findFailing(const State<Real>& state, const Drawer<Real>& kept, double t,
                             std::vector<Failing>& failing) const {
    // What lies about the end of a tear is left to that; lips do not tear again, since what snaps
    // back along them would shatter what is under stress (Marder, "Supersonic rupture of rubber",
    // 2006, has to toughen them as well).
    std::vector<unsigned char> led(sites_.size());
    const bool breaks = tearing_.strength < infinity;
    for (int v = tearing_.cloth.first; v < tearing_.cloth.last && breaks; ++v)
        if (sites_[v].endsTear())
            for (const int other : discAt(v).vertices) led[other] = 1;
    for (int v = tearing_.cloth.first; v < tearing_.cloth.last; ++v) {
        const Site& site = sites_[v];
        const int whole = cuts_.original(v);
        if (site.triangles.empty() || cuts_.isHeld(whole)) continue;
        const Vec<double> ahead = site.endsTear() ? site.ahead() : Vec<double>{};
        if (tearing_.toughness > 0 && site.endsTear()) {
            double thickness = 0;
            for (const int n : site.triangles)
                if (stress_.has(n)) thickness = std::max(thickness, stress_.thickness(n));
            Failing next{0, v, bearing(state, v, trianglesAhead(v)).normal, ahead};
            const Spoke* const edge = edgeFor(next, ahead, leastAhead);
            if (!edge) continue;
            next.times = dot(drive(state, v), edge->direction) /
                         (tearing_.toughness * parts_[whole] * thickness);
            if (next.times > 1 && mayGoOn(state, kept, site, next.times, t))
                failing.push_back(next);
        } else if (breaks && (site.endsTear() || !(led[v] || cuts_.isApart(whole)))) {
            const Bearing most = bearing(state, v);
            const double times = most.force / (tearing_.strength * parts_[whole] * scatter_[whole]);
            if (times > 1) failing.push_back({times, v, most.normal, ahead});
        }
    }
    std::ranges::sort(failing, [](const Failing& a, const Failing& b) {
        return a.times > b.times || (a.times == b.times && a.vertex < b.vertex);
    });
}

// The vertex nearest to where a segment goes through the sheet; -1: it does not.
template <class Real>
int Tear<Real>::pierced(const State<Real>& state, const Vec<double>& from,
                        const Vec<double>& to) const {
    const Vec<double> way = to - from;
    for (int t = 0; t < cuts_.whole().count(2); ++t) {
        if (!stress_.has(t)) continue;
        const auto x = placesOf(state, t);
        const Vec<double> n = cross(x[1] - x[0], x[2] - x[0]);
        const double slope = dot(way, n), at = dot(x[0] - from, n) / slope;
        if (!(at >= 0 && at < 1)) continue;
        const Vec<double> place = from + at * way;
        const auto side = [&](int a, int b) {
            return dot(cross(x[b] - x[a], place - x[a]), n) >= 0;
        };
        if (!side(0, 1) || !side(1, 2) || !side(2, 0)) continue;
        int best = 0;
        for (int c = 1; c < 3; ++c)
            if (length(x[c] - place) < length(x[best] - place)) best = c;
        return cuts_.corners(t)[best];
    }
    return -1;
}

// The edge most nearly in the section that bears most, of those that run so far along `way`.
template <class Real>
const Spoke* Tear<Real>::edgeFor(const Failing& failing, const Vec<double>& way,
                                 double least) const {
    const Spoke* best = nullptr;
    const auto off = [&](const Spoke& s) { return std::fabs(dot(s.direction, failing.normal)); };
    for (const Spoke& spoke : sites_[failing.vertex].spokes)
        if (spoke.triangles > 1 && dot(spoke.direction, way) >= least &&
            (!best || off(spoke) < off(*best)))
            best = &spoke;
    return best || least <= 0 ? best : edgeFor(failing, way, least - 0.35);
}

// Inside a sheet also the one that goes on opposite.
template <class Real>
std::vector<int> Tear<Real>::edgesFor(const Failing& failing) const {
    const Site& site = sites_[failing.vertex];
    const Spoke* const first =
        edgeFor(failing, failing.way, length(failing.way) > 0 ? leastAhead : 0);
    if (!first) return {};
    const Spoke* const second = site.inside() ? edgeFor(failing, -first->direction, 0.3) : nullptr;
    return second ? std::vector{first->edge, second->edge} : std::vector{first->edge};
}

// The edges most nearly half a right angle to either side of ahead.
template <class Real>
std::vector<int> Tear<Real>::branchesFor(const Failing& failing) const {
    const Site& site = sites_[failing.vertex];
    std::vector<int> edges;
    for (const double side : {-1.0, 1.0}) {
        const Vec<double> across = side * cross(site.normal, failing.way),
                          way = squareRoot(0.5) * (failing.way + across);
        const Spoke* best = nullptr;
        for (const Spoke& spoke : site.spokes)
            if (spoke.triangles > 1 && dot(spoke.direction, across) > 0.25 &&
                dot(spoke.direction, way) > (best ? dot(best->direction, way) : 0.7))
                best = &spoke;
        if (best) edges.push_back(best->edge);
    }
    return edges.size() == 2 ? edges : edgesFor(failing);
}

template <class Real>
bool Tear<Real>::near(int vertex, const std::vector<int>& others) const {
    return std::ranges::any_of(others, [&](int other) {
        return other == vertex || std::ranges::any_of(sites_[vertex].spokes, [&](const Spoke& s) {
                   return s.end == other ||
                          std::ranges::any_of(sites_[s.end].spokes,
                                              [&](const Spoke& r) { return r.end == other; });
               });
    });
}

// From a quarter of an edge on, twice the thickness at most that a surface has by itself, contacts
// may keep it from coming back through what it parted from.
template <class Real>
void Tear<Real>::noteParted(State<Real>& state) const {
    for (const VertexSplit& split : cuts_.splits()) {
        if (cuts_.isParted(split.copy) || split.copy < spare_.first || split.copy >= spare_.last)
            continue;
        const auto ends = cuts_.whole().vertices(1, split.cut);
        const double span = length(rest_[ends[1]] - rest_[ends[0]]),
                     apart = length(state.position(split.copy) - state.position(split.vertex));
        if (apart > 0.25 * span) state.cuts.push_back(-1 - split.copy);
    }
}

// The worst first; what is within two edges of it has to wait for what that changes.
template <class Real>
void Tear<Real>::settle(State<Real>& state, Drawer<Real>& kept, double t, double h) {
    const bool asked = tearing_.asked == Tears::perSubstep ||
                       (tearing_.asked == Tears::perFrame && t - h < from_ + 0.5 * h);
    if (!asked) return;
    std::vector<Failing> failing;
    if (tearing_.strength < infinity)
        for (int n = 0; n < cuts_.whole().count(2); ++n)
            borne_.push_back(stress_.has(n) ? stress_.borne(n, placesOf(state, n))
                                            : SheetStress::Borne{});
    findFailing(state, kept, t, failing);
    borne_.clear();
    if (tearing_.needle) {
        const int v = pierced(state, tearing_.needle(t - h), tearing_.needle(t));
        if (v >= 0 && !cuts_.isHeld(cuts_.original(v)))
            failing.insert(failing.begin(), {infinity, v, bearing(state, v).normal, {}});
    }
    noteParted(state);
    if (failing.empty()) return;
    Cuts cuts = cuts_;
    std::vector<int> torn;
    for (const Failing& f : failing) {
        if (near(f.vertex, torn)) continue;
        const std::size_t before = cuts.splits().size(), edges = cuts.order().size();
        const bool splits = sites_[f.vertex].endsTear() && f.times > tearing_.branching;
        for (const int edge : splits ? branchesFor(f) : edgesFor(f)) {
            if (cuts.cut(edge))
                state.cuts.push_back(edge);
            else
                ++kept.integers[0];
        }
        if (cuts.order().size() > edges) torn.push_back(f.vertex);
        for (const VertexSplit& split : cuts.splits().subspan(before))
            note(state, cuts, split, t, kept);
    }
}

template class Tear<float>;
template class Tear<double>;

}  // namespace plait
