// What a sheet bears at a vertex, and what drives the end of a tear.
#include "tear.h"

#include <algorithm>

namespace plait {
namespace {

constexpr int ring = 3;           // edges around the end of a tear that J is asked over
constexpr double straight = 2.2;  // angle at a border below which it has a corner

Vec<double> unitOf(const Vec<double>& v) { return divide(1.0, length(v)) * v; }

}  // namespace

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
        const auto borne = borneAt(state, t);
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

// How many edges around the end of a tear J may be asked over: no border may come nearer, nor
// another end, but the tear's own lips, as far as they run on without a corner.
template <class Real>
int Tear<Real>::ringAt(const Disc& disc) const {
    std::vector<int> lips{disc.vertices[0]};
    for (std::size_t i = 0; i < lips.size(); ++i)
        for (const Spoke& spoke : sites_[lips[i]].spokes) {
            const Site& next = sites_[spoke.end];
            if (spoke.triangles > 1 || next.angle < straight || next.endsTear()) continue;
            if (std::ranges::find(lips, spoke.end) == lips.end() && i < 2 * ring)
                lips.push_back(spoke.end);
        }
    int least = ring;
    for (std::size_t i = 1; i < disc.vertices.size(); ++i)
        if (!sites_[disc.vertices[i]].inside() &&
            std::ranges::find(lips, disc.vertices[i]) == lips.end())
            least = std::min(least, disc.steps[i]);
    return least;
}

// Eshelby's force on a place in the matter: with q 1 near it and 0 some edges away, minus the
// sum over triangles of volume times (W - F^T P) grad q.
template <class Real>
Vec<double> Tear<Real>::drive(const State<Real>& state, int vertex) const {
    const Disc disc = discAt(vertex);
    const int around = ringAt(disc);
    Vec<double> sum{0, 0, 0};
    for (const int t : disc.triangles) {
        if (!stress_.has(t)) continue;
        std::array<double, 3> q;
        for (int c = 0; c < 3; ++c) {
            const auto at = std::ranges::find(disc.vertices, cuts_.corners(t)[c]);
            q[c] = at != disc.vertices.end() && disc.steps[at - disc.vertices.begin()] < around;
        }
        if (q[0] == q[1] && q[1] == q[2]) continue;
        const auto borne = borneAt(state, t);
        const Vec<double> slope = stress_.gradient(t, q);
        for (int i = 0; i < 2; ++i)
            sum -= stress_.volume(t) * (borne.energy - borne.stretch[i] * borne.force[i]) *
                   dot(borne.direction[i], slope) * borne.direction[i];
    }
    return sum;
}

template class Tear<float>;
template class Tear<double>;

}  // namespace plait
