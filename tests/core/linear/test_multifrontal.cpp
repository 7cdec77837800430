// Multifrontal Cholesky against Eigen's sparse factors in double, its guard, and its bits.
#include "block_check.h"
#include "tests/catch.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <limits>
#include <memory>
#include <numeric>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

void checkAgainstEigen(const std::string& name, const System& system, int leaf = 16) {
    checkAgainst<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>>(name, system, leaf);
}

bool same(const Vectors& a, const Vectors& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

}  // namespace

TEST_CASE("multifrontal: solves what Eigen solves", "[multifrontal]") {
    for (const double mass : {1.0, 1e-3}) {
        const std::string heavy = mass < 1 ? "light " : "heavy ";
        checkAgainstEigen(heavy + "grid", sheet(33, 21).fill(1, mass));
        checkAgainstEigen(heavy + "irregular mesh", irregular(40, 31, 2).fill(2, mass));
        checkAgainstEigen(heavy + "strip 1:50", sheet(5, 201, 0.02, 1).fill(3, mass));
        checkAgainstEigen(heavy + "chain", chain(300).fill(4, mass));
        checkAgainstEigen(heavy + "tangle with loops", tangle(150, 400, 5).fill(5, mass));
        checkAgainstEigen(
            heavy + "pieces and single vertices",
            together({chain(20), sheet(9, 14), tangle(40, 0, 6), irregular(20, 20, 6)})
                .fill(6, mass));
    }
    checkAgainstEigen("one vertex", chain(1).fill(7, 1));
    CHECK(solved(System({}, {})).x.empty());
}

// 31/4 N log2 n numbers for the N = n^2 vertices of a grid (George and Liu, "Computer Solution of
// Large Sparse Positive Definite Systems", 1981), here 3 x 3 each, however they are numbered.
TEST_CASE("multifrontal: fills in what nested dissection does", "[multifrontal]") {
    for (const int n : {32, 64, 128}) {
        const System ordered = sheet(n, n);
        std::vector<int> place(ordered.rest.size());
        std::iota(place.begin(), place.end(), 0);
        Random random(1);
        for (int v = n * n; v-- > 1;) std::swap(place[v], place[random.below(v + 1)]);
        System shuffled = ordered;
        for (int v = 0; v < n * n; ++v) shuffled.rest[place[v]] = ordered.rest[v];
        for (int& v : shuffled.edges) v = place[v];
        const double theory = 31 / 4.0 * n * n * std::log2(n) * 9;
        for (const System& system : {ordered, shuffled}) {
            const Multifrontal factors(system.rest, system.edges, system.pinned);
            CHECK(report("numbers in the factor, of theory's, " + std::to_string(n),
                         static_cast<double>(factors.size()) / theory, 1));
        }
    }
}

TEST_CASE("multifrontal: leaves of any size, points in one place, pins", "[multifrontal]") {
    for (const int leaf : {1, 5, 1000})
        checkAgainstEigen("leaf " + std::to_string(leaf), irregular(20, 15, 1).fill(1, 0.1), leaf);
    System folded = irregular(20, 15, 2);
    folded.rest.assign(folded.rest.size(), {1, 2, 3});
    checkAgainstEigen("folded to a point", folded.fill(2, 0.1));
    System pinned = irregular(20, 15, 3).fill(3, 0);
    for (int v = 0; v < 300; v += 7) pinned.pinned[v] = 1;
    checkAgainstEigen("pinned", pinned);
    pinned.pinned.assign(pinned.rest.size(), 1);
    for (const Vec<float>& x : solved(pinned).x) CHECK(x == Vec<float>{0, 0, 0});
}

TEST_CASE("multifrontal: edges given twice add up", "[multifrontal]") {
    System system = irregular(12, 9, 1);
    const std::vector<int> once = system.edges;
    system.edges.insert(system.edges.end(), once.rbegin(), once.rend());
    checkAgainstEigen("every edge twice", system.fill(1, 0.1));
}

// Through the middle, so that two pieces are left, and here and there.
TEST_CASE("multifrontal: a link that is cut is a block of zeros", "[multifrontal]") {
    System system = irregular(20, 15, 1).fill(1, 0.1);
    Multifrontal factors(system.rest, system.edges, system.pinned);
    Workers one(1);
    factors.factor(system.vertexBlocks, system.edgeBlocks, one);
    System left = system;
    left.edges.clear(), left.edgeBlocks.clear();
    for (std::size_t e = 0; e < system.edgeBlocks.size(); ++e) {
        const int a = system.edges[2 * e], b = system.edges[2 * e + 1];
        if ((a < 150) != (b < 150) || e % 17 == 0) {
            system.edgeBlocks[e] = {0, 0, 0, 0, 0, 0};
        } else {
            left.edges.insert(left.edges.end(), {a, b});
            left.edgeBlocks.push_back(system.edgeBlocks[e]);
        }
    }
    checkAgainstEigen("cut", system);
    const Factored factored = factors.factor(system.vertexBlocks, system.edgeBlocks, one);
    CHECK((factored.finite && factored.frozen == 0));
    Vectors x = system.b;
    factors.solve(x, one);
    CHECK(same(x, solved(system).x));
    const Vectors expected = solved(left).x;
    float apart = 0, size = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
        apart = std::max(apart, length(x[v] - expected[v]));
        size = std::max(size, length(x[v]));
    }
    CHECK(report("cut, and never there", apart / size, 1e-4));
}

TEST_CASE("multifrontal: the same bits from all threads and kernels", "[multifrontal][threads]") {
    System large = sheet(64, 64).fill(1, 1e-3);
    large.pinned[0] = large.pinned[63] = 1;
    for (const System& system :
         {large, irregular(40, 31, 2).fill(2, 1e-3), chain(300).fill(3, 1)}) {
        const Vectors expected = solved(system, 1, {.kernels = {Isa::v2, 4}}).x;
        for (const Isa isa : {Isa::v2, Isa::v3, Isa::v4})
            for (const int threads : {1, 2, 3, 8}) {
                if (!available({isa, 4})) continue;
                INFO("v" << static_cast<int>(isa) + 2 << ", " << threads << " threads");
                CHECK(same(solved(system, threads, {.kernels = {isa, 4}}).x, expected));
            }
    }
}

TEST_CASE("multifrontal: the same bits where threads share a front", "[multifrontal][threads]") {
    const System system = sheet(128, 128).fill(1, 1e-3);
    const Vectors expected = solved(system).x;
    for (const int threads : {2, 3, 8}) CHECK(same(solved(system, threads).x, expected));
}

TEST_CASE("multifrontal: a second factorisation forgets the first", "[multifrontal]") {
    System system = irregular(20, 15, 1).fill(1, 0.1), other = system;
    for (Symmetric<float>& h : other.edgeBlocks) h = {3, 0, 0, 2, 0, 1};
    Multifrontal factors(system.rest, system.edges, system.pinned);
    Workers one(1), three(3);
    factors.factor(other.vertexBlocks, other.edgeBlocks, one);
    factors.factor(system.vertexBlocks, system.edgeBlocks, three);
    for (int again = 0; again < 2; ++again) {
        Vectors x = system.b;
        factors.solve(x, one);
        CHECK(same(x, solved(system).x));
    }
    Vectors x = system.b;
    CHECK(factors.factorAndSolve(system.vertexBlocks, system.edgeBlocks, x, three).finite);
    CHECK(same(x, solved(system).x));
}

TEST_CASE("multifrontal: a pivot that rounding has eaten freezes its component", "[multifrontal]") {
    // Two vertices on a spring: what holds them both is the second pivot, and that is 0, or less
    // than the diagonal knows, or what is left because rounding takes k (1 / k) for less than 1.
    float k = 2;
    while (k * (1 / k) >= 1) ++k;
    struct Case {
        float stiffness, mass;
    };
    for (const auto [stiffness, mass] : {Case{1, 0}, Case{1, 0x1p-26F}, Case{k, 0}}) {
        System pair = chain(2);
        pair.edgeBlocks = {{stiffness, 0, 0, stiffness, 0, stiffness}};
        pair.vertexBlocks = {{0, 0, 0, 0, 0, 0}, {mass, 0, 0, mass, 0, mass}};
        pair.b = {{stiffness, 0, 0}, {4, 5, 6}};
        const Solved found = solved(pair);
        CHECK(found.factored.finite);
        CHECK(found.factored.frozen == 3);
        CHECK(found.x[0].x == Approx(1));
        CHECK(found.x[1] == Vec<float>{0, 0, 0});
    }
    // One component less than nothing, the others as if it were not there.
    System sheets = sheet(30, 20).fill(1, 0.1), without = sheets;
    sheets.vertexBlocks[100].yy = -1e4;
    without.vertexBlocks[100].yy = 1e10;
    const Solved found = solved(sheets), expected = solved(without);
    CHECK(found.factored.frozen == 1);
    CHECK(found.x[100].y == 0);
    double error = 0, size = 0;
    for (std::size_t v = 0; v < found.x.size(); ++v) {
        error = std::max(error, double(length(found.x[v] - expected.x[v])));
        size = std::max(size, double(length(expected.x[v])));
    }
    CHECK(report("frozen against held fast", error / size, 1e-5));
}

TEST_CASE("multifrontal: what is no number is told", "[multifrontal]") {
    const System good = sheet(30, 20).fill(1, 0.1);
    Multifrontal factors(good.rest, good.edges, good.pinned);
    Workers workers(2);
    Vectors x = good.b;
    const auto allZero = [&] {
        factors.solve(x, workers);
        return same(x, Vectors(x.size(), {0, 0, 0}));
    };
    CHECK(allZero());
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity()})
        for (const bool vertex : {false, true}) {
            System system = good;
            (vertex ? system.vertexBlocks[77] : system.edgeBlocks[77]).yz = bad;
            CHECK(!factors.factor(system.vertexBlocks, system.edgeBlocks, workers).finite);
            x = good.b;
            CHECK(allZero());
        }
    CHECK(factors.factor(good.vertexBlocks, good.edgeBlocks, workers).finite);
    x = good.b;
    factors.solve(x, workers);
    CHECK(same(x, solved(good).x));
}

TEST_CASE("multifrontal: refuses what does not fit", "[multifrontal]") {
    System system = chain(3).fill(1, 1);
    Workers workers(1);
    Multifrontal factors(system.rest, system.edges, system.pinned);
    system.b.pop_back(), system.edgeBlocks.pop_back();
    CHECK_THROWS_AS(factors.solve(system.b, workers), std::invalid_argument);
    CHECK_THROWS_AS(factors.factor(system.vertexBlocks, system.edgeBlocks, workers),
                    std::invalid_argument);
    const auto analysed = [&] { return Multifrontal(system.rest, system.edges, system.pinned); };
    system.edges = {0, 3};
    CHECK_THROWS_AS(analysed(), std::invalid_argument);
    system.edges = {0};
    CHECK_THROWS_AS(analysed(), std::invalid_argument);
    system.edges = {};
    system.rest[1].y = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(analysed(), std::invalid_argument);
}

namespace {

// ms, median of seven.
template <class Body>
double timeOf(const Body& body) {
    std::vector<double> times;
    for (int run = 0; run < 7; ++run) {
        const auto start = std::chrono::steady_clock::now();
        body();
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - start;
        times.push_back(time.count());
    }
    std::nth_element(times.begin(), times.begin() + 3, times.end());
    return times[3];
}

}  // namespace

TEST_CASE("multifrontal: what a factorisation costs", "[.bench]") {
    for (const int n : {64, 128, 256, 512})
        for (const bool regular : {true, false}) {
            const System system = (regular ? sheet(n, n) : irregular(n, n, 1)).fill(1, 1e-3);
            const auto analysed = [&] {
                return std::make_unique<Multifrontal>(system.rest, system.edges, system.pinned);
            };
            const std::unique_ptr<Multifrontal> factors = analysed();
            std::printf("    %3d x %3d, %s: %.1f M numbers, analysis %.1f ms\n", n, n,
                        regular ? "regular" : "irregular",
                        1e-6 * static_cast<double>(factors->size()), timeOf(analysed));
            for (const int threads : {1, 2}) {
                Workers workers(threads);
                Vectors x;
                const auto factor = [&] {
                    factors->factor(system.vertexBlocks, system.edgeBlocks, workers);
                };
                const auto solve = [&] {
                    x = system.b;
                    factors->solve(x, workers);
                };
                const auto both = [&] {
                    x = system.b;
                    factors->factorAndSolve(system.vertexBlocks, system.edgeBlocks, x, workers);
                };
                std::printf("    threads: %d, factor %6.2f ms, solve %5.2f ms, both %6.2f ms\n",
                            threads, timeOf(factor), timeOf(solve), timeOf(both));
                CHECK(same(x, solved(system).x));
            }
        }
}
