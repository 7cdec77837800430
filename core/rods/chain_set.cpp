#include "chain_set.h"

#include "../sets/tree_solve.h"  // redundant

#include <algorithm>
#include <cmath>
#include <utility>

namespace plait {
namespace {

// The d of both ends together.
template <class Real>
Vec<double> movedBy(const Sweep<Real>& sweep, const std::array<int, 2>& edge) {
    return three(sweep.particles + 8 * edge[0] + 4) + three(sweep.particles + 8 * edge[1] + 4);
}

}  // namespace

template <class Real>
ChainSet<Real>::ChainSet(Parts parts, std::span<const std::vector<int>> curves,
                         std::span<const unsigned char> pinned, std::vector<ChainRider> riders)
    : parts_(std::move(parts)), riders_(std::move(riders)), middles_(riders_.size()) {
    std::vector<ChainStencils> stencils;
    for (const auto& part : parts_) {
        stencils.push_back({part->ids(), part->arity(), part->values(), part->areLinks()});
        size_ += static_cast<long>(part->rows()) * part->values();
    }
    for (ChainCurve& plan : planChains(stencils, curves, pinned)) {
        const std::size_t rows = plan.places.size(), vertices = plan.vertices.size();
        Banded system(static_cast<int>(rows), plan.halfWidth, plan.border),
            turning(static_cast<int>(vertices), plan.linkWidth, plan.linkBorder);
        const std::vector<double> zeros(rows, 0);
        std::vector<Coupling> couplings;
        for (const ChainCoupling& c : std::exchange(plan.couplings, {}))
            couplings.push_back({c, system.place(c.i, c.j)});
        curves_.push_back({std::move(plan), std::move(system), std::vector<ChainRow>(rows),
                           std::move(couplings), zeros, zeros, zeros, std::move(turning),
                           std::vector<Response<double, true>>(vertices),
                           std::vector<Vec<double>>(vertices), std::vector<Vec<double>>(vertices)});
    }
}

template <class Real>
void ChainSet<Real>::beginFrame(double t0, double t1) {
    for (const auto& part : parts_) part->beginFrame(t0, t1);
}

template <class Real>
void ChainSet<Real>::begin(const Substep& substep, Workers&) {
    for (const auto& part : parts_) part->begin(substep);
    for (Curve& curve : curves_) std::ranges::fill(curve.lambda, 0.0);
}

template <class Real>
template <class Body>
void ChainSet<Real>::forCurves(Workers& workers, const Body& body) {
    workers.forBlocks(static_cast<int>(curves_.size()), 1, [&](int begin, int end) {
        for (int c = begin; c < end; ++c) body(curves_[c]);
    });
}

template <class Real>
void ChainSet<Real>::evaluate(Curve& curve, const Sweep<Real>& sweep) const {
    for (std::size_t k = 0; k < curve.responses.size(); ++k) {
        const int v = curve.plan.vertices[k];
        curve.responses[k] = {double(sweep.particles[8 * v + 3]),
                              sweep.air ? three(sweep.air + 4 * v) : Vec<double>{}};
    }
    for (std::size_t i = 0; i < curve.plan.places.size(); ++i) {
        const ChainPlace& place = curve.plan.places[i];
        if (place.value == 0) parts_[place.part]->evaluate(place.row, sweep, &curve.rows[i]);
        for (int a = 0; a < place.arity; ++a)
            if (place.at[a] >= 0)
                curve.rows[i].answer[a] =
                    curve.responses[place.at[a]].of(curve.rows[i].gradient[a]);
    }
}

// The matrix, and which of its pivots are too small.
template <class Real>
void ChainSet<Real>::assemble(Curve& curve, double inverseH2) {
    curve.system.clear();
    const std::span<double> entries = curve.system.entries();
    for (const Coupling& c : curve.couplings)
        entries[c.entry] += dot(curve.rows[c.i].answer[c.a], curve.rows[c.j].gradient[c.b]);
    for (int i = 0; i < curve.system.rows(); ++i) {
        double& own = curve.system.at(i, i);
        own += curve.rows[i].compliance * inverseH2;
        curve.least[i] = redundant * own;
    }
}

// W J^T change, summed by vertex.
template <class Real>
void ChainSet<Real>::gather(Curve& curve) {
    std::ranges::fill(curve.moves, Vec<double>{});
    for (std::size_t i = 0; i < curve.plan.places.size(); ++i) {
        const ChainPlace& place = curve.plan.places[i];
        for (int a = 0; a < place.arity; ++a)
            if (place.at[a] >= 0)
                curve.moves[place.at[a]] += curve.change[i] * curve.rows[i].answer[a];
    }
}

// From one end of a link to the other, where they are now.
template <class Real>
Vec<double> ChainSet<Real>::apart(const ChainLink& link, const Sweep<Real>& sweep,
                                  const Curve& curve) const {
    const ChainPlace& place = curve.plan.places[link.row];
    const int* const v = &parts_[place.part]->ids()[2 * place.row];
    const Real *const p = sweep.particles + 8 * v[0], *const q = sweep.particles + 8 * v[1];
    return (three(q) - three(p)) + (three(q + 4) - three(p + 4));
}

// Links that pull act along where they come to lie, not along where they were: geometric stiffness,
// as strands have it (sheets/strands/README.md). With tensions T = -change / length,
// (M + K) e = (J(x) - J(x at first))^T change, K the sum of T (I, -I; -I, I).
template <class Real>
void ChainSet<Real>::turn(Curve& curve, const Sweep<Real>& sweep) const {
    const ChainCurve& plan = curve.plan;
    const auto moved = [&](int at) { return at < 0 ? Vec<double>{} : curve.moves[at]; };
    curve.turning.clear();
    std::ranges::fill(curve.turned, Vec<double>{});
    for (int k = 0; k < curve.turning.rows(); ++k)
        curve.turning.at(k, k) = 1 / curve.responses[k].w;
    for (const ChainLink& link : plan.links) {
        const double tension = -curve.change[link.row];
        if (!(tension > 0)) continue;
        const Vec<double> turned = apart(link, sweep, curve) + (moved(link.b) - moved(link.a));
        const double inverse = divide(1.0, length(turned)), stiffness = tension * inverse;
        const Vec<double> pull = tension * (curve.rows[link.row].gradient[1] - inverse * turned);
        for (const auto& [at, sign] : {std::pair{link.a, -1.0}, {link.b, 1.0}}) {
            if (at < 0) continue;
            curve.turning.at(at, at) += stiffness;
            curve.turned[at] += sign * pull;
        }
        if (link.a >= 0 && link.b >= 0)
            curve.turning.at(std::min(link.a, link.b), std::max(link.a, link.b)) -= stiffness;
    }
    curve.turning.solve(curve.turned);
    for (std::size_t k = 0; k < curve.moves.size(); ++k) curve.moves[k] += curve.turned[k];
}

// The part of the step to take, as of DirectSet: no vertex goes further than the curve is long.
template <class Real>
double ChainSet<Real>::bounded(const Curve& curve, const Sweep<Real>& sweep) const {
    double size = 0, furthest = 0;
    for (const ChainLink& link : curve.plan.links)
        size += length(apart(link, sweep, curve)) + std::fabs(curve.rows[link.row].c);
    for (const Vec<double>& move : curve.moves) furthest = std::max(furthest, length(move));
    return size > 0 && furthest > size ? size / furthest : 1;
}

// To the three numbers of each vertex.
template <class Real>
void ChainSet<Real>::add(const Curve& curve, double strength, Real* to, int stride) {
    for (std::size_t k = 0; k < curve.moves.size(); ++k) {
        Real* const v = to + stride * curve.plan.vertices[k];
        put(v, three(v) + strength * curve.moves[k]);
    }
}

template <class Real>
void ChainSet<Real>::project(const Sweep<Real>& sweep, Direction, Workers& workers) {
    const double inverseH2 = double(sweep.inverseH2), keep = double(sweep.keep);
    forCurves(workers, [&](Curve& curve) {
        evaluate(curve, sweep);
        assemble(curve, inverseH2);
        for (std::size_t i = 0; i < curve.change.size(); ++i) {
            const ChainRow& row = curve.rows[i];
            curve.lambda[i] *= keep;
            curve.change[i] = -(row.c + row.compliance * inverseH2 * curve.lambda[i]);
        }
        curve.system.solve(curve.change, curve.least);
        gather(curve);
        turn(curve, sweep);
        const double strength = double(sweep.strength) * bounded(curve, sweep);
        for (std::size_t i = 0; i < curve.change.size(); ++i)
            curve.lambda[i] += strength * curve.change[i];
        add(curve, strength, sweep.particles + 4, 8);
    });
}

template <class Real>
void ChainSet<Real>::damp(const Sweep<Real>& sweep, Workers& workers) {
    forCurves(workers, [&](Curve& curve) {
        evaluate(curve, sweep);
        assemble(curve, 0);
        for (std::size_t i = 0; i < curve.change.size(); ++i) {
            const ChainPlace& place = curve.plan.places[i];
            double rate = 0;
            for (int a = 0; a < place.arity; ++a) {
                const int v = parts_[place.part]->ids()[place.row * place.arity + a];
                rate += dot(curve.rows[i].gradient[a], three(sweep.out + 4 * v));
            }
            curve.change[i] = -rate;
        }
        curve.system.solve(curve.change, curve.least);
        gather(curve);
        add(curve, double(sweep.strength), sweep.out, 4);
    });
}

template <class Real>
void ChainSet<Real>::noteRides(const Sweep<Real>& sweep) {
    for (std::size_t i = 0; i < riders_.size(); ++i) middles_[i] = movedBy(sweep, riders_[i].edge);
}

template <class Real>
void ChainSet<Real>::carryRides(const Sweep<Real>& sweep) {
    for (std::size_t i = 0; i < riders_.size(); ++i) {
        Real* const p = sweep.particles + 8 * riders_[i].vertex;
        if (p[3] == 0) continue;
        put(p + 4, three(p + 4) + 0.5 * (movedBy(sweep, riders_[i].edge) - middles_[i]));
    }
}

template class ChainSet<float>;
template class ChainSet<double>;

void Chains::constrain(World& world, SetOptions options) const {
    const auto make = [chains = *this, name = options.name]<class Real>(
                          const World& w, KernelChoice) -> std::unique_ptr<Constraint<Real>> {
        typename ChainSet<Real>::Parts parts;
        for (const auto& maker : chains.makers_) parts.push_back(maker(name, w.start.size()));
        return std::make_unique<ChainSet<Real>>(std::move(parts), chains.curves_, w.pinned,
                                                chains.riders_);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
