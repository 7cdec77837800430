// All rows along curves at once: against dense linear algebra, and where there is no solution.
#include "tests/catch.h"
#include "tests/hand_state.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/constraints/kinds.h>
#include <plait/numbers/convert.h>
#include <plait/numbers/finite.h>
#include <plait/rods/bend_vector.h>
#include <plait/rods/chain_set.h>
#include <plait/rods/frame_rows.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <Eigen/Dense>
#include <cstring>
#include <tuple>

using namespace plait;
using namespace plait::test;

namespace {

using Points = std::vector<Vec<double>>;

constexpr double h = 0.01;  // s

// Curves of any vertices with random rows of three kinds, and the one set of these.
struct Net {
    World world;
    std::vector<std::vector<int>> curves;
    Rows<Stretch> links;
    Rows<BendVector> bends;
    Rows<DirectorAcross> across;

    // Of `count` vertices, closed or with a pinned end or with two.
    void add(Random& random, int count, bool closed, int pins, bool more = true) {
        std::vector<Vec<double>> x{random.point(1)};
        while (static_cast<int>(x.size()) < count) x.push_back(x.back() + random.point(1));
        const Range range = world.add({SimplicialComplex(count), x});
        for (int i = 0; i < count; ++i) world.mass[range.first + i] = random.uniform(0.1, 3);
        const auto at = [&](int i) { return range.first + i % count; };
        for (int i = 0; i + 1 < count + closed; ++i) {
            links.ids.insert(links.ids.end(), {at(i), at(i + 1)});
            const double soft = random.below(2) ? 0 : random.uniform(0, 1e-3);
            links.rows.push_back({random.uniform(0.5, 1.5), soft, soft});
        }
        for (int i = 0; i + 2 < count + 2 * closed; ++i) {
            bends.ids.insert(bends.ids.end(), {at(i), at(i + 1), at(i + 2)});
            bends.rows.push_back({random.uniform(1e-5, 1e-3)});
            if (i % 5 || !more) continue;
            across.ids.insert(across.ids.end(), {at(i + 2), at(i), at(i + 1)});
            across.rows.push_back({random.uniform(1e-5, 1e-3)});
        }
        if (pins > 0) world.pin({range.first});
        if (pins > 1) world.pin({range.last - 1});
        std::vector<int> curve;
        for (int v = range.first; v < range.last; ++v) curve.push_back(v);
        curves.push_back(curve);
    }

    template <class Real>
    std::unique_ptr<ChainSet<Real>> set(KernelChoice choice = bestKernels()) const {
        typename ChainSet<Real>::Parts parts;
        parts.push_back(std::make_unique<ChainPartOf<BendVector>>(
            std::make_shared<const Rows<BendVector>>(bends)));
        parts.push_back(
            std::make_unique<ChainPartOf<Stretch>>(std::make_shared<const Rows<Stretch>>(links)));
        parts.push_back(std::make_unique<ChainPartOf<DirectorAcross>>(
            std::make_shared<const Rows<DirectorAcross>>(across)));
        return std::make_unique<ChainSet<Real>>(std::move(parts), curves, world.pinned, choice);
    }
};

template <class Real>
Sweep<Real> sweepOf(State<Real>& state, double strength = 1) {
    return {.particles = &state.particles[0].x.x,
            .out = &state.velocity[0].v.x,
            .inverseH2 = static_cast<Real>(1 / (h * h)),
            .keep = 1,
            .strength = static_cast<Real>(strength)};
}

// J, C and compliance of all rows of the net, dense; links first.
struct Dense {
    Eigen::MatrixXd j;
    Eigen::VectorXd c, compliance, w;

    Dense(const Net& net, const State<double>& state) : net_(net), state_(state) {
        const Eigen::Index rows = net.links.size() + 2 * net.bends.size() + net.across.size();
        j = Eigen::MatrixXd::Zero(rows, 3 * state.count());
        c = compliance = Eigen::VectorXd::Zero(rows);
        w = Eigen::VectorXd(3 * state.count());
        for (int v = 0; v < state.count(); ++v)
            w.segment<3>(3 * v).setConstant(state.particles[v].w);
        add(net.links);
        add(net.bends);
        add(net.across);
    }

    Eigen::VectorXd multipliers(const Eigen::VectorXd& right, double inverseH2) const {
        Eigen::MatrixXd a = j * w.asDiagonal() * j.transpose();
        a += Eigen::MatrixXd((inverseH2 * compliance).asDiagonal());
        return a.completeOrthogonalDecomposition().solve(right);
    }
    Eigen::VectorXd moves(const Eigen::VectorXd& lambda) const {
        return w.asDiagonal() * (j.transpose() * lambda);
    }

    // What links that pull add to `moves` by acting along where they come to lie: of
    // (1 + W K) e = W (J(x) - J(x at first))^T lambda.
    Eigen::VectorXd turned(const Eigen::VectorXd& lambda, const Eigen::VectorXd& moved) const {
        const Eigen::Index n = moved.size();
        Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
        Eigen::VectorXd pull = Eigen::VectorXd::Zero(n);
        for (int i = 0; i < net_.links.size(); ++i) {
            if (lambda(i) >= 0) continue;
            const int a = 3 * net_.links.ids[2 * i], b = 3 * net_.links.ids[2 * i + 1];
            const Vec<double> d = state_.position(b / 3) - state_.position(a / 3);
            const Eigen::Vector3d along = j.block<1, 3>(i, b).transpose(),
                                  apart = Eigen::Vector3d(d.x, d.y, d.z) + moved.segment<3>(b) -
                                          moved.segment<3>(a);
            const Eigen::Matrix3d stiffness =
                -lambda(i) / apart.norm() * Eigen::Matrix3d::Identity();
            const Eigen::Vector3d turn = lambda(i) * (apart.normalized() - along);
            for (const auto& [at, other, sign] : {std::tuple{a, b, -1.0}, {b, a, 1.0}}) {
                k.block<3, 3>(at, at) += stiffness;
                k.block<3, 3>(at, other) -= stiffness;
                pull.segment<3>(at) += sign * turn;
            }
        }
        const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n) + w.asDiagonal() * k;
        return system.partialPivLu().solve(Eigen::VectorXd(w.asDiagonal() * pull));
    }

private:
    template <class Kind>
    void add(const Rows<Kind>& rows) {
        for (int i = 0; i < rows.size(); ++i) {
            const int* const ids = &rows.ids[Kind::arity * i];
            Stencil<Vec<double>, Kind::arity> x;
            for (int a = 0; a < Kind::arity; ++a)
                x[a] = state_.position(ids[a]) - state_.position(ids[0]);
            if constexpr (requires { Kind::values; }) {
                typename Kind::template Gradients<double> g;
                const auto value = Kind::evaluate(rows.rows[i], x, x, g);
                for (int k = 0; k < Kind::values; ++k)
                    put(ids, g[k], value[k], Kind::compliance(rows.rows[i])[k]);
            } else {
                Stencil<Vec<double>, Kind::arity> g;
                const double value = Kind::evaluate(rows.rows[i], x, g);
                put(ids, g, value, rows.rows[i].compliance);
            }
        }
    }

    template <int arity>
    void put(const int* ids, const Stencil<Vec<double>, arity>& g, double value, double soft) {
        for (int a = 0; a < arity; ++a)
            j.block<1, 3>(count_, 3 * ids[a]) += Eigen::RowVector3d(g[a].x, g[a].y, g[a].z);
        c(count_) = value;
        compliance(count_++) = soft;
    }

    const Net& net_;
    const State<double>& state_;
    Eigen::Index count_ = 0;
};

Net randomNet(Random& random, int trial) {
    Net net;
    net.add(random, 4 + random.below(30), false, random.below(3));
    if (trial % 2) net.add(random, 20 + random.below(20), trial % 4 == 1, random.below(2));
    return net;
}

Eigen::VectorXd numbersOf(const Points& x) {
    Eigen::VectorXd all(3 * std::ssize(x));
    for (Eigen::Index v = 0; v < std::ssize(x); ++v)
        all.segment<3>(3 * v) << x[v].x, x[v].y, x[v].z;
    return all;
}

}  // namespace

TEST_CASE("chains: an evaluation is one Newton step, as a dense system makes it", "[rods]") {
    Random random(5);
    int compared = 0;
    double worst = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const Net net = randomNet(random, trial);
        State<double> state = stateOf<double>(net.world);
        const Dense dense(net, state);
        Workers workers{1};
        const double strength = random.uniform(0, 1), inverseH2 = 1 / (h * h);
        const Eigen::VectorXd lambda = dense.multipliers(-dense.c, inverseH2),
                              straight = dense.moves(lambda),
                              exact = strength * (straight + dense.turned(lambda, straight));
        const auto set = net.set<double>();
        set->begin({h, 1}, workers);
        set->project(sweepOf(state, strength), Direction::forward, workers);
        Points moved;
        for (int v = 0; v < state.count(); ++v) moved.push_back(state.particles[v].d);
        if (exact.norm() > 2 * strength) continue;  // a step that long may be cut
        ++compared;
        worst = std::max(worst, (numbersOf(moved) - exact).norm());
    }
    CHECK(report("where vertices go, m", worst, 1e-9));
    CHECK(compared > 10);
}

TEST_CASE("chains: rates of all rows at once, as a dense system has them", "[rods]") {
    Random random(6);
    double worst = 0;
    for (int trial = 0; trial < 60; ++trial) {
        Net net;  // rows that say nothing twice
        for (const int pins : {0, 1}) net.add(random, 4 + random.below(30), false, pins, false);
        State<double> state = stateOf<double>(net.world);
        Points before, after;
        for (int v = 0; v < state.count(); ++v) {
            state.velocity[v].v = net.world.pinned[v] ? Vec<double>{} : random.point(1);
            before.push_back(state.velocity[v].v);
        }
        const Dense dense(net, state);
        Workers workers{1};
        const double strength = random.uniform(0, 1);
        net.set<double>()->damp(sweepOf(state, strength), workers);
        for (int v = 0; v < state.count(); ++v) after.push_back(state.velocity[v].v);
        const Eigen::VectorXd v = numbersOf(before);
        const Eigen::VectorXd exact =
            v + strength * dense.moves(dense.multipliers(-dense.j * v, 0));
        worst = std::max(worst, (numbersOf(after) - exact).norm());
    }
    CHECK(report("velocities, m/s", worst, 1e-7));
}

// Of three substeps, the last of two evaluations, and rates taken off.
template <class Real>
State<Real> swept(const Net& net, KernelChoice choice, int threads) {
    State<Real> state = stateOf<Real>(net.world);
    Workers workers{threads};
    const auto set = net.set<Real>(choice);
    for (int round = 0; round < 4; ++round) {
        if (round < 3) set->begin({h, 1}, workers);
        set->project(sweepOf(state, 0.9), Direction::forward, workers);
    }
    for (int v = 0; v < state.count(); ++v)
        state.velocity[v].v = net.world.pinned[v] ? Vec<Real>{} : state.particles[v].d;
    set->damp(sweepOf(state, 0.5), workers);
    return state;
}

// Of vertices first to last of a, and as many from 0 on of b.
template <class Real>
void requireSame(const State<Real>& a, const State<Real>& b, int first, int last) {
    for (int v = first; v < last; ++v) {
        REQUIRE(isFinite(a.particles[v]));
        REQUIRE(isFinite(a.velocity[v]));
        REQUIRE(std::memcmp(&a.particles[v], &b.particles[v - first], sizeof a.particles[v]) == 0);
        REQUIRE(std::memcmp(&a.velocity[v], &b.velocity[v - first], sizeof a.velocity[v]) == 0);
    }
}

// Curves of four plans, more of each than there are lanes, and one of its own.
Net manyCurves(Random& random) {
    Net net;
    for (int curve = 0; curve < 41; ++curve) net.add(random, 12, curve % 4 == 0, curve % 2);
    net.add(random, 30, true, 0);
    return net;
}

TEMPLATE_TEST_CASE("chains: the same bits in all lanes, levels and threads",
                   "[rods][threads][determinism]", float, double) {
    Random random(8);
    const Net net = manyCurves(random);
    const auto single = swept<TestType>(net, {Isa::v2, 1}, 1);
    for (const Isa isa : {Isa::v2, Isa::v3, Isa::v4})
        for (const int lanes : {1, 4, 8, 16}) {
            if (!available({isa, lanes})) continue;
            const auto other = swept<TestType>(net, {isa, lanes}, 1);
            requireSame(single, other, 0, single.count());
        }
    for (const int threads : {2, 5}) {
        const auto other = swept<TestType>(net, bestKernels(), threads);
        requireSame(single, other, 0, single.count());
    }
}

TEST_CASE("chains: a curve has the same bits alone and among others", "[rods][determinism]") {
    Random random(9);
    Net many;
    std::vector<Net> alone(9);
    for (Net& net : alone) {
        Random twin = random;
        net.add(random, 14, false, 1);
        many.add(twin, 14, false, 1);
    }
    const auto all = swept<float>(many, bestKernels(), 1);
    for (int i = 0; i < 9; ++i)
        requireSame(all, swept<float>(alone[static_cast<std::size_t>(i)], bestKernels(), 1), 14 * i,
                    14 * (i + 1));
}

TEST_CASE("chains: ends held further apart than the curve is long stay finite", "[rods]") {
    for (const double off : {0.0, 1e-9, 0.1}) {
        World world;
        const Range rod = world.add(chain({.links = 20, .to = {1, off, 0}}));
        world.pin({rod.first, rod.last - 1});
        Rows<Stretch> links;
        Chains chains;
        for (int v = rod.first; v + 1 < rod.last; ++v) {
            links.ids.insert(links.ids.end(), {v, v + 1});
            links.rows.push_back({0.04, 0, 0});
        }
        chains.add(links);
        chains.addCurve(pointStencils(rod));
        chains.constrain(world, {.name = "rod"});
        Solver<float> solver(world, {.schedule = {.substeps = 10, .iterations = 1}});
        for (int frame = 0; frame < 24; ++frame) solver.frame();
        for (const Vec<double>& x : solver.positions()) CHECK(length(x) < 2);
    }
}

TEST_CASE("chains: what cannot be planned is refused", "[rods]") {
    World world;
    const Range rod = world.add(chain({.links = 3}));
    const auto solve = [&](const Chains& chains) {
        World w = world;
        chains.constrain(w, {.name = "rod"});
        Solver<float>(w, SolverOptions{});
    };
    Rows<Stretch> links{{0, 1, 1, 2, 2, 3}, std::vector<Stretch::Row<double>>(3), {}, {}};
    Chains off, twice, buckles;
    off.add(links);
    off.addCurve({0, 1, 2});
    CHECK_THROWS_WITH(solve(off), Catch::Contains("vertex 3 is not on the curve"));
    twice.add(links);
    twice.addCurve({0, 1, 2, 3});
    twice.addCurve({3});
    CHECK_THROWS_WITH(solve(twice), Catch::Contains("vertex 3 lies on two curves"));
    links.rows[0].compression = slack;
    buckles.add(links);
    buckles.addCurve(pointStencils(rod));
    CHECK_THROWS_WITH(solve(buckles), Catch::Contains("one side"));
}
