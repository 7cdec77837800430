// Smoothed aggregation against the multifrontal factor, its parts against what they stand for, and
// its bits.
#include "block_check.h"
#include "tests/catch.h"

#include <plait/linear/multigrid/levels.h>
#include <plait/linear/smoothed_aggregation.h>

#include <chrono>
#include <cstring>
#include <limits>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

// Rigid links along the mesh: `ratio` times as stiff as vertices are heavy, and `across` of that
// where they are turned. The right-hand side has every wavelength.
System rigidLinks(System system, float ratio, float across, std::uint64_t seed) {
    system.fill(seed, 1);
    for (Symmetric<float>& m : system.vertexBlocks) m = Symmetric<float>::diagonal(1);
    for (std::size_t e = 0; e < system.edgeBlocks.size(); ++e) {
        const Vec<double> d =
            system.rest[system.edges[2 * e + 1]] - system.rest[system.edges[2 * e]];
        const double l = length(d);
        system.edgeBlocks[e] = Symmetric<float>::diagonal(ratio * across);
        system.edgeBlocks[e].addOuter(ratio * (1 - across),
                                      {static_cast<float>(d.x / l), static_cast<float>(d.y / l),
                                       static_cast<float>(d.z / l)});
    }
    return system;
}

System bumpy(System system) {
    for (Vec<double>& x : system.rest) x.z += 0.2 * x.x * x.x - 0.3 * x.x * x.y;
    return system;
}

System round(int rings) {
    const Shape shape = disc({.rings = rings});
    return {shape.positions, edgesOf(shape)};
}

System hung(int side) {
    System system = rigidLinks(bumpy(sheet(side, side)), 5e5F, 0.01F, 1);
    system.pinned[0] = system.pinned[side - 1] = 1;
    return system;
}

Vectors cycled(const System& system, int iterations, int threads = 1) {
    SmoothedAggregation cycles(system.edges, system.pinned);
    Workers workers(threads);
    cycles.setUp(system.vertexBlocks, system.edgeBlocks, system.rest, workers);
    Vectors x = system.b;
    cycles.solve(x, iterations, workers);
    return x;
}

double median(std::vector<double> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return numbers[numbers.size() / 2];
}

double difference(const Vectors& a, const Vectors& b) {
    double error = 0, size = 0;
    for (std::size_t v = 0; v < a.size(); ++v) {
        const Vec<float> d = a[v] - b[v];
        error += double(dot(d, d));
        size += double(dot(b[v], b[v]));
    }
    return std::sqrt(error / size);
}

// A mesh without pins as rows, and its bodies.
struct Parts {
    BlockRows<3> a;
    Aggregates aggregates;
    std::unique_ptr<CoarseLevels> coarse;
    std::unique_ptr<Prolongator<3>> passage;
    Workers one{1};

    explicit Parts(const System& system) {
        std::vector<std::vector<int>> lists(system.rest.size());
        for (std::size_t e = 0; e < system.edgeBlocks.size(); ++e)
            for (const int end : {0, 1})
                lists[system.edges[2 * e + end]].push_back(system.edges[2 * e + 1 - end]);
        for (auto& list : lists) appendSorted(a.columns, list);
        a.layOut();
        for (std::size_t v = 0; v < lists.size(); ++v) {
            a.own.push_back(full(system.vertexBlocks[v], 1));
            a.diagonal[v] = a.own[v];
        }
        for (std::size_t e = 0; e < system.edgeBlocks.size(); ++e) add(system, static_cast<int>(e));
        a.invert(one);
        aggregates = mergeNeighbours(a.columns);
        coarse = std::make_unique<CoarseLevels>(quotient(a.columns, aggregates));
        passage = std::make_unique<Prolongator<3>>(a, aggregates, coarse->finest());
        coarse->layOut();
        coarse->place(*passage, system.rest);
        passage->smooth(a, one);
        passage->project(a, coarse->finest(), one);
    }

    static Block<3> full(const Symmetric<float>& h, float sign) {
        Block<3> b{};
        for (int c = 0; c < 3; ++c) {
            const Vec<float> column =
                h * Vec<float>{static_cast<float>(c == 0), static_cast<float>(c == 1),
                               static_cast<float>(c == 2)};
            b.column[c].pack[0] =
                Pack<4>(Pack<4>::V{sign * column.x, sign * column.y, sign * column.z, 0});
        }
        return b;
    }
    void add(const System& system, int e) {
        const int ends[] = {system.edges[2 * e], system.edges[2 * e + 1]};
        const Block<3> h = full(system.edgeBlocks[e], 1), off = full(system.edgeBlocks[e], -1);
        for (const int n : {0, 1}) {
            for (int c = 0; c < 3; ++c)
                a.diagonal[ends[n]].column[c] = a.diagonal[ends[n]].column[c] + h.column[c];
            for (int k = a.columns.start[ends[n]]; k < a.columns.start[ends[n] + 1]; ++k)
                if (a.columns.item[k] == ends[1 - n]) a.off[k] = off;
        }
    }
};

template <int size>
double product(const BlockRows<size>& a, const std::vector<Record<size>>& x) {
    double sum = 0;
    for (int i = 0; i < a.count(); ++i) {
        const Record<size> y = a.row(i, x);
        for (int k = 0; k < size; ++k) sum += double(y[k]) * double(x[i][k]);
    }
    return sum;
}

}  // namespace

TEST_CASE("smoothed aggregation: solves what a factor solves", "[multigrid]") {
    const auto check = [](const std::string& name, const System& system) {
        CHECK(report(name + ", error", difference(cycled(system, 60), solved(system).x), 1e-4));
    };
    check("grid", sheet(33, 21).fill(1, 0.1));
    check("irregular mesh", irregular(40, 31, 2).fill(2, 0.1));
    check("bent disc", rigidLinks(bumpy(round(20)), 1e3F, 0.05F, 3));
    check("chain", chain(300).fill(4, 1));
    check("tangle with loops", tangle(150, 400, 5).fill(5, 1));
    check("pieces and single vertices",
          together({chain(20), sheet(9, 14), tangle(40, 0, 6), irregular(20, 20, 6)}).fill(6, 0.1));
    System pinned = irregular(20, 15, 3).fill(3, 0.1);
    for (int v = 0; v < 300; v += 7) pinned.pinned[v] = 1;
    const std::vector<int> once = pinned.edges;
    check("pins", pinned);
    pinned.edges.insert(pinned.edges.end(), once.begin(), once.end());
    pinned.edgeBlocks.insert(pinned.edgeBlocks.end(), pinned.edgeBlocks.begin(),
                             pinned.edgeBlocks.end());
    check("every edge twice", pinned);
    pinned.pinned.assign(pinned.rest.size(), 1);
    for (const Vec<float>& x : cycled(pinned, 5)) CHECK(x == Vec<float>{0, 0, 0});
}

TEST_CASE("smoothed aggregation: the coarse matrix is P^T A P", "[multigrid]") {
    for (const System& system :
         {irregular(40, 31, 2).fill(2, 0.1), rigidLinks(bumpy(round(12)), 100, 0.1F, 3)}) {
        Parts parts(system);
        Random random(1);
        const BlockRows<6>& coarse = parts.coarse->finest();
        std::vector<Record<6>> e(static_cast<std::size_t>(coarse.count()), Record<6>(0));
        for (Record<6>& numbers : e)
            for (int k = 0; k < 6; ++k) numbers.set(k, static_cast<float>(random.uniform(-1, 1)));
        std::vector<Record<3>> x(system.rest.size(), Record<3>(0));
        parts.passage->prolong(e, x, parts.one);
        const double fine = product(parts.a, x);
        CHECK(report("energy of a coarse vector", std::fabs(product(coarse, e) / fine - 1), 1e-5));
    }
}

// Links without anything across allow every rigid motion: it is smoothed into itself. Where a mesh
// is as rough as its links are long, each vertex is held in all directions.
TEST_CASE("smoothed aggregation: bodies move as the sheet does", "[multigrid]") {
    System system = irregular(30, 30, 4);
    Random random(1);
    for (Vec<double>& x : system.rest) x.z = random.uniform(-0.03, 0.03);
    system = rigidLinks(system, 1, 0, 4);
    for (Symmetric<float>& m : system.vertexBlocks) m = {};
    Parts parts(system);
    const Vec<double> t{1, 2, 3}, w{-1, 0.5, 2};
    std::vector<Vec<double>> centre(static_cast<std::size_t>(parts.aggregates.count), {0, 0, 0});
    std::vector<double> count(centre.size()), radius(centre.size());
    const std::vector<int>& of = parts.aggregates.of;
    for (std::size_t v = 0; v < of.size(); ++v) centre[of[v]] += system.rest[v], ++count[of[v]];
    for (std::size_t n = 0; n < centre.size(); ++n) centre[n] = (1 / count[n]) * centre[n];
    for (std::size_t v = 0; v < of.size(); ++v) {
        const Vec<double> d = system.rest[v] - centre[of[v]];
        radius[of[v]] += dot(d, d) / count[of[v]];
    }
    std::vector<Record<6>> e;
    for (std::size_t n = 0; n < centre.size(); ++n) {
        const Vec<double> moved = t + cross(w, centre[n]), turned = std::sqrt(radius[n]) * w;
        const double numbers[] = {moved.x, moved.y, moved.z, turned.x, turned.y, turned.z};
        e.emplace_back(0.0F);
        for (int k = 0; k < 6; ++k) e.back().set(k, static_cast<float>(numbers[k]));
    }
    std::vector<Record<3>> x(system.rest.size(), Record<3>(0));
    parts.passage->prolong(e, x, parts.one);
    double error = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
        const Vec<double> expected = t + cross(w, system.rest[v]);
        const Vec<double> d{double(x[v][0]) - expected.x, double(x[v][1]) - expected.y,
                            double(x[v][2]) - expected.z};
        error = std::max(error, length(d) / length(expected));
    }
    CHECK(report("a rigid motion, worst vertex", error, 1e-5));
}

// As stiff as `global` makes links: with sums of stiffnesses in place of differences of vectors it
// is off by 1e-3.
TEST_CASE("smoothed aggregation: does not lose the mass of a free sheet", "[multigrid]") {
    System system = rigidLinks(bumpy(sheet(40, 40)), 5e5F, 0.01F, 1);
    system.b.assign(system.b.size(), {1, -2, 3});
    CHECK(report("pushed all over", difference(cycled(system, 6), system.b), 1e-4));
}

TEST_CASE("smoothed aggregation: no more cycles where a sheet is finer", "[multigrid]") {
    for (const int side : {32, 64, 128}) {
        const System system = hung(side);
        SmoothedAggregation cycles(system.edges, system.pinned);
        Workers one(1);
        cycles.setUp(system.vertexBlocks, system.edgeBlocks, system.rest, one);
        Vectors x = system.b;
        CHECK(report("residual after 6 cycles, " + std::to_string(side), cycles.solve(x, 7, one),
                     3e-4));
    }
}

TEST_CASE("smoothed aggregation: the same bits from all threads", "[multigrid][threads]") {
    for (const System& system : {hung(80), irregular(70, 70, 2).fill(2, 0.1)}) {
        const Vectors expected = cycled(system, 6);
        for (const int threads : {2, 3, 8}) {
            const Vectors found = cycled(system, 6, threads);
            CHECK(std::memcmp(found.data(), expected.data(), found.size() * sizeof found[0]) == 0);
        }
    }
}

TEST_CASE("smoothed aggregation: numbers that are none are told", "[multigrid]") {
    System system = sheet(9, 9).fill(1, 1);
    system.edgeBlocks[7].xx = std::numeric_limits<float>::quiet_NaN();
    SmoothedAggregation cycles(system.edges, system.pinned);
    Workers one(1);
    cycles.setUp(system.vertexBlocks, system.edgeBlocks, system.rest, one);
    Vectors x = system.b;
    CHECK(cycles.solve(x, 6, one) == 1);
    for (const Vec<float>& step : x) CHECK(step == Vec<float>{0, 0, 0});
    CHECK_THROWS_AS(SmoothedAggregation(std::vector<int>{0, 5}, std::vector<unsigned char>(3)),
                    std::invalid_argument);
}

// In turns, so that what else the machine does slows both.
TEST_CASE("smoothed aggregation: what it costs beside a factorisation", "[.bench]") {
    using Clock = std::chrono::steady_clock;
    const auto timeOf = [](std::vector<double>& times, const auto& run) {
        const auto start = Clock::now();
        run();
        times.push_back(1000 * std::chrono::duration<double>(Clock::now() - start).count());
    };
    for (const int n : {128, 256, 384, 512}) {
        const System system = hung(n);
        std::unique_ptr<Multifrontal> factors;
        std::unique_ptr<SmoothedAggregation> cycles;
        for (const int threads : {1, 2}) {
            Workers workers(threads);
            std::vector<double> analysis, layOut, factor, again, setUp, solve;
            for (int turn = 0; turn < 5; ++turn) {
                Vectors x = system.b, y = system.b;
                if (turn == 0) {
                    timeOf(analysis, [&] {
                        factors = std::make_unique<Multifrontal>(system.rest, system.edges,
                                                                 system.pinned);
                    });
                    timeOf(layOut, [&] {
                        cycles = std::make_unique<SmoothedAggregation>(system.edges, system.pinned);
                    });
                }
                timeOf(factor, [&] {
                    factors->factorAndSolve(system.vertexBlocks, system.edgeBlocks, x, workers);
                });
                timeOf(again, [&] { factors->solve(x, workers); });
                timeOf(setUp, [&] {
                    cycles->setUp(system.vertexBlocks, system.edgeBlocks, system.rest, workers);
                });
                timeOf(solve, [&] { cycles->solve(y, 4, workers); });
            }
            std::printf(
                "    %3d x %3d, %d threads: analysis %5.0f ms, factor and solve %6.1f, solve "
                "%5.1f; levels %5.0f ms, set-up %6.1f, cycle %5.1f\n",
                n, n, threads, analysis[0], median(factor), median(again), layOut[0], median(setUp),
                median(solve) / 4);
        }
    }
}
