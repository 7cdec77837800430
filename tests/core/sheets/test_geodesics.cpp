// Shortest ways over a surface: closed forms where it is flat, folded, cut out or a cube, and a
// brute force that comes down on them from above where it is anything.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/complex/shapes.h>
#include <plait/sheets/tethers/geodesics.h>
#include <plait/sheets/tethers/tethers.h>

#include <algorithm>
#include <array>
#include <queue>

using namespace plait;
using namespace plait::test;

namespace {

using Points = std::vector<Vec<double>>;

struct Surface {
    SimplicialComplex complex;
    Points rest;

    int size() const { return static_cast<int>(rest.size()); }
    std::vector<Geodesics::Way> from(const std::vector<int>& sources) const {
        return Geodesics(complex, {0, size()}, rest).from(sources);
    }
};

// A flat square of irregular triangles: jittered within its rim, diagonals either way.
Surface patch(int n, Random& random) {
    Points rest = grid({.columns = n, .rows = n}).positions;
    const double jitter = 0.2 / n;  // no triangle turns over
    Simplices given;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
            const int v = r * n + c;
            if (r > 0 && c > 0 && r < n - 1 && c < n - 1)
                rest[v] += Vec<double>{random.uniform(-jitter, jitter),
                                       random.uniform(-jitter, jitter), 0};
            if (r == n - 1 || c == n - 1) continue;
            const std::array<int, 4> q{v, v + 1, v + n + 1, v + n};
            const int k = random.below(2);
            given.triangles.push_back({q[k], q[k + 1], q[k + 2]});
            given.triangles.push_back({q[k], q[k + 2], q[(k + 3) % 4]});
        }
    return {SimplicialComplex(n * n, given), rest};
}

// Over `inner` points on every edge, joined across every triangle and along every edge: a way
// there is, and ever closer to the shortest.
std::vector<double> bruteForce(const Surface& surface, int source, int inner) {
    const SimplicialComplex& complex = surface.complex;
    Points nodes = surface.rest;
    std::vector<std::vector<int>> onEdge;
    for (int e = 0; e < complex.count(1); ++e) {
        const auto v = complex.vertices(1, e);
        onEdge.push_back({v[0], v[1]});
        for (int i = 1; i <= inner; ++i) {
            onEdge.back().push_back(static_cast<int>(nodes.size()));
            nodes.push_back(surface.rest[v[0]] +
                            (double(i) / (inner + 1)) * (surface.rest[v[1]] - surface.rest[v[0]]));
        }
    }
    std::vector<std::vector<int>> joined(nodes.size());
    for (int t = 0; t < complex.count(2); ++t) {
        std::vector<int> all;
        for (const int e : complex.faces(2, t))
            all.insert(all.end(), onEdge[e].begin(), onEdge[e].end());
        for (const int a : all) joined[a].insert(joined[a].end(), all.begin(), all.end());
    }
    std::vector<double> d(nodes.size(), infinity);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.emplace(d[source] = 0, source);
    while (!open.empty()) {
        const auto [distance, node] = open.top();
        open.pop();
        if (distance > d[node]) continue;
        for (const int next : joined[node]) {
            const double through = distance + length(nodes[next] - nodes[node]);
            if (through < d[next]) open.emplace(d[next] = through, next);
        }
    }
    d.resize(surface.rest.size());
    return d;
}

}  // namespace

TEST_CASE("geodesics: straight on a flat sheet, from the nearest source", "[geodesics]") {
    Random random(7);
    double worst = 0;
    for (int trial = 0; trial < 12; ++trial) {
        const int n = 3 + random.below(20);
        const Shape regular = grid({.columns = n, .rows = n});
        const Surface sheet =
            trial % 3 ? patch(n, random) : Surface{regular.complex, regular.positions};
        std::vector<int> sources;
        for (int s = 0; s <= trial % 4; ++s) sources.push_back(random.below(n * n));
        const auto ways = sheet.from(sources);
        for (int v = 0; v < sheet.size(); ++v) {
            double least = infinity;
            for (const int s : sources)
                least = std::min(least, length(sheet.rest[v] - sheet.rest[s]));
            worst = std::max(worst, std::fabs(ways[v].length - least));
            REQUIRE(std::find(sources.begin(), sources.end(), ways[v].source) != sources.end());
            CHECK(std::fabs(length(sheet.rest[v] - sheet.rest[ways[v].source]) - least) < 1e-12);
        }
    }
    CHECK(report("ways - straight lines, m", worst, 1e-12));
}

TEST_CASE("geodesics: folding a sheet changes no way", "[geodesics]") {
    constexpr int columns = 15, rows = 9, source = 20;
    const Shape shape = grid({.columns = columns, .rows = rows});
    Surface sheet{shape.complex, shape.positions};
    const auto before = sheet.from({source});
    for (int v = 0; v < sheet.size(); ++v) {  // a zigzag of columns, 60 degrees up and down
        const int column = v % columns;
        sheet.rest[v].x = 0.5 * column / (columns - 1);
        sheet.rest[v].z = column % 2 * std::sqrt(0.75) / (columns - 1);
    }
    const auto after = sheet.from({source});
    double worst = 0;
    for (int v = 0; v < sheet.size(); ++v)
        worst = std::max(worst, std::fabs(after[v].length - before[v].length));
    CHECK(report("folded - flat, m", worst, 1e-12));
}

TEST_CASE("geodesics: both ways round a tube", "[geodesics]") {
    constexpr int segments = 11, rings = 8;
    const Shape shape = tube({.segments = segments, .rings = rings, .radius = 0.4, .height = 1});
    const Surface surface{shape.complex, shape.positions};
    const auto ways = surface.from({2 * segments});
    const double side = length(shape.positions[1] - shape.positions[0]);
    double worst = 0;
    for (int v = 0; v < surface.size(); ++v) {
        const int around = std::min(v % segments, segments - v % segments);
        const double up = (v / segments - 2) / (rings - 1.0);
        const double unrolled = std::sqrt(around * around * side * side + up * up);
        worst = std::max(worst, std::fabs(ways[v].length - unrolled));
    }
    CHECK(report("ways - unrolled, m", worst, 1e-12));
}

TEST_CASE("geodesics: round the corner of a cut", "[geodesics]") {
    constexpr int n = 11, middle = (n / 2) * n + n / 2;
    const Shape shape = grid({.columns = n, .rows = n});
    Simplices kept;
    for (int t = 0; t < shape.complex.count(2); ++t) {
        const std::array<int, 3> v = shape.complex.triangle(t);
        const auto cut = [&](int i) { return i % n >= n / 2 && i / n >= n / 2; };
        if (!std::all_of(v.begin(), v.end(), cut)) kept.triangles.push_back(v);
    }
    const Surface surface{SimplicialComplex(n * n, kept), shape.positions};
    const int source = n - 1 + n * (n / 2 - 1), end = n * (n - 1) + 2;
    const Points& x = surface.rest;
    const double bent = length(x[middle] - x[source]) + length(x[end] - x[middle]);
    CHECK(std::fabs(surface.from({source})[end].length - bent) < 1e-12);
    CHECK(surface.from({source})[n * n - 1].length == infinity);  // cut away
    CHECK(surface.from({source})[n * n - 1].source == -1);
}

TEST_CASE("geodesics: over a cube and along a thread", "[geodesics]") {
    Points x;
    for (int v = 0; v < 8; ++v)
        x.push_back({double(v & 1), double(v >> 1 & 1), double(v >> 2 & 1)});
    x.push_back({1, 1, 3});  // a thread from the far corner
    Simplices given{.edges = {{7, 8}}, .triangles = {}, .tetrahedra = {}};
    for (const auto& [a, b, c, d] : {std::array{0, 1, 3, 2},
                                     {4, 5, 7, 6},
                                     {0, 1, 5, 4},
                                     {2, 3, 7, 6},
                                     {0, 2, 6, 4},
                                     {1, 3, 7, 5}}) {
        given.triangles.push_back({a, b, c});
        given.triangles.push_back({a, c, d});
    }
    const Surface cube{SimplicialComplex(9, given), x};
    const auto ways = cube.from({0});
    CHECK(std::fabs(ways[7].length - std::sqrt(5)) < 1e-12);
    CHECK(std::fabs(ways[3].length - std::sqrt(2)) < 1e-12);
    CHECK(std::fabs(ways[8].length - std::sqrt(5) - 2) < 1e-12);
    const std::vector<int> outside{9};
    CHECK_THROWS_AS((Surface{SimplicialComplex(9, given), x}.from(outside)), std::invalid_argument);
}

// Hills and a saddle everywhere. What goes through points on edges is never shorter, and with
// spacing s on them longer by some s^2.
TEST_CASE("geodesics: what brute force comes down to on hills", "[geodesics]") {
    Random random(9);
    Surface hills = patch(9, random);
    for (Vec<double>& x : hills.rest) x += random.point(0.06);
    for (const int source : {0, 40}) {
        const auto ways = hills.from({source});
        std::array<double, 2> over{};
        for (const int fine : {0, 1}) {
            const std::vector<double> brute = bruteForce(hills, source, fine ? 24 : 6);
            for (int v = 0; v < hills.size(); ++v) {
                REQUIRE(brute[v] >= (1 - 1e-12) * ways[v].length);
                if (v != source) over[fine] = std::max(over[fine], brute[v] / ways[v].length - 1);
            }
        }
        note("brute force with 6 points an edge, too long by", over[0]);
        CHECK(report("with 24", over[1], over[0] / 4));
    }
}

// Every inner edge has four triangles: light that was parted at each would need some 2^n windows.
TEST_CASE("geodesics: a sheet with two sides costs little more than one",
          "[geodesics][strangers]") {
    for (const int n : {12, 24}) {
        Random random(2);
        const Surface one = patch(n, random);
        Simplices both;
        for (int t = 0; t < one.complex.count(2); ++t)
            both.triangles.push_back(one.complex.triangle(t));
        for (int v = 0; v + n + 1 < n * n; ++v) {
            if (v % n == n - 1) continue;
            const std::array<int, 4> q{v, v + n, v + n + 1, v + 1};
            const int k = random.below(2);
            both.triangles.push_back({q[k], q[k + 1], q[k + 2]});
            both.triangles.push_back({q[k], q[k + 2], q[(k + 3) % 4]});
        }
        const SimplicialComplex two(n * n, both);
        std::vector<int> hoist;
        for (int v = 0; v < n * n; v += n) hoist.push_back(v);
        const TetherPlan plan(two, {0, n * n}, one.rest, hoist);
        CHECK(report("looked at by vertex", double(plan.visited()) / (n * n), 20));
        const Tethers tethers = plan.tethers();
        REQUIRE(tethers.anchors.size() == static_cast<std::size_t>(n * (n - 1)));
        for (std::size_t i = 0; i < tethers.anchors.size(); ++i) {
            const Vec<double>& x = one.rest[tethers.set.ids[i]];
            // At most along the edges, which in a square is sqrt 2 further.
            CHECK(tethers.set.rows[i].length >= x.x * (1 - 1e-9));
            CHECK(tethers.set.rows[i].length <= 1.5 * x.x);
        }
    }
}
