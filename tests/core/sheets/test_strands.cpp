// Strands: how links are strung, and their solve in lanes against dense algebra and DirectSet.
#include "tests/catch.h"
#include "tests/core/air/air_run.h"
#include "tests/report.h"
#include "tests/sheet.h"
#include "tests/shells.h"

#include <plait/constraints/constants.h>
#include <plait/measure/energy.h>
#include <plait/measure/momentum.h>
#include <plait/numbers/elementary.h>
#include <plait/sets/direct_set.h>
#include <plait/sheets/strands/strand_set.h>

#include <Eigen/Dense>
#include <limits>
#include <set>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

// What strandsOf promises for any links.
void checkStrands(const std::string& name, const std::vector<int>& links, const Points& rest) {
    INFO(name);
    const std::vector<Strand> strands = strandsOf(links, rest);
    std::vector<int> uses(links.size() / 2, 0);
    std::set<std::pair<int, int>> taken;  // colour, vertex
    for (const Strand& strand : strands) {
        REQUIRE(strand.vertices.size() == strand.links.size() + 1);
        for (std::size_t k = 0; k < strand.links.size(); ++k) {
            const int l = strand.links[k], a = strand.vertices[k], b = strand.vertices[k + 1];
            ++uses[l];
            REQUIRE(std::minmax(links[2 * l], links[2 * l + 1]) == std::minmax(a, b));
        }
        for (const int v : strand.vertices) REQUIRE(taken.emplace(strand.color, v).second);
    }
    for (const int n : uses) REQUIRE(n == 1);
}

// Chains of uneven length far from the origin, slightly bent, each pinned at its first vertex, with
// links off their rest length; or, `free`, without pins.
struct Chains {
    World world;
    Rows<Stretch> rows;

    explicit Chains(int count, bool free = false, bool compliant = true) {
        Random random(7);
        for (int c = 0; c < count; ++c) {
            const int links = 1 + random.below(30);
            Points x{Vec<double>{5, 7, -4} + random.point(3)};
            for (int k = 0; k < links; ++k)
                x.push_back(x.back() + Vec<double>{0, -0.1, 0} + random.point(0.02));
            const Range all = world.add({chain({.links = links}).complex, x});
            if (!free) world.pin({all.first});
        }
        for (double& mass : world.mass) mass = random.uniform(0.1, 1);
        rows = linksOf(world);
        for (auto& row : rows.rows) {
            row.rest *= random.uniform(0.9, 1.1);
            if (compliant && random.below(2))
                row.compliance = row.compression = random.uniform(0, 1e-3);
        }
    }
};

constexpr double h = 0.01;

template <class Real>
Sweep<Real> sweepOver(State<Real>& state, double strength = 1) {
    return {.particles = &state.particles[0].x.x,
            .out = &state.velocity[0].v.x,
            .inverseH2 = static_cast<Real>(1 / (h * h)),
            .keep = 1,
            .strength = static_cast<Real>(strength)};
}

template <class Real>
Points positionsOf(const State<Real>& state) {
    Points x;
    for (int i = 0; i < state.count(); ++i) x.push_back(state.position(i));
    return x;
}

double furthest(const Points& a, const Points& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
    return most;
}

// The Newton step of all links at once, from the definition: (J W J^T + a) dlambda = -(C + a
// lambda), x += W J^T dlambda.
struct Dense {
    const Chains& of;
    const State<double>& state;
    Points x;
    Eigen::VectorXd lambda;
    double condition = 1;
    bool geometricStiffness = false;

    Dense(const Chains& chains, const State<double>& start)
        : of(chains),
          state(start),
          x(positionsOf(start)),
          lambda(Eigen::VectorXd::Zero(of.rows.size())) {}

    void evaluate() {
        const int n = of.rows.size();
        Eigen::MatrixXd j = Eigen::MatrixXd::Zero(n, 3 * state.count()),
                        w = Eigen::MatrixXd::Zero(j.cols(), j.cols());
        Eigen::VectorXd c(n), a(n);
        for (int i = 0; i < n; ++i) {
            const int from = of.rows.ids[2 * i], to = of.rows.ids[2 * i + 1];
            const Vec<double> d = x[to] - x[from];
            const Eigen::RowVector3d along = Eigen::RowVector3d(d.x, d.y, d.z) / length(d);
            j.block<1, 3>(i, 3 * to) = along;
            j.block<1, 3>(i, 3 * from) = -along;
            c(i) = length(d) - of.rows.rows[i].rest;
            a(i) = of.rows.rows[i].compliance / (h * h);
        }
        for (int v = 0; v < state.count(); ++v)
            w.block<3, 3>(3 * v, 3 * v) = state.particles[v].w * Eigen::Matrix3d::Identity();
        Eigen::MatrixXd system = j * w * j.transpose();
        system.diagonal() += a;
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(system, Eigen::EigenvaluesOnly);
        condition = eigen.eigenvalues().maxCoeff() / eigen.eigenvalues().minCoeff();
        const Eigen::VectorXd change = -system.ldlt().solve(c + a.cwiseProduct(lambda));
        lambda += change;
        const Eigen::VectorXd move = w * j.transpose() * change;
        const Points before = x;
        for (int v = 0; v < state.count(); ++v)
            x[v] += Vec<double>{move(3 * v), move(3 * v + 1), move(3 * v + 2)};
        if (geometricStiffness) turn(before, change);
    }

    // (1 + w K) e = w (J(x)^T - J(before)^T) change, K a net of springs: the tension over the
    // length.
    void turn(const Points& before, const Eigen::VectorXd& change) {
        const int n = state.count();
        Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n), p = Eigen::MatrixXd::Zero(n, 3);
        for (int i = 0; i < static_cast<int>(of.rows.size()); ++i) {
            const double tension = std::max(0.0, -change(i));
            const int ids[] = {of.rows.ids[2 * i], of.rows.ids[2 * i + 1]};
            const Vec<double> was = before[ids[1]] - before[ids[0]], is = x[ids[1]] - x[ids[0]];
            const Vec<double> pull = tension * (1 / length(was) * was - 1 / length(is) * is);
            const Eigen::RowVector3d row(pull.x, pull.y, pull.z);
            p.row(ids[1]) += row;
            p.row(ids[0]) -= row;
            for (const int a : ids)
                for (const int b : ids) k(a, b) += (a == b ? 1 : -1) * tension / length(is);
        }
        Eigen::VectorXd w(n);
        for (int v = 0; v < n; ++v) w(v) = state.particles[v].w;
        const Eigen::MatrixXd system =
            Eigen::MatrixXd::Identity(n, n) + Eigen::MatrixXd(w.asDiagonal() * k);
        const Eigen::MatrixXd e = system.partialPivLu().solve(w.asDiagonal() * p);
        for (int v = 0; v < n; ++v) x[v] += Vec<double>{e(v, 0), e(v, 1), e(v, 2)};
    }
};

}  // namespace

TEST_CASE("strands: every link in one, no vertex twice, colours apart", "[strands]") {
    const auto edgesOf = [](const Shape& shape) {
        return edgeStencils(shape.complex, {0, static_cast<int>(shape.positions.size())});
    };
    const Shape shapes[] = {grid({.columns = 9, .rows = 7}), disc({.rings = 5}), sphere({}),
                            tube({.segments = 12, .rings = 5}), helix({.links = 40})};
    for (const Shape& shape : shapes)
        checkStrands(std::to_string(&shape - shapes), edgesOf(shape), shape.positions);
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Shell shell = shellOf(12, 9, seed);
        checkStrands("random", shell.links, shell.rest);
    }
}

TEST_CASE("strands: those of a grid are its rows, columns and diagonals", "[strands]") {
    constexpr int columns = 9, rows = 6;
    const Shape shape = grid({.columns = columns, .rows = rows});
    const std::vector<Strand> strands =
        strandsOf(edgeStencils(shape.complex, {0, columns * rows}), shape.positions);
    int straight[3] = {0, 0, 0};
    for (const Strand& strand : strands) {
        const int step = std::abs(strand.vertices[1] - strand.vertices[0]);
        for (std::size_t k = 1; k < strand.vertices.size(); ++k)
            REQUIRE(std::abs(strand.vertices[k] - strand.vertices[k - 1]) == step);
        ++straight[step == 1 ? 0 : step == columns ? 1 : 2];
    }
    CHECK(straight[0] == rows);
    CHECK(straight[1] == columns);
    CHECK(straight[2] == rows + columns - 3);
}

TEST_CASE("strands: a ring is cut", "[strands]") {
    constexpr int n = 10;
    Points rest;
    std::vector<int> links;
    for (int i = 0; i < n; ++i) {
        rest.push_back(
            {std::cos(2 * std::numbers::pi * i / n), 0, std::sin(2 * std::numbers::pi * i / n)});
        links.insert(links.end(), {i, (i + 1) % n});
    }
    checkStrands("ring", links, rest);
    const std::vector<Strand> strands = strandsOf(links, rest);
    REQUIRE(strands.size() == 2);
    CHECK(strands[0].links.size() == n - 1);
    CHECK(strands[1].color != strands[0].color);
}

// Links from one vertex in random directions: of all ways to pair them, the best by brute force.
double bestOf(const Points& directions, std::vector<bool>& taken, std::size_t from = 0) {
    while (from < taken.size() && taken[from]) ++from;
    if (from == taken.size()) return 0;
    taken[from] = true;
    double best = bestOf(directions, taken, from);
    for (std::size_t i = from + 1; i < taken.size(); ++i) {
        const double cosine = dot(directions[from], directions[i]);
        if (taken[i] || cosine > -0.5) continue;
        taken[i] = true;
        best = std::max(best, 1 - cosine + bestOf(directions, taken, from));
        taken[i] = false;
    }
    taken[from] = false;
    return best;
}

TEST_CASE("strands: as many and as straight as can be go through a vertex", "[strands]") {
    Random random(12);
    for (int trial = 0; trial < 200; ++trial) {
        Points rest{{0, 0, 0}};
        std::vector<int> links;
        const int count = 2 + random.below(8);
        for (int i = 1; i <= count; ++i) {
            Vec<double> x = random.point(1);
            x.z *= 0.2;
            rest.push_back((1 / length(x)) * x);
            links.insert(links.end(), {0, i});
        }
        double sum = 0;
        for (const Strand& strand : strandsOf(links, rest))
            if (strand.links.size() == 2)
                sum += 1 - dot(rest[strand.vertices.front()], rest[strand.vertices.back()]);
        const Points directions(rest.begin() + 1, rest.end());
        std::vector<bool> taken(directions.size(), false);
        REQUIRE(sum == Approx(bestOf(directions, taken)).epsilon(1e-12));
    }
    // A fan of many: still every link in one strand.
    Points rest{{0, 0, 0}};
    std::vector<int> links;
    for (int i = 1; i <= 40; ++i) {
        rest.push_back({cosine(0.157 * i), sine(0.157 * i), 0});
        links.insert(links.end(), {0, i});
    }
    checkStrands("fan", links, rest);
    CHECK(strandsOf(links, rest).size() == 20);
}

TEST_CASE("strands: a corner of more than 60 degrees ends one", "[strands]") {
    const auto count = [](double turn) {
        const Points rest{{-1, 0, 0}, {0, 0, 0}, {std::cos(turn), std::sin(turn), 0}};
        return strandsOf(std::vector<int>{0, 1, 2, 1}, rest).size();
    };
    CHECK(count(59 * std::numbers::pi / 180) == 1);
    CHECK(count(61 * std::numbers::pi / 180) == 2);
}

// Three evaluations of one substep, so that multipliers count as well. A float solve is off by its
// rounding times the condition of the system.
TEMPLATE_TEST_CASE("strands: evaluations are those of dense algebra", "[strands][figures]", double,
                   float) {
    for (const bool turns : {false, true}) {
        const Chains chains(20);
        State<double> start = stateOf<double>(chains.world);
        State<TestType> state = stateOf<TestType>(chains.world);
        Dense dense(chains, start);
        dense.geometricStiffness = turns;
        StrandSet<TestType> set(chains.rows, chains.world.rest, bestKernels(), turns);
        Workers workers(1);
        set.begin({h, 1}, workers);
        const Points before = positionsOf(start);
        for (int evaluation = 0; evaluation < 3; ++evaluation) {
            dense.evaluate();
            set.project(sweepOver(state), Direction::forward, workers);
            // C, and so the right-hand side, is known to some 20 times the rounding of a length.
            const double rounding =
                std::is_same_v<TestType, float> ? 20 * 0x1p-24 * dense.condition : 1e-10;
            REQUIRE(report("strands against dense, of the displacement",
                           furthest(positionsOf(state), dense.x) / furthest(before, dense.x),
                           rounding));
        }
    }
}

TEST_CASE("strands: an evaluation is that of the direct set", "[strands]") {
    const Chains chains(20);
    State<double> a = stateOf<double>(chains.world), b = a;
    Workers workers(1);
    StrandSet<double> strands(chains.rows, chains.world.rest, bestKernels());
    DirectSet<Stretch, double> direct(chains.rows, chains.world.pinned);
    const Points before = positionsOf(a);
    for (Constraint<double>* set :
         {static_cast<Constraint<double>*>(&strands), static_cast<Constraint<double>*>(&direct)})
        set->begin({h, 1}, workers);
    for (int evaluation = 0; evaluation < 3; ++evaluation) {
        strands.project(sweepOver(a), Direction::backward, workers);
        direct.project(sweepOver(b), Direction::forward, workers);
        REQUIRE(report("strands against trees, of the displacement",
                       furthest(positionsOf(a), positionsOf(b)) / furthest(before, positionsOf(b)),
                       1e-10));
    }
}

TEMPLATE_TEST_CASE("strands: corrections of free strands have no resultant and no torque",
                   "[strands]", double, float) {
    const bool turns = GENERATE(false, true);
    Chains chains(20, true);
    if (turns)  // what pushes is not turned
        for (auto& row : chains.rows.rows) row.rest *= 0.7;
    State<TestType> state = stateOf<TestType>(chains.world);
    StrandSet<TestType> set(chains.rows, chains.world.rest, bestKernels(), turns);
    Workers workers(1);
    set.begin({h, 1}, workers);
    const Points x = positionsOf(state);
    set.project(sweepOver(state), Direction::forward, workers);
    Vec<double> sum{}, torque{};
    double size = 0;
    for (int i = 0; i < state.count(); ++i) {
        const Vec<double> p = (1 / double(state.particles[i].w)) * (state.position(i) - x[i]);
        sum += p;
        torque += cross(x[i] - x[0], p);
        size += length(p);
    }
    const double bound = std::is_same_v<TestType, float> ? 1e-6 : 1e-12;
    CHECK(report("resultant", length(sum) / size, bound));
    CHECK(report("torque", length(torque) / size, bound));
}

// A thread drawn tight between two pins, so that h is 10 times what a wave across takes for a link:
// a wiggle from vertex to vertex grows in an explicit step, past c h = 0.58 l
// (sheets/strands/README.md).
TEST_CASE("strands: geometric stiffness lets waves pass many links a substep", "[strands]") {
    const auto wiggleAfter = [](bool geometricStiffness) {
        World world;
        const int links = 32;
        const double l = 0.01, tension = 10, substep = 1.0 / 600;
        Points x;
        for (int k = 0; k <= links; ++k)
            x.push_back({1.001 * k * l, k % 2 && k < links ? 1e-6 : 0, 0});
        Shape shape = chain({.links = links});
        const Range all = world.add({shape.complex, x});
        world.mass.assign(world.mass.size(), tension / l * substep * substep / 100);
        world.pin({all.first, all.last - 1});
        Rows<Stretch> rows = linksOf(world);
        for (auto& row : rows.rows) {
            row.rest = l;
            row.compliance = row.compression = 0.001 * l / tension;
        }
        strand(world, rows, {.name = "thread"}, geometricStiffness);
        Solver<double> solver(world, {.schedule = {.substeps = 10, .frameRate = {60}}});
        for (int frame = 0; frame < 3; ++frame) solver.frame();
        double most = 0;
        for (const Vec<double>& at : solver.positions()) most = std::max(most, std::fabs(at.y));
        return most;
    };
    CHECK(report("wiggle left of 1e-6 m", wiggleAfter(true), 1e-7));
    CHECK(wiggleAfter(false) > 1e-4);
}

TEMPLATE_TEST_CASE("strands: damping takes the part asked for off every rate", "[strands]", double,
                   float) {
    const Chains chains(20);
    State<TestType> state = stateOf<TestType>(chains.world);
    Random random(4);
    for (int i = 0; i < state.count(); ++i)
        if (state.particles[i].w > 0) state.velocity[i].v = narrowed<TestType>(random.point(1));
    const auto rates = [&] {
        std::vector<double> all;
        for (int i = 0; i < chains.rows.size(); ++i) {
            const int a = chains.rows.ids[2 * i], b = chains.rows.ids[2 * i + 1];
            const Vec<double> d = state.position(b) - state.position(a);
            all.push_back(dot(d, widened(state.velocity[b].v - state.velocity[a].v)) / length(d));
        }
        return all;
    };
    const std::vector<double> before = rates();
    StrandSet<TestType> set(chains.rows, chains.world.rest, bestKernels());
    Workers workers(1);
    const Points x = positionsOf(state);
    set.damp(sweepOver(state, 0.3), workers);
    const std::vector<double> after = rates();
    double worst = 0;
    for (std::size_t i = 0; i < after.size(); ++i)
        worst = std::max(worst, std::fabs(after[i] - 0.7 * before[i]));
    CHECK(report("rate left, m/s", worst, std::is_same_v<TestType, float> ? 1e-5 : 1e-12));
    CHECK(positionsOf(state) == x);
}

// A chain at rest on its own weight, each link longer by its compliance times what hangs on it,
// stays there: the multipliers of a substep are the weights.
TEST_CASE("strands: a compliant chain hangs as long as its weight makes it", "[strands]") {
    World world = plumbLine({.links = 20, .length = 0.1, .mass = 0.05});
    Rows<Stretch> rows = linksOf(world, 1e-3);
    double below = 20;
    Vec<double> drop{0, 0, 0};
    for (std::size_t v = 1; v < world.start.size(); ++v) {
        drop.y -= 1e-3 * 0.05 * 9.81 * below--;
        world.start[v] += drop;
    }
    strand(world, rows, {.name = "chain"});
    Solver<double> solver(world, stepping(100));
    advance(solver, 100);
    CHECK(report("sag after 1 s, m", furthest(solver.positions(), world.start), 1e-12));
}

TEST_CASE("strands: the same bits in all lanes, levels and threads",
          "[strands][determinism][threads]") {
    World world;
    const Range sheet = world.add(grid({.columns = 70, .rows = 50}), {.density = 0.2});
    const Range rope = world.add(helix({.links = 33}), {.density = 0.1});
    world.pin({0, 69, rope.first});
    world.act<Gravity>(GravityOptions{});
    actAir(world, {.carried = {.mass = 0.3, .reach = 0.1},
                   .objects = {sheet},
                   .wind = {steady({3, 0, 1}), 0}});
    strand(world, linksOf(world, 1e-6), {.name = "strands", .damping = 0.1}, GENERATE(false, true));
    const auto hashAfter = [&]<class Real>(Real, KernelChoice kernels, int threads) {
        SolverOptions options = stepping(300);
        options.kernels = kernels;
        options.threads = threads;
        Solver<Real> solver(world, options);
        advance(solver, 5);
        return solver.hash();
    };
    const auto single = hashAfter(0.F, {Isa::v2, 1}, 1), full = hashAfter(0., {Isa::v2, 1}, 1);
    for (const Isa isa : {Isa::v2, Isa::v3, Isa::v4})
        for (const int lanes : {1, 4, 8, 16}) {
            if (!available({isa, lanes})) continue;
            CHECK(hashAfter(0.F, {isa, lanes}, 1) == single);
            CHECK(hashAfter(0., {isa, lanes}, 1) == full);
        }
    for (const int threads : {2, 3, 8}) CHECK(hashAfter(0.F, bestKernels(), threads) == single);
}

TEST_CASE("strands: links that buckle, move or do not act are refused", "[strands]") {
    World world;
    world.add(chain({.links = 3}));
    const auto refuses = [&](const Rows<Stretch>& rows, const std::string& what) {
        try {
            StrandSet<float>(rows, world.rest, bestKernels());
            FAIL(what);
        } catch (const std::invalid_argument& e) {
            CHECK(e.what() == what);
        }
    };
    Rows<Stretch> rows = linksOf(world);
    rows.rows[1].compression = slack;
    refuses(rows, "strands: links cannot buckle");
    rows.rows[1].compliance = slack;
    refuses(rows, "strands: every link must act");
    rows = linksOf(world);
    rows.animate = [](double, std::span<Stretch::Row<double>>) {};
    refuses(rows, "strands: rest lengths cannot move");
}

// Its last pivot is nothing but rounding, or little more where it is all but straight.
TEMPLATE_TEST_CASE("strands: a straight strand between two pins stays", "[strands]", double,
                   float) {
    for (const int links : {2, 16, 64, 256})
        for (const double aside : {0.0, 1e-7, 1e-5, 1e-3}) {
            World world;
            const Range all =
                world.add(chain({.links = links, .from = {0.3, 2, 0.1}, .to = {0.9, 1.7, 0.7}}));
            world.pin({all.first, all.last - 1});
            Random random(5);
            for (int v = 1; v < links; ++v) world.start[v] += random.point(aside / links);
            State<TestType> state = stateOf<TestType>(world);
            const Points start = positionsOf(state);
            StrandSet<TestType> set(linksOf(world), world.rest, bestKernels());
            Workers workers(1);
            double most = 0;
            for (int i = 0; i < 4; ++i) {
                set.begin({h, 1}, workers);
                set.project(sweepOver(state), Direction::forward, workers);
                most = std::max(most, furthest(positionsOf(state), start));
            }
            const double rounding = std::is_same_v<TestType, float> ? 0x1p-24 : 0x1p-53;
            CHECK(report("moved, m, " + std::to_string(links) + " links", most,
                         4 * aside + 20 * links * rounding));
        }
}

// There is no solution; all links but one can hold, and that one takes the gap.
TEMPLATE_TEST_CASE("strands: one that is too short for its pins stays between them", "[strands]",
                   double, float) {
    for (const int links : {2, 16, 64, 256}) {
        World world;
        const Range all =
            world.add(chain({.links = links, .from = {0.3, 2, 0.1}, .to = {0.9, 1.7, 0.7}}));
        world.pin({all.first, all.last - 1});
        const Rows<Stretch> rows = linksOf(world);
        for (Vec<double>& x : world.start) x = world.rest[0] + 1.1 * (x - world.rest[0]);
        State<TestType> state = stateOf<TestType>(world);
        const Points start = positionsOf(state);
        StrandSet<TestType> set(rows, world.rest, bestKernels());
        Workers workers(1);
        set.begin({h, 1}, workers);
        for (int i = 0; i < 4; ++i) set.project(sweepOver(state), Direction::forward, workers);
        CHECK(report("moved, m, " + std::to_string(links) + " links, a gap of 0.09 m",
                     furthest(positionsOf(state), start), 0.09));
    }
}

TEST_CASE("strands: a sheet of warp and weft gains no energy, and holds", "[strands]") {
    constexpr int n = 24;
    World world;
    world.add(grid({.columns = n, .rows = n}, {.across = {1, 0, 0}, .up = {0, 0, 1}}),
              {.density = 0.2});
    // Bent, for a strand that is straight between two pins has no way to go.
    for (Vec<double>& x : world.start)
        x = {0.6 * std::sin(x.x / 0.6), 0.6 * std::cos(x.x / 0.6), x.z};
    world.pin({0, n - 1});
    world.act<Gravity>(GravityOptions{});
    const Rows<Stretch> links = linksOf(world);
    Rows<Stretch> threads[2], bias;
    for (std::size_t i = 0; i < links.rows.size(); ++i) {
        const int a = links.ids[2 * i], b = links.ids[2 * i + 1], apart = std::abs(a - b);
        Rows<Stretch>& set = apart == 1 ? threads[0] : apart == n ? threads[1] : bias;
        set.ids.insert(set.ids.end(), {a, b});
        set.rows.push_back(links.rows[i]);
    }
    strand(world, threads[0], {.name = "warp"});
    strand(world, threads[1], {.name = "weft"});
    world.constrain(bias, {.name = "bias"});
    SolverOptions options;
    options.schedule = {.substeps = 40, .frameRate = {60, 1}, .iterations = 1};
    Solver<double> solver(world, options);
    const auto energy = [&] {
        return kineticEnergy(world.mass, solver.velocities()) +
               gravitationalEnergy(world.mass, solver.positions(), {0, -9.81, 0});
    };
    const double start = energy();
    double most = -1e30, strain = 0;
    for (int frame = 0; frame < 60; ++frame) {
        solver.frame();
        most = std::max(most, energy() - start);
        for (const double e : strainsOf(links, solver.positions())) strain = std::max(strain, e);
    }
    note("greatest energy - start, J", most);
    note("greatest strain", strain);
    CHECK(most <= 0);
    CHECK(strain < 0.05);
}
