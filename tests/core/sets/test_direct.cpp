// The direct solve against dense linear algebra, in closed form, and where there is no solution.
#include "tests/catch.h"
#include "tests/hand_state.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/constraints/kinds.h>
#include <plait/numbers/finite.h>
#include <plait/sets/direct_set.h>
#include <plait/world.h>

#include <Eigen/Dense>
#include <array>
#include <limits>
#include <utility>

using namespace plait;
using namespace plait::test;

namespace {

using Point = Vec<double>;
using Links = std::vector<std::pair<int, int>>;

// Vertices joined by links, in any shape.
struct Net {
    std::vector<Point> x;   // m
    std::vector<double> w;  // 1/kg, 0 where pinned
    Rows<Stretch> rows;

    std::vector<unsigned char> pinned() const {
        std::vector<unsigned char> p;
        for (const double inverse : w) p.push_back(inverse == 0);
        return p;
    }
    void link(int a, int b, double rest, double compliance = 0) {
        rows.ids.insert(rows.ids.end(), {a, b});
        rows.rows.push_back({rest, compliance, compliance});
    }
    int links() const { return rows.size(); }
    int vertices() const { return static_cast<int>(x.size()); }
};

// A net's state in the precision of a run, and the one set that acts on it.
template <class Real, class Kind = Stretch>
struct Run {
    State<Real> state;
    DirectSet<Kind, Real> set;
    Workers workers{1};
    double h = 0.01;
    Real keep = 1;

    Run(const Net& net, const Rows<Kind>& rows) : set(rows, net.pinned()) {
        const auto all = net.x.size() + 1;
        state.particles.resize(all);
        state.velocity.resize(all);
        for (std::size_t i = 0; i < net.x.size(); ++i) {
            const Vec<Real> x = narrow(net.x[i]);
            const Point left = net.x[i] - wide(x);
            state.particles[i] = {x, static_cast<Real>(net.w[i]), narrow(left), 0};
        }
        set.begin({h, 1}, workers);
    }
    explicit Run(const Net& net) : Run(net, net.rows) {}

    static Vec<Real> narrow(const Point& a) {
        return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
    }
    static Point wide(const Vec<Real>& a) { return {double(a.x), double(a.y), double(a.z)}; }

    Sweep<Real> sweep(double strength = 1) {
        return {.particles = &state.particles[0].x.x,
                .out = &state.velocity[0].v.x,
                .inverseH2 = static_cast<Real>(1 / (h * h)),
                .keep = keep,
                .strength = static_cast<Real>(strength)};
    }
    void project(double strength = 1) { set.project(sweep(strength), Direction::forward, workers); }
    std::vector<Point> positions() const {
        std::vector<Point> x;
        for (int i = 0; i < state.count(); ++i) x.push_back(state.position(i));
        return x;
    }
};

// Vertex i > 0 hangs on an earlier one: near the last for a stringy tree, anywhere for a bushy one.
Net randomTree(Random& random, int vertices, bool bushy) {
    Net net;
    Links links;
    for (int i = 0; i < vertices; ++i) {
        const int parent = i == 0  ? 0
                           : bushy ? random.below(i)
                                   : std::max(0, i - 1 - random.below(3));
        const Point step = random.point(1);
        net.x.push_back(i == 0 ? step : net.x[parent] + step);
        net.w.push_back(random.below(8) == 0 ? 0 : 1 / random.uniform(0.01, 10));
        if (i > 0) links.emplace_back(i, parent);
    }
    while (!links.empty()) {  // in any order, turned either way
        std::swap(links[random.below(static_cast<int>(links.size()))], links.back());
        auto [a, b] = links.back();
        links.pop_back();
        if (random.below(2)) std::swap(a, b);
        const bool rigid = random.below(2) && net.w[a] + net.w[b] > 0;
        const double rest = length(net.x[b] - net.x[a]) * random.uniform(0.8, 1.2);
        net.link(a, b, rest, rigid ? 0 : random.uniform(0, 1e-3));
    }
    return net;
}

// C, J and W of a net as dense matrices, from the definition.
struct Dense {
    Eigen::VectorXd c;
    Eigen::MatrixXd j, w;

    Dense(const Net& net, const std::vector<Point>& x)
        : c(net.links()), j(net.links(), 3 * net.vertices()), w(j.cols(), j.cols()) {
        j.setZero();
        w.setZero();
        for (int i = 0; i < net.links(); ++i) {
            const int a = net.rows.ids[2 * i], b = net.rows.ids[2 * i + 1];
            const Point d = x[b] - x[a];
            c(i) = length(d) - net.rows.rows[i].rest;
            const Eigen::RowVector3d g = Eigen::RowVector3d(d.x, d.y, d.z) / length(d);
            j.block<1, 3>(i, 3 * b) = g;
            j.block<1, 3>(i, 3 * a) = -g;
        }
        for (int v = 0; v < net.vertices(); ++v)
            w.block<3, 3>(3 * v, 3 * v) = net.w[v] * Eigen::Matrix3d::Identity();
    }
};

Eigen::VectorXd difference(const std::vector<Point>& a, const std::vector<Point>& b) {
    Eigen::VectorXd d(3 * a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point e = a[i] - b[i];
        d.segment<3>(3 * static_cast<Eigen::Index>(i)) << e.x, e.y, e.z;
    }
    return d;
}

template <class Run>
Eigen::VectorXd multipliers(const Run& run) {
    Eigen::VectorXd lambda(run.set.size());
    for (int i = 0; i < lambda.size(); ++i) lambda(i) = run.set.multiplier(i);
    return lambda;
}

double largest(const Eigen::VectorXd& v) { return v.size() ? v.cwiseAbs().maxCoeff() : 0; }

// Errors of one evaluation from where `run` stands, each relative.
struct Errors {
    double residual = 0;  // of C + J dx + a lambda = 0 (XPBD Eq. 4 and 5, linearised)
    double move = 0;      // of dx = W J^T dlambda
    double dense = 0;     // of dlambda against the dense solve

    void add(const Net& net, Run<double>& run) {
        const std::vector<Point> x = run.positions();
        const Eigen::VectorXd before = multipliers(run);
        const Dense d(net, x);
        run.project();
        const Eigen::VectorXd after = multipliers(run), dx = difference(run.positions(), x);
        Eigen::VectorXd a(net.links());
        for (int i = 0; i < net.links(); ++i) a(i) = net.rows.rows[i].compliance / (run.h * run.h);
        const Eigen::MatrixXd system =
            d.j * d.w * d.j.transpose() + Eigen::MatrixXd(a.asDiagonal());
        const Eigen::VectorXd right = -(d.c + a.cwiseProduct(before)), change = after - before;
        // No row of the tests is redundant, so the dense matrix has an inverse.
        const Eigen::VectorXd expected = system.fullPivLu().solve(right);
        const double scale = system.cwiseAbs().maxCoeff() * largest(after) + largest(d.c);
        residual = std::max(residual, largest(d.c + d.j * dx + a.cwiseProduct(after)) / scale);
        const double reach = largest(dx) + d.w.maxCoeff() * largest(after);
        if (reach > 0) move = std::max(move, largest(dx - d.w * d.j.transpose() * change) / reach);
        dense = std::max(dense, largest(change - expected) / (largest(expected) + largest(before)));
    }
};

double worst(const Net& net, const std::vector<Point>& x) { return largest(Dense(net, x).c); }

bool finite(const std::vector<Point>& x) {
    return std::all_of(x.begin(), x.end(), [](const Point& p) { return isFinite(p); });
}

// A chain along x with equal links; pinned at the first vertex, or at both ends.
Net chain(int links, double rest = 1, bool bothEnds = false) {
    Net net;
    for (int i = 0; i <= links; ++i) {
        net.x.push_back({rest * i, 0, 0});
        net.w.push_back(i == 0 || (bothEnds && i == links) ? 0 : 1);
        if (i > 0) net.link(i - 1, i, rest);
    }
    return net;
}

// Stretch that counts what is asked of it; a kind from outside the core.
struct Counting {
    static constexpr int arity = 2;
    template <class T>
    using Row = Stretch::Row<T>;
    static inline long evaluations = 0, sides = 0;

    template <class T>
    static T evaluate(const Row<T>& row, const Stencil<Vec<T>, 2>& x,
                      Stencil<Vec<T>, 2>& gradient) {
        ++evaluations;
        return Stretch::evaluate(row, x, gradient);
    }
    template <class T>
    static T compliance(const Row<T>& row, T s) {
        ++sides;
        return Stretch::compliance(row, s);
    }
};

Rows<Counting> counted(const Net& net) { return {net.rows.ids, net.rows.rows, {}, {}}; }

// A number that counts the operations done with it.
struct Operation {
    double value;
    static inline long count = 0;

    Operation(double v = 0) : value(v) {}
    friend Operation operator+(Operation a, Operation b) { return ++count, a.value + b.value; }
    friend Operation operator-(Operation a, Operation b) { return ++count, a.value - b.value; }
    friend Operation operator*(Operation a, Operation b) { return ++count, a.value * b.value; }
    friend Operation operator/(Operation a, Operation b) { return ++count, a.value / b.value; }
    friend Operation operator-(Operation a) { return ++count, -a.value; }
    friend bool operator>(Operation a, Operation b) { return a.value > b.value; }
};
Operation select(bool mask, Operation yes, Operation no) { return mask ? yes : no; }

// Operations of one solve, for each link.
double operationsPerLink(const Net& net) {
    const Forest forest = forestOf(net.rows.ids, net.pinned());
    std::vector<TreeNode<Operation>> nodes(forest.nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        TreeNode<Operation>& n = nodes[k];
        n.parent = forest.nodes[k].parent;
        n.w = net.w[forest.nodes[k].vertex];
        n.own = {1, 0, 0};
        n.up = {-1, 0, 0};
        n.c = 0.1;
        n.weight = 2;
    }
    Operation::count = 0;
    for (int t = 0; t < forest.trees(); ++t) solveTree(nodes, forest.start[t], forest.start[t + 1]);
    return static_cast<double>(Operation::count) / net.links();
}

}  // namespace

TEST_CASE("direct: random trees against a dense solve") {
    Random random(1);
    Errors errors;
    for (int trial = 0; trial < 60; ++trial) {
        const Net net = randomTree(random, 2 + random.below(60), trial % 2);
        Run<double> run(net);
        for (int evaluation = 0; evaluation < 3; ++evaluation) errors.add(net, run);
    }
    CHECK(report("C + J dx + a lambda = 0", errors.residual, 1e-12));
    CHECK(report("dx = W J^T dlambda", errors.move, 1e-12));
    CHECK(report("dlambda, against the dense solve", errors.dense, 1e-9));
}

TEST_CASE("direct: a star of 50 arms, free and pinned at the middle") {
    for (const double w : {1.0, 0.0}) {
        Random random(3);
        Net net;
        net.x.push_back({0, 0, 0});
        net.w.push_back(w);
        for (int i = 1; i <= 50; ++i) {
            net.x.push_back(random.point(1));
            net.w.push_back(random.uniform(0.1, 10));
            net.link(i, 0, length(net.x[i]) * random.uniform(0.9, 1.1), i % 2 ? 1e-4 : 0);
        }
        // Fifty directions at one vertex of three dimensions are 50 unknowns, no two alike: each
        // arm has an end of its own.
        Run<double> run(net);
        Errors errors;
        errors.add(net, run);
        const std::string what = w > 0 ? "free middle" : "pinned middle";
        CHECK(report(what + ": C + J dx + a lambda = 0", errors.residual, 1e-12));
        CHECK(report(what + ": dlambda, against the dense solve", errors.dense, 1e-11));
    }
}

TEST_CASE("direct: rigid trees converge quadratically") {
    const auto converge = [](const char* what, Net net, double amplitude) {
        Random random(4);
        for (int i = 0; i < net.vertices(); ++i)
            if (net.w[i] > 0) net.x[i] += random.point(amplitude);
        Run<double> run(net);
        std::vector<double> error{worst(net, net.x)};
        for (int evaluation = 0; evaluation < 8; ++evaluation) {
            run.project();
            error.push_back(worst(net, run.positions()));
        }
        std::printf("    %s, max |C| (m):", what);
        for (std::size_t i = 0; i < 6; ++i) std::printf(" %.1e", error[i]);
        std::printf("\n");
        // Once it is small every step squares the error, up to rounding and a constant: a link at
        // the end turns by what all links before it do.
        for (std::size_t i = 0; i + 1 < error.size(); ++i)
            if (error[i] < 1e-2)
                CHECK(error[i + 1] < 10 * net.links() * error[i] * error[i] + 1e-12);
        CHECK(report(std::string(what) + ": max |C| after 8 evaluations", error.back(), 1e-12));
    };
    Net arch = chain(30, 1, true);
    for (int i = 0; i <= 30; ++i)  // ends 20 m apart, 30 m of chain
        arch.x[i] = {20.0 * i / 30, -6 * (1 - (i - 15) * (i - 15) / 225.0), 0};
    converge("chain of 30", chain(30), 0.2);
    converge("chain of 30, both ends pinned", arch, 0.2);
    Random random(5);
    Net tree = randomTree(random, 60, true);
    for (int i = 0; i < tree.links(); ++i) {
        const int a = tree.rows.ids[2 * i], b = tree.rows.ids[2 * i + 1];
        const double l = length(tree.x[b] - tree.x[a]);
        tree.rows.rows[i] = {l, 0, 0};
    }
    converge("random tree of 60", tree, 0.05);
}

TEMPLATE_TEST_CASE("direct: momentum and angular momentum", "", float, double) {
    Random random(6);
    double linear = 0, angular = 0;
    for (int trial = 0; trial < 20; ++trial) {
        Net net = randomTree(random, 40, trial % 2);
        for (double& w : net.w) w = random.uniform(0.1, 10);
        Run<TestType> run(net);
        const std::vector<Point> x = run.positions();
        run.project();
        const std::vector<Point> y = run.positions();
        Point p{}, l{};
        double scale = 0, scaleL = 0;
        for (int i = 0; i < net.vertices(); ++i) {
            const Point impulse = (y[i] - x[i]) * (1 / double(run.state.particles[i].w));
            p += impulse;
            l += cross(x[i], impulse);
            scale += length(impulse);
            scaleL += length(x[i]) * length(impulse);
        }
        linear = std::max(linear, length(p) / scale);
        angular = std::max(angular, length(l) / scaleL);
    }
    const double bound = std::is_same_v<TestType, double> ? 1e-12 : 1e-6;
    const std::string type = std::is_same_v<TestType, double> ? ", double" : ", float";
    CHECK(report("momentum gained / momentum exchanged" + type, linear, bound));
    CHECK(report("angular momentum gained / exchanged" + type, angular, bound));
}

TEST_CASE("direct: work is linear in the links, whatever the branching") {
    std::vector<double> perLink;
    for (const int n : {1000, 10000, 100000}) {
        Random random(7);
        Net star;
        star.x.resize(n + 1);
        star.w.assign(n + 1, 1);
        for (int i = 1; i <= n; ++i) star.link(0, i, 1);
        const std::array<Net, 3> nets{chain(n), star, randomTree(random, n + 1, true)};
        for (const Net& net : nets) {
            perLink.push_back(operationsPerLink(net));
            Run<double, Counting> run(net, counted(net));
            Counting::evaluations = Counting::sides = 0;
            run.project();
            CHECK(Counting::evaluations == n);
            CHECK(Counting::sides == 2L * n);  // one round
        }
    }
    const auto [low, high] = std::minmax_element(perLink.begin(), perLink.end());
    note("additions and multiplications a link, least", *low);
    note("additions and multiplications a link, most", *high);
    CHECK(*high <= 1.02 * *low);  // some trees have more roots
}

TEST_CASE("direct: cycles are refused, unless a pin cuts them") {
    Net ring = chain(5);
    ring.w.assign(6, 1);
    ring.link(5, 2, 1);
    ring.link(0, 5, 1);
    using Catch::Matchers::Contains;
    CHECK_THROWS_AS(Run<double>(ring), std::invalid_argument);
    CHECK_THROWS_WITH(Run<double>(ring),
                      Contains("constraint 5 between vertices 5 and 2 closes a cycle"));
    Net twice = chain(2);
    twice.link(2, 1, 1);
    CHECK_THROWS_WITH(Run<double>(twice), Contains("constraint 2 between vertices 2 and 1"));

    Random random(8);
    Net cut = chain(9);
    for (Point& x : cut.x) x += random.point(0.3);
    cut.link(9, 0, 3);  // back to the pin
    Run<double> run(cut);
    Errors errors;
    errors.add(cut, run);
    CHECK(report("ring through a pin: C + J dx + a lambda = 0", errors.residual, 1e-12));
    for (int evaluation = 0; evaluation < 10; ++evaluation) run.project();
    CHECK(report("ring through a pin: max |C| after 10", worst(cut, run.positions()), 1e-12));
}

TEST_CASE("direct: what says nothing new, or contradicts, stays finite") {
    SECTION("a straight chain that just fits between two pins") {
        Net net = chain(20, 1, true);
        for (int i = 1; i < 20; ++i) net.x[i].y = -0.01;  // as gravity would have predicted it
        Run<double> run(net);
        for (int evaluation = 0; evaluation < 40; ++evaluation) run.project();
        CHECK(report("max |C| after 40 (m)", worst(net, run.positions()), 1e-6));
        Net straight = chain(20, 1, true);
        for (int i = 1; i < 20; ++i) straight.x[i].x += i % 2 ? 0.01 : -0.01;
        Run<double> collinear(straight);
        collinear.project();
        CHECK(report("collinear: max |C| after 1 (m)", worst(straight, collinear.positions()),
                     1e-14));
    }
    SECTION("two pins twice as far apart as the chain is long") {
        // In line, all links but one can hold; that one says nothing new and is left alone, also
        // where rounding leaves it a pivot.
        double error = 0, multiplier = 0;
        for (int trial = 0; trial < 50; ++trial) {
            Random random(20 + static_cast<unsigned>(trial));
            Net line = chain(20, 1, true);
            const Point direction = random.point(1);
            for (Point& x : line.x) x = 2 * x.x / length(direction) * direction;
            for (double& w : line.w) w = w > 0 ? random.uniform(0.1, 10) : 0;
            Run<double> taut(line);
            for (int evaluation = 0; evaluation < 10; ++evaluation) taut.project();
            const Eigen::VectorXd gap = Dense(line, taut.positions()).c;
            CHECK((gap.array().abs() < 1e-12).count() == 19);
            error = std::max(error, std::fabs(gap.maxCoeff() - 20));
            multiplier = std::max(multiplier, largest(multipliers(taut)));
        }
        CHECK(report("in line: error of the last link - 20 m", error, 1e-12));
        CHECK(report("in line: largest multiplier (kg m)", multiplier, 1000));
        for (const double off : {0.0, 1e-9, 1e-6, 1e-3, 0.1}) {
            Net net = chain(20, 1, true);
            Random random(9);
            for (Point& x : net.x) x.x *= 2;
            for (int i = 1; i < 20; ++i) net.x[i] += random.point(off);
            Run<double> run(net);
            Run<float> single(net);
            double furthest = 0;
            for (int evaluation = 0; evaluation < 200; ++evaluation) {
                run.project();
                single.project();
                REQUIRE(finite(run.positions()));
                REQUIRE(finite(single.positions()));
                for (const Point& x : run.positions()) furthest = std::max(furthest, length(x));
            }
            char what[80];
            std::snprintf(what, sizeof what, "bent by %.0e m: furthest a vertex went (m)", off);
            CHECK(report(what, furthest, 100));
        }
        // With compliance there is a solution, and the error is shared.
        Net soft = chain(20, 1, true);
        for (Point& x : soft.x) x.x *= 2;
        Random random(10);
        for (int i = 1; i < 20; ++i) soft.x[i] += random.point(0.1);
        for (auto& row : soft.rows.rows) row.compliance = row.compression = 1e-4;
        Run<double> run(soft);
        for (int substep = 0; substep < 400; ++substep) {
            run.set.begin({run.h, 1}, run.workers);
            run.project();
        }
        const Eigen::VectorXd c = Dense(soft, run.positions()).c;
        CHECK(
            report("with compliance: largest - smallest C (m)", c.maxCoeff() - c.minCoeff(), 1e-5));
    }
    SECTION("coincident vertices, two pinned ends, one vertex alone, no link") {
        Net net = chain(4);
        net.x.assign(5, Point{1, 2, 3});
        Run<double> same(net);
        same.project();
        CHECK(finite(same.positions()));
        Net pinned = chain(3);
        pinned.w.assign(4, 0);
        for (auto& row : pinned.rows.rows) row.rest = 2;
        Run<double> still(pinned);
        still.project();
        CHECK(largest(difference(still.positions(), pinned.x)) == 0);
        CHECK(largest(multipliers(still)) == 0);
        Net none;
        none.x = {{0, 0, 0}};
        none.w = {1};
        Run<double> nothing(none);
        nothing.project();
        CHECK(nothing.set.size() == 0);
    }
}

TEST_CASE("direct: links that only pull") {
    // A hanging chain falls for one substep: only its first link is predicted to stretch.
    Net rope = chain(100);
    for (auto& row : rope.rows.rows) row.compression = slack;
    for (int i = 1; i <= 100; ++i) rope.x[i] += Point{1e-4, 0, 0};
    Run<double, Counting> hanging(rope, counted(rope));
    Counting::sides = 0;
    hanging.project();
    CHECK(Counting::sides == 200);
    CHECK(report("hanging chain: max |C| after 1 (m)", worst(rope, hanging.positions()), 1e-13));

    // lambda <= 0, C + J dx <= 0, and one of them zero.
    Random random(11);
    double wrong = 0;
    long rounds = 0, most = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Net net = randomTree(random, 50, trial % 2);
        for (auto& row : net.rows.rows) row.compression = slack;
        Run<double, Counting> run(net, counted(net));
        const Dense d(net, net.x);
        Counting::sides = 0;
        run.project();
        const long these = Counting::sides / net.links() - 1;
        rounds += these;
        most = std::max(most, these);
        const Eigen::VectorXd c = d.c + d.j * difference(run.positions(), net.x);
        for (int i = 0; i < net.links(); ++i) {
            const double lambda = run.set.multiplier(i);
            const double a = net.rows.rows[i].compliance / (run.h * run.h);
            wrong = std::max({wrong, lambda, lambda == 0 ? c(i) : std::fabs(c(i) + a * lambda)});
        }
    }
    note("rounds of the active set, mean", static_cast<double>(rounds) / 200);
    note("rounds of the active set, most (allowed: 16)", static_cast<double>(most));
    CHECK(report("random trees: complementarity", wrong, 1e-12));
}

TEST_CASE("direct: strength, keep and damping") {
    Random random(12);
    const Net net = randomTree(random, 40, true);
    Run<double> whole(net), half(net);
    whole.project();
    half.project(0.5);
    const Eigen::VectorXd all = difference(whole.positions(), net.x);
    CHECK(report("half strength moves half as far",
                 largest(2 * difference(half.positions(), net.x) - all) / largest(all), 1e-13));
    CHECK(report("and gives half the multipliers",
                 largest(2 * multipliers(half) - multipliers(whole)) / largest(multipliers(whole)),
                 1e-13));

    // With keep = 0 an evaluation knows nothing of the one before.
    half.keep = 0;
    Run<double> again(net);
    again.state = half.state;
    half.project();
    again.project();
    CHECK(largest(difference(half.positions(), again.positions())) == 0);

    // Every rate of C loses the same part, whatever the compliance.
    Run<double> damped(net);
    damped.project();
    const std::vector<Point> still = damped.positions();
    Eigen::VectorXd v(3 * net.vertices()), after(v.size());
    for (int i = 0; i < net.vertices(); ++i)
        if (net.w[i] > 0) damped.state.velocity[i].v = random.point(1);
    const auto velocities = [&](Eigen::VectorXd& to) {
        for (int i = 0; i < net.vertices(); ++i) {
            const Point& u = damped.state.velocity[i].v;
            to.segment<3>(3 * i) << u.x, u.y, u.z;
        }
    };
    velocities(v);
    damped.set.damp(damped.sweep(0.3), damped.workers);
    velocities(after);
    const Eigen::VectorXd rate = Dense(net, still).j * v;
    CHECK(report("damping takes 0.3 off every rate of C",
                 largest(Dense(net, still).j * after - 0.7 * rate) / largest(rate), 1e-12));
    CHECK(largest(difference(damped.positions(), still)) == 0);
}

TEST_CASE("direct: rest lengths that move") {
    Net net = chain(10);
    net.rows.animate = [](double t, std::span<Stretch::Row<double>> rows) {
        for (auto& row : rows) row.rest = 1 + t;
    };
    Run<double> run(net);
    run.set.beginFrame(0, 0.2);
    run.set.begin({run.h, 0.25}, run.workers);
    run.project();
    for (auto& row : net.rows.rows) row.rest = 1.05;
    CHECK(report("a quarter into the frame: max |C| (m)", worst(net, run.positions()), 1e-14));
}

TEST_CASE("direct: float, 10 m from the origin") {
    Random random(13);
    Net net = chain(50, 0.1);
    for (Point& x : net.x) x += Point{10, 10, 10};
    for (int i = 1; i <= 50; ++i) net.x[i] += random.point(0.01);
    Run<float> run(net);
    for (int evaluation = 0; evaluation < 6; ++evaluation) run.project();
    CHECK(report("max |C| after 6 (m)", worst(net, run.positions()), 2e-9));
}

TEST_CASE("direct: the same bits for any number of threads", "[threads][determinism]") {
    Random random(14);
    Net net;
    for (int strand = 0; strand < 300; ++strand) {
        const Net tree = randomTree(random, 2 + random.below(20), strand % 2);
        const int first = net.vertices();
        net.x.insert(net.x.end(), tree.x.begin(), tree.x.end());
        net.w.insert(net.w.end(), tree.w.begin(), tree.w.end());
        for (int i = 0; i < tree.links(); ++i) {
            net.rows.ids.push_back(first + tree.rows.ids[2 * i]);
            // Every strand also hangs on the same pinned vertex.
            net.rows.ids.push_back(first + tree.rows.ids[2 * i + 1]);
            net.rows.rows.push_back(tree.rows.rows[i]);
        }
        net.w[0] = 0;
        if (first > 0) net.link(0, first, 1);
    }
    Run<float> one(net);
    for (int evaluation = 0; evaluation < 3; ++evaluation) one.project();
    REQUIRE(finite(one.positions()));
    for (const int threads : {2, 3, 8}) {
        Run<float> many(net);
        Workers workers(threads);
        for (int evaluation = 0; evaluation < 3; ++evaluation)
            many.set.project(many.sweep(), Direction::backward, workers);
        CHECK(largest(difference(one.positions(), many.positions())) == 0);
        CHECK(largest(multipliers(one) - multipliers(many)) == 0);
    }
}

TEST_CASE("direct: asked for by an option of the set") {
    World world;
    world.start = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    world.mass = {1, 1, 1};
    world.pinned = {0, 0, 0};
    Rows<Stretch> rows{{0, 1, 1, 2}, {{1, 0, 0}, {1, 0, 0}}, {}, {}};
    world.constrain(rows, {.name = "chain", .direct = true});
    world.constrain(rows, {.name = "swept"});
    const auto made = [&](std::size_t i) {
        return world.sets[i].recipe.full(world, bestKernels());
    };
    CHECK(dynamic_cast<DirectSet<Stretch, double>*>(made(0).get()));
    CHECK_FALSE(dynamic_cast<DirectSet<Stretch, double>*>(made(1).get()));
    CHECK_THROWS_AS(world.constrain(Rows<Angle>{}, {.name = "bend", .direct = true}),
                    std::invalid_argument);
    rows.ids.insert(rows.ids.end(), {2, 0});
    rows.rows.push_back({1, 0, 0});
    world.constrain(rows, {.name = "ring", .direct = true});
    CHECK_THROWS_AS(made(2), std::invalid_argument);  // pins are known only when a solver is made
    world.pin({1});
    CHECK_NOTHROW(made(2));
}
