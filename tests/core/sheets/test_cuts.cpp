// Sheets whose edges are cut one after another: what holds them is found again where the cut has
// changed it, and stays as it was elsewhere.
#include "cut_sheets.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

using namespace plait;
using namespace plait::test;

namespace {

// By anchor and vertex, m.
std::map<std::pair<int, int>, double> lengthsOf(const Tethers& tethers) {
    std::map<std::pair<int, int>, double> lengths;
    for (std::size_t i = 0; i < tethers.anchors.size(); ++i)
        lengths[{tethers.anchors[i], tethers.set.ids[i]}] = tethers.set.rows[i].length;
    return lengths;
}

// How much longer tethers are after cuts than those of a mesh without these edges from the start.
struct Excess {
    double least = 0, most = 0;
};

Excess excessAfter(const Shape& shape, const std::vector<int>& anchors,
                   const std::vector<std::vector<int>>& cuts) {
    const Range all{0, static_cast<int>(shape.positions.size())};
    TetherPlan plan(shape.complex, all, shape.positions, anchors);
    Excess excess;
    std::vector<int> cut;
    for (const std::vector<int>& edges : cuts) {
        plan.cut(edges);
        cut.insert(cut.end(), edges.begin(), edges.end());
    }
    const TetherPlan anew(without(shape.complex, cut), all, shape.positions, anchors);
    const auto found = lengthsOf(plan.tethers()), expected = lengthsOf(anew.tethers());
    REQUIRE(found.size() == expected.size());
    for (const auto& [who, length] : expected) {
        REQUIRE(found.count(who));
        const double over = found.at(who) / length - 1;
        excess.least = std::min(excess.least, over);
        excess.most = std::max(excess.most, over);
    }
    return excess;
}

}  // namespace

TEST_CASE("cuts: tethers are as long as those of a mesh that was cut from the start",
          "[inextensible][cuts]") {
    constexpr int n = 24;
    const std::vector<int> anchors{0, n - 1, n * n / 2 + n / 3};
    Random random(3);
    for (const auto& [name, shape] : {std::pair{"grid", square(n)},
                                      {"disordered", disordered(n)},
                                      {"half a cylinder", wound(disordered(n))},
                                      {"dome", domed(disordered(n))}}) {
        const SimplicialComplex& complex = shape.complex;
        const auto slit = [&](int column, int from, int to) {
            return across(
                complex, [=](int v) { return v % n < column; },
                [=](int v) { return v / n >= from && v / n < to; });
        };
        std::vector<std::vector<int>> single, lines, sequence;
        for (int i = 0; i < 30; ++i) single.push_back(someEdges(complex, 1, random));
        lines.push_back(slit(n / 2, 0, n / 2));
        for (int i = 0; i < 3; ++i)
            sequence.push_back(slit(n / 4 * (i + 1), i % 2 ? 0 : n / 3, i % 2 ? 2 * n / 3 : n));
        sequence.push_back(sequence.front());
        sequence.push_back(someEdges(complex, 40, random));
        for (const auto& [what, cuts] : {std::pair{"single edges", single},
                                         {"a line", lines},
                                         {"lines and edges", sequence}}) {
            const Excess excess = excessAfter(shape, anchors, cuts);
            const std::string label = std::string(name) + ", " + what;
            CHECK(report(label + ": shorter by", -excess.least, 1e-9));
            CHECK(report(label + ": longer by", excess.most, 1e-9));
        }
    }
}

// Small enough that there are many: of 15 million such lengths none was off by 1e-9.
TEST_CASE("cuts: tethers of any mesh, after any cuts", "[inextensible][cuts]") {
    Excess worst;
    for (int trial = 0; trial < 200; ++trial) {
        Random random(trial);
        const int n = 5 + random.below(12);
        Shape shape = trial % 4 < 2 ? square(n) : disordered(n);
        if (trial % 4 == 1) shape = wound(shape);
        if (trial % 4 == 3)
            for (Vec<double>& x : shape.positions) x += random.point(0.1 / n);
        std::vector<std::vector<int>> cuts;
        for (int step = random.below(8); step >= 0; --step) {
            const int at = random.below(n), from = random.below(n), to = random.below(n);
            const bool column = random.below(2);
            if (random.below(3))
                cuts.push_back(someEdges(shape.complex, 1 + random.below(6), random));
            else
                cuts.push_back(across(
                    shape.complex, [=](int v) { return (column ? v % n : v / n) < at; },
                    [=](int v) {
                        const int along = column ? v / n : v % n;
                        return along >= from && along <= to;
                    }));
        }
        const Excess excess = excessAfter(shape, {random.below(n * n)}, cuts);
        worst.least = std::min(worst.least, excess.least);
        worst.most = std::max(worst.most, excess.most);
    }
    CHECK(report("shorter by", -worst.least, 1e-9));
    CHECK(report("longer by", worst.most, 1e-9));
}

TEST_CASE("cuts: what is cut off from its pins has no tethers, and what is not of the sheet no cut",
          "[inextensible][cuts]") {
    constexpr int n = 12;
    World world;
    const Range sheet = world.add(disordered(n));
    const Range other = world.add(square(2));
    world.pin({0, n - 1});
    SheetPlan plan(world, sheet, {.aggregates = true});
    TetherPlan tethers(world.complex, sheet, world.rest, std::vector{0, n - 1});
    const std::vector<int> row = across(
        world.complex, [](int v) { return v / n < 7; }, [&](int v) { return v < sheet.last; });
    tethers.cut(row);
    std::vector<int> held = tethers.tethers().set.ids;
    std::sort(held.begin(), held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
    CHECK(held.size() == 7 * n - 2);
    CHECK(held.back() == 7 * n - 1);
    tethers.cut(row);
    CHECK(tethers.visited() == 0);

    const int strange = across(
        world.complex, [&](int v) { return v == other.first; },
        [&](int v) { return v >= other.first; })[0];
    const std::vector<std::vector<int>> wrong{
        {row[0], -1}, {row[0], world.complex.count(1)}, {row[0], strange}};
    for (const std::vector<int>& edges : wrong)
        CHECK_THROWS_AS(plan.cut(edges), std::invalid_argument);
    World held0 = world, held1 = world;
    plan.hold(held0);
    holdSheet(held1, sheet, {.aggregates = true});
    CHECK(Solver<float>(held0, {}).set(1).size() == Solver<float>(held1, {}).set(1).size());
}

namespace {

// Positions that no link forbids: along a line, as far as each vertex is from `source` along links,
// and 100 m away where no link leads. They are as far apart as links let anything be.
std::vector<double> stretchedOut(int nodes, const std::vector<Link>& links, int source) {
    std::vector<double> x(static_cast<std::size_t>(nodes), 100);
    Ways(nodes, links).from(std::vector{source}, [&](int node, double distance, int) {
        x[static_cast<std::size_t>(node)] = distance;
        return true;
    });
    return x;
}

void checkLevels(const std::vector<AggregateLevel>& levels, const std::vector<Link>& links,
                 const std::vector<double>& mass, const Points& rest, Random& random) {
    const auto all = [](const std::vector<double>& of) {
        return std::accumulate(of.begin(), of.end(), 0.0);
    };
    std::vector<std::vector<double>> x;
    for (int i = 0; i < 12; ++i)
        x.push_back(stretchedOut(static_cast<int>(mass.size()), links,
                                 random.below(static_cast<int>(mass.size()))));
    AggregateGraph fine{mass, rest, Ways(static_cast<int>(mass.size()), links)};
    double tightest = 0, loosest = 0;
    for (const AggregateLevel& level : levels) {
        const std::size_t count = level.mass.size();
        AggregateGroups groups{level.parent, level.share, {}};
        groups.members.resize(count);
        std::vector<double> shares(count, 0);
        std::vector<Link> inner;
        for (int v = 0; v < fine.size(); ++v) {
            const int parent = level.parent[v];
            REQUIRE(parent >= 0);
            shares[parent] += level.share[v];
            groups.members[parent].push_back(v);
            for (const auto& [other, l] : fine.ways.around(v))
                if (level.parent[other] == parent) inner.push_back({v, other, l});
        }
        Ways within(fine.size(), inner);
        for (std::size_t a = 0; a < count; ++a) {
            CHECK(std::fabs(shares[a] - 1) < 1e-12);
            std::size_t reached = 0;
            within.from(std::span(groups.members[a]).first(1), [&](int, double, int) {
                ++reached;
                return true;
            });
            CHECK(reached == groups.members[a].size());
            CHECK(reached <= 8);
        }
        if (all(mass) < infinity) CHECK(std::fabs(all(level.mass) / all(mass) - 1) < 1e-12);
        AggregateGraph coarse{level.mass, Points(count),
                              Ways(static_cast<int>(count), level.links)};
        std::set<std::array<int, 2>> joined;
        for (int v = 0; v < fine.size(); ++v)
            for (const auto& [other, l] : fine.ways.around(v)) {
                const int a = level.parent[v], b = level.parent[other];
                if (a < b && (coarse.moves(a) || coarse.moves(b))) joined.insert({a, b});
            }
        std::vector<std::array<int, 2>> pairs;
        for (const Link& link : level.links) pairs.push_back({link.a, link.b});
        REQUIRE(std::equal(pairs.begin(), pairs.end(), joined.begin(), joined.end()));
        const std::vector<Link> anew = bounds(fine, groups, coarse, pairs);
        REQUIRE(anew.size() == level.links.size());
        for (std::size_t i = 0; i < anew.size(); ++i) {
            CHECK(level.links[i].length >= anew[i].length * (1 - 1e-12));
            loosest = std::max(loosest, level.links[i].length / anew[i].length - 1);
        }
        for (std::vector<double>& at : x) {
            std::vector<double> mean(count, 0);
            for (int v = 0; v < fine.size(); ++v) mean[level.parent[v]] += level.share[v] * at[v];
            for (const Link& link : level.links)
                tightest =
                    std::max(tightest, std::fabs(mean[link.a] - mean[link.b]) / link.length - 1);
            at = std::move(mean);
        }
        fine = std::move(coarse);
    }
    CHECK(report("means stretched out, beyond their bounds by", tightest, 1e-9));
    CHECK(report("bounds looser than made anew of the same aggregates by", loosest, 1e-12));
}

}  // namespace

TEST_CASE("cuts: aggregates hang together, and their bounds hold", "[inextensible][cuts]") {
    constexpr int n = 24;
    Random random(8);
    for (const auto& [shape, pins] :
         {std::pair{square(n), std::vector<int>{}}, {disordered(n), {0, 1, n - 1, 290}}}) {
        const SimplicialComplex& complex = shape.complex;
        const Points& rest = shape.positions;
        std::vector<double> mass;
        for (int v = 0; v < n * n; ++v) mass.push_back(random.uniform(0.2, 1));
        for (const int v : pins) mass[v] = infinity;
        const auto linksBut = [&complex = complex, &rest](const std::vector<bool>& cut) {
            std::vector<Link> links;
            for (int e = 0; e < complex.count(1); ++e) {
                const auto [a, b] = complex.edge(e);
                if (!cut[e]) links.push_back({a, b, length(rest[b] - rest[a])});
            }
            return links;
        };
        std::vector<bool> cut(complex.count(1), false);
        AggregatePlan plan(mass, rest, linksBut(cut), 4);
        const auto column = [&complex = complex](int c, int rows) {
            return across(
                complex, [=](int v) { return v % n < c; }, [=](int v) { return v / n < rows; });
        };
        std::vector<std::vector<int>> cuts{someEdges(complex, 1, random), column(n / 2 + 1, n / 2),
                                           someEdges(complex, 60, random), column(7, n),
                                           someEdges(complex, 900, random)};
        for (const std::vector<int>& edges : cuts) {
            std::vector<std::array<int, 2>> ends;
            for (const int e : edges) cut[e] = true, ends.push_back(complex.edge(e));
            plan.cut(ends);
            checkLevels(plan.levels(), linksBut(cut), mass, rest, random);
        }
    }
}

// A cut of one edge leaves all that is far from it as it was, to the bit. What lies behind it as
// seen from a pin is not far for tethers, but a strip as wide as the cut.
TEST_CASE("cuts: what is far stays as it was, for a small part of the work",
          "[inextensible][cuts]") {
    constexpr int n = 128;
    World world = hung(disordered(n), {0, n - 1}, {});
    const Range sheet{0, n * n};
    const auto edgeAt = [&](int row, int column) {
        const int v = row * n + column;
        return across(
            world.complex, [=](int u) { return u == v; },
            [=](int u) { return u == v || u == v + 1; })[0];
    };
    const int middle = edgeAt(n / 2, n / 2);
    AggregatePlan aggregates(world.effectiveMass(), world.rest, linksOf(linksOf(world)), 16);
    const std::vector<AggregateLevel> before = aggregates.levels();
    aggregates.cut(std::vector{world.complex.edge(middle)});
    const std::vector<AggregateLevel> after = aggregates.levels();
    std::size_t changed = 0, all = 0;
    for (std::size_t l = 0; l < before.size(); ++l) {
        all += before[l].links.size();
        REQUIRE(after[l].links.size() >= before[l].links.size());
        for (const Link& link : before[l].links) {
            const auto same =
                std::find_if(after[l].links.begin(), after[l].links.end(),
                             [&](const Link& x) { return x.a == link.a && x.b == link.b; });
            changed += same == after[l].links.end() || same->length != link.length;
        }
        CHECK(
            std::equal(before[l].parent.begin(), before[l].parent.end(), after[l].parent.begin()));
    }
    CHECK(report("bounds that one edge changes, of all", double(changed) / double(all), 0.01));

    TetherPlan tethers(world.complex, sheet, world.rest, std::vector{0, n - 1});
    const Tethers held = tethers.tethers();
    tethers.cut(std::vector{middle});
    const Tethers cut = tethers.tethers();
    int longer = 0;
    for (int i = 0; i < held.set.size(); ++i)
        longer += cut.set.rows[i].length != held.set.rows[i].length;
    CHECK(report("tethers that it changes, of all", double(longer) / held.set.size(), 0.02));

    SheetPlan plan(world, sheet, {.strands = false, .aggregates = true});
    const double anew = static_cast<double>(plan.visited());
    plan.cut(std::vector{middle});
    CHECK(report("work for one edge, of that for all", double(plan.visited()) / anew, 0.05));
    double few = 0, many = 0;
    for (int i = 0; i < 32; ++i) {
        plan.cut(std::vector{edgeAt(n / 2 + 7 * i % 60, 4 + 29 * i % 120)});
        (i < 8 ? few : many) += static_cast<double>(plan.visited());
    }
    CHECK(report("work for 24 more, of three times that for 8", many / (3 * few), 1.5));
}
