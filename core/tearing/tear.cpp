#include "tear.h"

#include "../numbers/convert.h"
#include "../numbers/elementary.h"
#include "../numbers/splitmix.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr int ring = 3;  // edges around the end of a tear that J is asked over

Range spareOf(const World& world, const Tearing& tearing) {
    for (const Tearable& tearable : world.tearable)
        if (tearable.matter.first == tearing.cloth.first) return tearable.spare;
    return {};
}

Vec<double> unitOf(const Vec<double>& v) { return divide(1.0, length(v)) * v; }

}  // namespace

template <class Real>
Tear<Real>::Tear(const World& world, const Tearing& tearing)
    : tearing_(tearing),
      spare_(spareOf(world, tearing)),
      cuts_(world.torn ? *world.torn : world.uncut()),
      rest_(world.rest),
      stress_(cuts_, tearing.rubber, rest_),
      sites_(sitesOf(cuts_, rest_)),
      parts_(rest_.size(), 1) {
    Splitmix random(tearing.seed);
    for (int v = tearing.cloth.first; v < spare_.first; ++v)
        parts_[v] =
            (tearing.map ? tearing.map(rest_[v]) : 1) * (1 + tearing.scatter * random.both());
    double mass = 0, stiffness = 0;
    for (int v = tearing.cloth.first; v < tearing.cloth.last; ++v)
        if (v < spare_.first || cuts_.original(v) != v) mass += world.mass[v];
    for (int t = 0; t < cuts_.whole().count(2); ++t)
        if (stress_.has(t)) stiffness += stress_.volume(t) * stress_.shearModulus(t);
    waveSpeed_ = std::sqrt(stiffness / mass);
    findLips();
}

// An edge that parted no vertex by itself, as the first inside a sheet, is paid for by the next
// that does.
template <class Real>
void Tear<Real>::findLips() {
    double owed = 0;
    const auto splits = cuts_.splits();
    std::size_t next = 0;
    for (const int edge : cuts_.order()) {
        owed += costOf(edge);
        const std::size_t first = next;
        while (next < splits.size() && splits[next].cut == edge) ++next;
        for (std::size_t s = first; s < next; ++s) {
            if (splits[s].copy < spare_.first || splits[s].copy >= spare_.last) continue;
            const auto ends = cuts_.whole().vertices(1, edge);
            const double span = length(rest_[ends[1]] - rest_[ends[0]]);
            lips_.push_back({splits[s].vertex, splits[s].copy,
                             owed / static_cast<double>(next - first), 0.25 * span / waveSpeed_});
        }
        if (next > first) owed = 0;
    }
}

template <class Real>
double Tear<Real>::costOf(int edge) const {
    const auto ends = cuts_.whole().vertices(1, edge);
    double thickness = 0;
    for (const int t : cuts_.around(ends[0])) {
        const auto corners = cuts_.whole().vertices(2, t);
        if (stress_.has(t) && std::ranges::find(corners, ends[1]) != corners.end())
            thickness = std::max(thickness, stress_.thickness(t));
    }
    return tearing_.toughness * 0.5 * (parts_[ends[0]] + parts_[ends[1]]) * thickness *
           length(rest_[ends[1]] - rest_[ends[0]]);
}

template <class Real>
void Tear<Real>::furnish(Drawer<Real>& kept) const {
    kept.numbers.assign(2 * static_cast<std::size_t>(spare_.size()), Real(0));
    kept.integers.assign(1, 0);
}

template <class Real>
void Tear<Real>::prepare(State<Real>&, Drawer<Real>& kept, double, double h, Workers&) {
    kept_ = &kept;
    h_ = h;
}

template <class Real>
void Tear<Real>::apply(State<Real>& state, double, double h, Workers&) {
    for (const Lips& lips : lips_) {
        Real& taken = kept_->numbers[lips.copy - spare_.first];
        const double left = lips.cost - double(taken);
        if (!(left > 0)) continue;
        Vec<Real>&v = state.velocity[lips.vertex].v, &u = state.velocity[lips.copy].v;
        const double wv = state.particles[lips.vertex].w, wu = state.particles[lips.copy].w;
        if (wv + wu == 0) continue;
        const Vec<double> apart = as<double>(u - v);
        // Of the energy of how fast they part, as much as is left to pay.
        const double energy = 0.5 * dot(apart, apart) / (wv + wu),
                     lost = 1 - exponential(-2 * h / lips.time),
                     part = energy * lost > left ? divide(left, energy) : lost,
                     slower = 1 - squareRoot(1 - part);
        u -= as<Real>((slower * wu / (wv + wu)) * apart);
        v += as<Real>((slower * wv / (wv + wu)) * apart);
        taken += static_cast<Real>(part * energy * h_ / h);
    }
}

template <class Real>
std::array<Vec<double>, 3> Tear<Real>::placesOf(const State<Real>& state, int triangle) const {
    const auto corners = cuts_.corners(triangle);
    return {state.position(corners[0]), state.position(corners[1]), state.position(corners[2])};
}

// Of the mean of P = sum of p u v^T the greatest singular value and the v of it: the legs of a
// trouser pull along a tear, but one up and one down.
template <class Real>
typename Tear<Real>::Bearing Tear<Real>::bearing(const State<Real>& state, int vertex,
                                                 std::span<const int> triangles) const {
    const Site& site = sites_[vertex];
    const Vec<double> along = site.spokes.empty() ? Vec<double>{} : site.spokes[0].direction,
                      e = unitOf(along - dot(along, site.normal) * site.normal),
                      f = cross(site.normal, e);
    Vec<double> pe{0, 0, 0}, pf{0, 0, 0};
    double volume = 0;
    for (const int t : triangles) {
        if (!stress_.has(t)) continue;
        const auto borne = stress_.borne(t, placesOf(state, t));
        volume += stress_.volume(t);
        for (int i = 0; i < 2; ++i) {
            const Vec<double> p = (stress_.volume(t) * borne.force[i]) * borne.pull[i];
            pe += dot(borne.direction[i], e) * p;
            pf += dot(borne.direction[i], f) * p;
        }
    }
    const double ee = dot(pe, pe), ef = dot(pe, pf), ff = dot(pf, pf), half = 0.5 * (ee - ff),
                 r = squareRoot(half * half + ef * ef);
    const double x = half > 0 ? r + half : ef, y = half > 0 ? ef : r - half;
    return {divide(squareRoot(0.5 * (ee + ff) + r), volume), unitOf(x * e + y * f)};
}

template <class Real>
typename Tear<Real>::Disc Tear<Real>::discAt(int vertex) const {
    Disc disc{{vertex}, {0}, {}};
    for (std::size_t i = 0; i < disc.vertices.size(); ++i) {
        if (disc.steps[i] == ring) continue;
        const Site& site = sites_[disc.vertices[i]];
        disc.triangles.insert(disc.triangles.end(), site.triangles.begin(), site.triangles.end());
        for (const Spoke& spoke : site.spokes) {
            if (std::ranges::find(disc.vertices, spoke.end) != disc.vertices.end()) continue;
            disc.vertices.push_back(spoke.end);
            disc.steps.push_back(disc.steps[i] + 1);
        }
    }
    std::ranges::sort(disc.triangles);
    disc.triangles.erase(std::unique(disc.triangles.begin(), disc.triangles.end()),
                         disc.triangles.end());
    return disc;
}

// Of the disc at the end of a tear: what the tear goes through. Its lips bear nothing across it,
// and of a trouser's legs one may be there more than the other.
template <class Real>
std::vector<int> Tear<Real>::trianglesAhead(int vertex) const {
    std::vector<int> triangles = discAt(vertex).triangles;
    const Vec<double> ahead = sites_[vertex].ahead();
    std::erase_if(triangles, [&](int t) {
        Vec<double> off{0, 0, 0};
        for (const int v : cuts_.corners(t)) off += rest_[v] - rest_[vertex];
        return dot(off, ahead) < 0;
    });
    return triangles;
}

// Eshelby's force on a place in the matter: with q 1 near it and 0 from `ring` edges on, minus the
// sum over triangles of volume times (W - F^T P) grad q.
template <class Real>
Vec<double> Tear<Real>::drive(const State<Real>& state, int vertex) const {
    const Disc disc = discAt(vertex);
    Vec<double> sum{0, 0, 0};
    for (const int t : disc.triangles) {
        if (!stress_.has(t)) continue;
        std::array<double, 3> q;
        for (int c = 0; c < 3; ++c) {
            const auto at = std::ranges::find(disc.vertices, cuts_.corners(t)[c]);
            q[c] = at != disc.vertices.end() && disc.steps[at - disc.vertices.begin()] < ring;
        }
        if (q[0] == q[1] && q[1] == q[2]) continue;
        const auto borne = stress_.borne(t, placesOf(state, t));
        const Vec<double> slope = stress_.gradient(t, q);
        for (int i = 0; i < 2; ++i)
            sum -= stress_.volume(t) * (borne.energy - borne.stretch[i] * borne.force[i]) *
                   dot(borne.direction[i], slope) * borne.direction[i];
    }
    return sum;
}

// How long ago (s) the tear that ends here got here, and how long its last edge is (m).
template <class Real>
bool Tear<Real>::mayGoOn(const Drawer<Real>& kept, const Site& site, double t) const {
    for (const Spoke& spoke : site.spokes) {
        if (spoke.triangles > 1 || spoke.end < spare_.first || spoke.end >= spare_.last) continue;
        const double since = t - double(kept.numbers[spare_.size() + spoke.end - spare_.first]);
        if (since * waveSpeed_ < spoke.length) return false;
    }
    return true;
}

template <class Real>
void Tear<Real>::findFailing(const State<Real>& state, const Drawer<Real>& kept, double t,
                             std::vector<Failing>& failing) const {
    // What lies about the end of a tear is left to that; lips do not tear again, since what snaps
    // back along them would shatter what is under stress (Marder, "Supersonic rupture of rubber",
    // 2006, has to toughen them as well).
    std::vector<unsigned char> led(sites_.size());
    for (int v = tearing_.cloth.first; v < tearing_.cloth.last; ++v)
        if (sites_[v].endsTear())
            for (const int near : discAt(v).vertices) led[near] = 1;
    for (int v = tearing_.cloth.first; v < tearing_.cloth.last; ++v) {
        const Site& site = sites_[v];
        const int whole = cuts_.original(v);
        if (site.triangles.empty() || cuts_.isHeld(whole)) continue;
        const Vec<double> ahead = site.endsTear() ? site.ahead() : Vec<double>{};
        if (tearing_.toughness > 0 && site.endsTear()) {
            if (!mayGoOn(kept, site, t)) continue;
            double thickness = 0;
            for (const int n : site.triangles)
                if (stress_.has(n)) thickness = std::max(thickness, stress_.thickness(n));
            const Vec<double> drive = this->drive(state, v);
            const double times = length(drive) / (tearing_.toughness * parts_[whole] * thickness);
            if (times > 1)
                failing.push_back({times, v, bearing(state, v, trianglesAhead(v)).normal, drive});
        } else if (tearing_.strength < infinity &&
                   (site.endsTear() || !(led[v] || cuts_.isApart(whole)))) {
            const Bearing most = bearing(state, v);
            const double times = most.force / (tearing_.strength * parts_[whole]);
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

// The edge that lies most nearly in the section that bears most, at the end of a tear within 60
// degrees of its way; inside a sheet also the one that goes on opposite to it.
template <class Real>
std::vector<int> Tear<Real>::edgesFor(const Failing& failing) const {
    const Site& site = sites_[failing.vertex];
    const auto best = [&](const Vec<double>& way, double least) {
        const Spoke* found = nullptr;
        const auto off = [&](const Spoke& s) {
            return std::fabs(dot(s.direction, failing.normal));
        };
        for (const Spoke& spoke : site.spokes)
            if (spoke.triangles > 1 && dot(spoke.direction, way) >= least &&
                (!found || off(spoke) < off(*found)))
                found = &spoke;
        return found;
    };
    const Spoke* const first = best(unitOf(failing.way), length(failing.way) > 0 ? 0.5 : 0);
    if (!first) return {};
    const Spoke* const second = site.inside() ? best(-first->direction, 0.3) : nullptr;
    return second ? std::vector{first->edge, second->edge} : std::vector{first->edge};
}

// The edges most nearly half a right angle to either side of ahead.
template <class Real>
std::vector<int> Tear<Real>::branchesFor(const Failing& failing) const {
    const Site& site = sites_[failing.vertex];
    std::vector<int> edges;
    for (const double side : {-1.0, 1.0}) {
        const Vec<double> ahead = unitOf(failing.way), across = side * cross(site.normal, ahead),
                          way = squareRoot(0.5) * (ahead + across);
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

// The worst first; what is within two edges of it has to wait for what that changes.
template <class Real>
void Tear<Real>::settle(State<Real>& state, Drawer<Real>& kept, double t, double h) {
    const bool asked = tearing_.asked == Tears::perSubstep ||
                       (tearing_.asked == Tears::perFrame && t - h < from_ + 0.5 * h);
    if (!asked) return;
    std::vector<Failing> failing;
    findFailing(state, kept, t, failing);
    if (tearing_.needle) {
        const int v = pierced(state, tearing_.needle(t - h), tearing_.needle(t));
        if (v >= 0 && !cuts_.isHeld(cuts_.original(v)))
            failing.insert(failing.begin(), {infinity, v, bearing(state, v).normal, {}});
    }
    if (failing.empty()) return;
    Cuts cuts = cuts_;
    std::vector<int> torn;
    for (const Failing& f : failing) {
        if (near(f.vertex, torn)) continue;
        const std::size_t before = cuts.splits().size();
        const bool splits = sites_[f.vertex].endsTear() && f.times > tearing_.branching;
        for (const int edge : splits ? branchesFor(f) : edgesFor(f)) {
            if (cuts.cut(edge))
                state.cuts.push_back(edge);
            else
                ++kept.integers[0];
        }
        if (state.cuts.size() > cuts_.order().size()) torn.push_back(f.vertex);
        for (const Split& split : cuts.splits().subspan(before))
            kept.numbers[spare_.size() + split.copy - spare_.first] = static_cast<Real>(t);
    }
}

template class Tear<float>;
template class Tear<double>;

}  // namespace plait
