// What methods other than sweeps are made of: C, gradient and second derivatives of a whole set.
// Every kind of constraints/kinds.h goes through it, without a line of its own.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/numbers/finite.h>
#include <plait/sets/constraint_set.h>
#include <plait/sets/direct_set.h>
#include <plait/sheets/strands/strand_set.h>

#include <cmath>
#include <tuple>

using namespace plait;
using namespace plait::test;

namespace {

template <class... Kind>
std::tuple<Kind...> asTuple(KindList<Kind...>);
using AllKinds = decltype(asTuple(Kinds{}));

// Constraints on vertices of their own, moved off their rest shapes, none of which is a sliver.
template <class Kind, class Real>
struct Apart {
    Rows<Kind> rows;
    State<Real> state;

    Apart(Random& random, int count) {
        while (rows.size() < count) {
            Stencil<Vec<double>, Kind::arity> x, g;
            for (auto& p : x) p = random.point(1);
            auto local = x;
            for (auto& p : local) p = p - x[0];
            const auto row = Kind::rest(x);
            Kind::evaluate(row, local, g);
            double largest = 0;
            for (const auto& v : g) largest = std::max(largest, length(v));
            if (Kind::arity > 1 && largest > 4) continue;
            rows.rows.push_back(row);
            for (auto& p : x) add(p + random.point(0.1));
        }
        state.particles.push_back({});
    }

    void add(const Vec<double>& x) {
        rows.ids.push_back(static_cast<int>(state.particles.size()));
        state.particles.push_back({{Real(x.x), Real(x.y), Real(x.z)}, 1, {0, Real(0.01), 0}, 0});
    }
    ConstraintSet<Kind, Real> set() const {
        return {rows, static_cast<int>(state.particles.size()) - 1, bestKernels()};
    }
};

double& coordinate(Vec<double>& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

template <class Real>
std::vector<double> gradients(const Terms<Real>& terms) {
    std::vector<double> numbers;
    for (const Vec<Real>& g : terms.gradient)
        numbers.insert(numbers.end(), {double(g.x), double(g.y), double(g.z)});
    return numbers;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("terms: second derivatives are those of the gradient", "[terms]",
                        AllKinds) {
    constexpr int arity = TestType::arity, numbers = 3 * arity;
    Random random(11);
    Apart<TestType, double> sample(random, 60);
    const auto set = sample.set();
    Terms<double> terms, shifted;
    REQUIRE(set.terms(sample.state, true, terms));
    double worst = 0, lopsided = 0;
    for (int n = 0; n < numbers; ++n) {
        // Four values, so that what is left is of fourth order in the step.
        constexpr double step = 1e-4;
        std::vector<double> slope(terms.gradient.size() * 3, 0);
        for (const auto& [at, weight] :
             {std::pair{1.0, 8 / 12.0}, {-1.0, -8 / 12.0}, {2.0, -1 / 12.0}, {-2.0, 1 / 12.0}}) {
            State<double> moved = sample.state;
            for (int i = 0; i < sample.rows.size(); ++i)
                coordinate(moved.particles[sample.rows.ids[arity * i + n / 3]].d, n % 3) +=
                    at * step;
            set.terms(moved, false, shifted);
            const auto g = gradients(shifted);
            for (std::size_t k = 0; k < g.size(); ++k) slope[k] += weight / step * g[k];
        }
        for (int i = 0; i < sample.rows.size(); ++i)
            for (int k = 0; k < numbers; ++k) {
                const double* const c = &terms.curvature[numbers * numbers * i];
                REQUIRE(std::isfinite(c[numbers * n + k]));
                worst = std::max(worst, std::fabs(c[numbers * n + k] - slope[numbers * i + k]));
                lopsided = std::max(lopsided, std::fabs(c[numbers * n + k] - c[numbers * k + n]));
            }
    }
    // What is left are seventh derivatives of C, largest close to an attachment, times step^4 / 30.
    CHECK(report("second derivatives, arity " + std::to_string(arity), worst, 1e-8));
    CHECK(report("their asymmetry", lopsided, 1e-11));
}

TEMPLATE_LIST_TEST_CASE("terms: some of a set are what they are in all of it", "[terms]",
                        AllKinds) {
    Random random(12);
    Apart<TestType, double> sample(random, 20);
    const auto set = sample.set();
    Terms<double> all, some;
    set.terms(sample.state, true, all);
    const std::vector<int> which{17, 3, 4};
    set.termsOf(which, sample.state, true, some);
    REQUIRE(some.size() == 3);
    constexpr int arity = TestType::arity;
    for (int n = 0; n < 3; ++n) {
        CHECK(some.value[n] == all.value[which[n]]);
        CHECK(some.above[n] == all.above[which[n]]);
        CHECK(some.below[n] == all.below[which[n]]);
        for (int a = 0; a < arity; ++a) {
            CHECK(some.ids[arity * n + a] == all.ids[arity * which[n] + a]);
            CHECK(some.gradient[arity * n + a] == all.gradient[arity * which[n] + a]);
            CHECK(some.block(n, a, 0)[0] == all.block(which[n], a, 0)[0]);
        }
        const auto& row = sample.rows.rows[static_cast<std::size_t>(which[n])];
        CHECK(some.compliance(n) == TestType::compliance(row, some.value[n]));
        CHECK(some.compliance(n, -1) == TestType::compliance(row, -1.0));
    }
}

TEMPLATE_LIST_TEST_CASE("terms: degenerate input stays finite", "[terms]", AllKinds) {
    const auto check = []<class Real>(Real) {
        Random random(13);
        for (const double size : {0.0, 1e-6, 1.0, 1e6}) {
            Apart<TestType, Real> sample(random, 30);
            for (auto& p : sample.state.particles) {
                const int corner = random.below(3);
                p.x = {Real(size * (corner == 1)), Real(size * (corner == 2)), 0};
                p.d = {};
            }
            Terms<Real> terms;
            sample.set().terms(sample.state, true, terms);
            INFO("size " << size);
            for (const Vec<Real>& g : terms.gradient) REQUIRE(isFinite(g));
            for (const Real c : terms.curvature) REQUIRE(std::isfinite(c));
        }
    };
    check(0.0F);
    check(0.0);
}

TEMPLATE_TEST_CASE("terms: links give the same whoever solves them", "[terms]", float, double) {
    World world = loosePoints({{0, 0, 0}, {1, 0.1, 0}, {1.9, 0, 0.3}, {3, -0.2, 0}, {4, 0, 0}});
    Rows<Stretch> links{{0, 1, 1, 2, 2, 3, 3, 4}, {}, {}, {}};
    for (int i = 0; i < 4; ++i) links.rows.push_back({1.0 + 0.1 * i, 1e-3 * i, 1e-3 * i});
    world.constrain(links, {.name = "coloured"});
    world.constrain(links, {.name = "direct", .direct = true});
    strand(world, links, {.name = "strands"});
    const Solver<TestType> solver(world, {});
    Terms<TestType> terms[3];
    for (int s = 0; s < 3; ++s) REQUIRE(solver.set(s).terms(solver.state(), true, terms[s]));
    REQUIRE(terms[0].size() == 4);
    REQUIRE(terms[0].value[0] == Approx(std::sqrt(1.01) - 1));
    for (int s = 1; s < 3; ++s) {
        CHECK(terms[s].ids == terms[0].ids);
        CHECK(terms[s].value == terms[0].value);
        CHECK(terms[s].above == terms[0].above);
        CHECK(terms[s].below == terms[0].below);
        CHECK(terms[s].gradient == terms[0].gradient);
        CHECK(terms[s].curvature == terms[0].curvature);
    }
}

TEST_CASE("terms: the slope of atan2, all round", "[terms]") {
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        const double angle = -3.1 + 6.2 * i / 1000, r = 0.5 + 0.002 * i, turn = 0.3, grow = 0.7;
        const double x = r * std::cos(angle), y = r * std::sin(angle);
        const Dual<double> a = arctangent2(Dual<double>(y, turn * x + grow * y),
                                           Dual<double>(x, -turn * y + grow * x));
        CHECK(a.value == arctangent2(y, x));
        worst = std::max(worst, std::fabs(a.slope - turn));
    }
    CHECK(report("slope of atan2 along a spiral", worst, 1e-15));
}
