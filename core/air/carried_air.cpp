#include "carried_air.h"

#include "momentum_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

constexpr int carriedGrain = 256;
// The midpoint rule holds where a step takes the air past no more of a triangle.
constexpr double longestStep = 0.7;
constexpr int mostSteps = 10;  // in a substep

template <class Real>
Vec<double> wide(const Padded<Real>& p) {
    return {double(p.v.x), double(p.v.y), double(p.v.z)};
}

}  // namespace

template <class Real>
CarriedAir<Real>::CarriedAir(std::span<const RestFacet> triangles, int vertices,
                             const CarriedAirOptions& options)
    : options_(options),
      vertices_(vertices),
      filter_(std::make_unique<MomentumFilter>(triangles, vertices, options.mass, options.reach)) {
    const auto wholeBlocks = [](std::size_t count) {
        return (count + blockSize - 1) / blockSize * blockSize;
    };
    const std::size_t places = static_cast<std::size_t>(filter_->size()), all = wholeBlocks(places),
                      facets = wholeBlocks(triangles.size());
    vertexAt_.resize(places);
    for (int v = 0; v < vertices; ++v)
        if (filter_->place(v) >= 0) vertexAt_[filter_->place(v)] = v;
    right_.resize(places), phi_.resize(places);
    rates_.resize(facets), ways_.resize(facets);
    slopes_.resize(facets + 1);  // the last stays 0: around what lies at fewer facets
    ways_.resize(facets + 1);
    areas_.assign(all, Real(0)), open_ = flatRight_ = flatPhi_ = areas_;
    normals_.resize(all), impulses_.resize(all);
    middle_.resize(static_cast<std::size_t>(vertices) + 1);
    for (const RestFacet& facet : triangles)
        for (const int v : facet.vertices)
            areas_[filter_->place(v)] += static_cast<Real>(facet.area / 3);
    for (std::size_t n = 0; n < places; ++n) open_[n] = 1 / areas_[n];
    findBorder(triangles);
}

template <class Real>
void CarriedAir<Real>::findBorder(std::span<const RestFacet> triangles) {
    std::map<std::array<int, 2>, int> edges;
    for (const RestFacet& facet : triangles)
        for (std::size_t c = 0; c < 3; ++c)
            ++edges[{facet.vertices[c], facet.vertices[(c + 1) % 3]}];
    std::map<int, BorderVertex> border;
    const auto at = [&](int v) -> BorderVertex& {
        return border.try_emplace(v, BorderVertex{filter_->place(v), v, v, v}).first->second;
    };
    for (const auto& [edge, count] : edges) {
        const auto [a, b] = edge;
        if (count > 1)
            throw std::invalid_argument("air: two triangles go round the edge " +
                                        std::to_string(a) + ", " + std::to_string(b) +
                                        " the same way: carried air needs sides that match");
        if (edges.contains({b, a})) continue;
        at(a).after = b;
        at(b).before = a;
    }
    for (const auto& [v, vertex] : border) border_.push_back(vertex);
}

template <class Real>
CarriedBlocks<Real> CarriedAir<Real>::blocks(State<Real>& state, Real* momentum, double seconds) {
    const bool looksBack = !state.lastVelocity.empty();
    Real* const now = &state.velocity[0].v.x;
    Real* const began = looksBack ? &state.lastVelocity[0].v.x : now;
    return {.ways = &ways_[0].v.x,
            .rates = rates_.data(),
            .fastest = static_cast<Real>(mostSteps * longestStep / seconds),
            .slopes = slopes_.data(),
            .normals = &normals_[0].v.x,
            .right = flatRight_.data(),
            .phi = flatPhi_.data(),
            .areas = areas_.data(),
            .open = open_.data(),
            .momentum = momentum,
            .velocity = began,
            .other = looksBack ? now : nullptr,
            .impulses = &impulses_[0].v.x,
            .mass = static_cast<Real>(options_.mass)};
}

// With m the outward normal of the border, as long as it: open is 1 where the air goes out of it,
// and along it, and 0 where it comes straight in. Gusts are left out.
template <class Real>
void CarriedAir<Real>::closeInflow(const State<Real>& state, const AirStep<Real>& step) {
    const Vec<double> wind{double(step.wind[0]), double(step.wind[1]), double(step.wind[2])};
    const std::vector<Padded<Real>>& velocities =
        state.lastVelocity.empty() ? state.velocity : state.lastVelocity;
    for (const BorderVertex& at : border_) {
        const Vec<double> normal = wide(normals_[at.place]),
                          along = state.position(at.after) - state.position(at.before),
                          outward = cross(along, normal), air = wind - wide(velocities[at.vertex]),
                          past = air - dot(air, normal) * normal;
        const double in = divide(-dot(past, outward), length(past) * length(outward));
        open_[at.place] = static_cast<Real>(1 - std::clamp(in, 0.0, 1.0)) / areas_[at.place];
    }
}

template <class Real>
int CarriedAir<Real>::turns(double seconds) const {
    Real most = 0;
    for (const Real rate : rates_) most = std::max(most, rate);
    return std::min(1 + static_cast<int>(double(most) * seconds / longestStep), mostSteps);
}

template <class Real>
void CarriedAir<Real>::weigh(const State<Real>& state) {
    bool same = !w_.empty();
    w_.resize(vertexAt_.size());
    for (std::size_t n = 0; n < w_.size(); ++n) {
        const double w = double(state.particles[vertexAt_[n]].w);
        same = same && w == w_[n];
        w_[n] = w;
    }
    if (!same) filter_->factor(w_);
}

template <class Real>
void CarriedAir<Real>::solve() {
    for (std::size_t n = 0; n < right_.size(); ++n) right_[n] = double(flatRight_[n]);
    filter_->solve(right_, phi_);
    for (std::size_t n = 0; n < phi_.size(); ++n) flatPhi_[n] = static_cast<Real>(phi_[n]);
}

template <class Real>
void CarriedAir<Real>::exchange(State<Real>& state, Real* momentum, const AirStep<Real>& step,
                                AirSkin<Real>& skin, const AirTable<Real>& kernels, double seconds,
                                Workers& workers) {
    const CarriedBlocks<Real> carried = blocks(state, momentum, seconds);
    const FacetBlocks<Real> facets = skin.blocks();
    const AroundBlocks<Real> around = skin.around();
    const auto overFacets = [&](const auto& body) {
        workers.forBlocks(skin.size(), carriedGrain, body);
    };
    const auto overVertices = [&](const auto& body) {
        workers.forBlocks(skin.vertices(), carriedGrain, body);
    };
    const auto meet = [&](MeetKernel<Real> kernel) {
        overVertices(
            [&](int begin, int end) { kernel(step, facets, around, carried, begin, end); });
    };
    overFacets([&](int begin, int end) { kernels.ways(step, facets, carried, begin, end); });
    meet(kernels.normals);
    weigh(state);
    if (state.substep == 0) return begin(momentum, [&] { meet(kernels.right); });
    closeInflow(state, step);
    const auto carry = [&](const Real* slopesOf, Real* to, double time) {
        overFacets(
            [&](int begin, int end) { kernels.slopes(facets, carried, slopesOf, begin, end); });
        overVertices([&](int begin, int end) {
            kernels.carried(around, carried, static_cast<Real>(time), momentum, to, begin, end);
        });
    };
    const int steps = turns(seconds);
    Real* const middle = middle_.data();
    Real most = 0;
    for (const int v : vertexAt_) most = std::max(most, std::abs(momentum[v]));
    for (int i = 0; i < steps; ++i) {
        carry(momentum, middle, seconds / (2 * steps));
        carry(middle, momentum, seconds / steps);
    }
    // What is carried is nowhere more than it was: the scheme alone does not know that.
    for (const int v : vertexAt_) momentum[v] = std::clamp(momentum[v], -most, most);
    meet(kernels.right);
    solve();
    meet(kernels.exchanged);
}

// As a run begins air and sheet have met, and nothing has been carried.
template <class Real>
template <class Write>
void CarriedAir<Real>::begin(Real* momentum, const Write& writeRight) {
    std::fill_n(momentum, numbers(), Real(0));
    writeRight();
    filter_->factor(std::vector<double>(w_.size()));
    solve();
    filter_->factor(w_);
    for (std::size_t n = 0; n < vertexAt_.size(); ++n)
        momentum[vertexAt_[n]] = static_cast<Real>(options_.mass) * flatPhi_[n];
}

template <class Real>
CarriedAir<Real>::~CarriedAir() = default;

template <class Real>
Vec<double> CarriedAir<Real>::impulse() const {
    Vec<double> sum{0, 0, 0};
    for (const Padded<Real>& p : impulses_) sum += wide(p);
    return sum;
}

template class CarriedAir<float>;
template class CarriedAir<double>;

}  // namespace plait
