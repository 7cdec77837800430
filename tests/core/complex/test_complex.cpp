#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "tests/catch.h"

#include <plait/complex/complex.h>
#include <plait/complex/shapes.h>

using namespace plait;

namespace {

using Vertices = std::vector<int>;

Vertices verticesOf(const SimplicialComplex& complex, int k, int i) {
    const auto vertices = complex.vertices(k, i);
    return {vertices.begin(), vertices.end()};
}

// Parity by counting inversions, which the complex does not do.
int parity(const Vertices& order) {
    int inversions = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) inversions += order[i] > order[j];
    return inversions % 2 == 0 ? 1 : -1;
}

// Mixed dimensions, duplicates in any orientation, faces given beside their cells. The vertices
// come from the raw bits of the generator, so that all standard libraries draw the same.
Simplices randomSimplices(std::mt19937& bits, int vertexCount) {
    const auto draw = [&](auto& simplices, unsigned most) {
        simplices.resize(bits() % (most + 1));
        for (auto& simplex : simplices) {
            std::set<int> distinct;
            for (int& v : simplex) {
                do v = static_cast<int>(bits() % static_cast<unsigned>(vertexCount));
                while (!distinct.insert(v).second);
            }
        }
    };
    Simplices simplices;
    draw(simplices.edges, 12);
    draw(simplices.triangles, 12);
    draw(simplices.tetrahedra, 8);
    return simplices;
}

// A strip of quads between two rings of n vertices, closed with a half twist.
SimplicialComplex moebius(int n) {
    Simplices simplices;
    const auto vertex = [&](int i, int side) { return i < n ? 2 * i + side : 1 - side; };
    for (int i = 0; i < n; ++i) {
        simplices.triangles.push_back({vertex(i, 0), vertex(i + 1, 0), vertex(i + 1, 1)});
        simplices.triangles.push_back({vertex(i, 0), vertex(i + 1, 1), vertex(i, 1)});
    }
    return SimplicialComplex(2 * n, simplices);
}

SimplicialComplex torus(int n, int m) {
    Simplices simplices;
    const auto vertex = [&](int i, int j) { return i % n * m + j % m; };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            simplices.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            simplices.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return SimplicialComplex(n * m, simplices);
}

// Neighbouring triangles of an oriented surface run along their shared edge in opposite directions.
bool isConsistentlyOriented(const SimplicialComplex& complex) {
    std::vector<int> sum(complex.count(1)), parents = complex.valences(1);
    for (int t = 0; t < complex.count(2); ++t)
        for (int j = 0; j < 3; ++j) sum[complex.faces(2, t)[j]] += complex.incidence(2, t, j);
    for (std::size_t e = 0; e < sum.size(); ++e)
        if (parents[e] == 2 && sum[e] != 0) return false;
    return true;
}

void requireHingesByBruteForce(const SimplicialComplex& complex) {
    std::vector<std::array<int, 5>> expected, found;
    for (int e = 0; e < complex.count(1); ++e)
        for (int t = 0; t < complex.count(2); ++t)
            for (int u = t + 1; u < complex.count(2); ++u) {
                const auto [a, b] = complex.edge(e);
                const auto opposite = [&](int triangle) {
                    Vertices rest;
                    for (int v : complex.vertices(2, triangle))
                        if (v != a && v != b) rest.push_back(v);
                    return rest.size() == 1 ? rest[0] : -1;
                };
                const int c = opposite(t), d = opposite(u);
                if (c < 0 || d < 0) continue;
                const auto around = complex.triangle(t);
                const bool along = parity({around[0], around[1], around[2]}) == parity({a, b, c});
                expected.push_back({along ? a : b, along ? b : a, c, d, e});
            }
    for (const Hinge& hinge : complex.hinges()) {
        const auto& v = hinge.vertices;
        found.push_back({v[0], v[1], v[2], v[3], hinge.edge});
    }
    REQUIRE(found == expected);
}

}  // namespace

TEST_CASE("Euler characteristics are those of the shapes", "[SH1]") {
    for (int n = 0; n <= 3; ++n)
        CHECK(sphere({.subdivisions = n}).complex.eulerCharacteristic() == 2);
    CHECK(torus(5, 7).eulerCharacteristic() == 0);
    CHECK(moebius(5).eulerCharacteristic() == 0);
    CHECK(block({.columns = 3, .rows = 2, .layers = 4}).complex.eulerCharacteristic() == 1);
    CHECK(disc({.rings = 4}).complex.eulerCharacteristic() == 1);
    CHECK(grid({.columns = 6, .rows = 3}).complex.eulerCharacteristic() == 1);
    CHECK(tube({.segments = 5, .rings = 4}).complex.eulerCharacteristic() == 0);
    CHECK(chain({.links = 9}).complex.eulerCharacteristic() == 1);
    CHECK(SimplicialComplex(7).eulerCharacteristic() == 7);
    CHECK(SimplicialComplex().eulerCharacteristic() == 0);
}

TEST_CASE("the torus is closed and oriented, the Moebius strip neither") {
    CHECK(torus(5, 7).boundary(1).empty());
    CHECK(isConsistentlyOriented(torus(5, 7)));
    CHECK(moebius(5).boundary(1).size() == 10);
    CHECK_FALSE(isConsistentlyOriented(moebius(5)));
}

TEST_CASE("signs are those of all permutations of up to four vertices", "[SH4]") {
    const auto check = [](Vertices order, auto build, int k) {
        std::ranges::sort(order);
        do {
            const SimplicialComplex complex(10, build(order));
            REQUIRE(complex.count(k) == 1);
            REQUIRE(complex.sign(k, 0) == parity(order));
            REQUIRE(std::ranges::is_sorted(complex.vertices(k, 0)));
            Vertices back;
            if (k == 1) std::ranges::copy(complex.edge(0), std::back_inserter(back));
            if (k == 2) std::ranges::copy(complex.triangle(0), std::back_inserter(back));
            if (k == 3) std::ranges::copy(complex.tetrahedron(0), std::back_inserter(back));
            REQUIRE(parity(back) == parity(order));
            REQUIRE(std::ranges::is_permutation(back, order));
        } while (std::ranges::next_permutation(order).found);
    };
    check({8, 3}, [](const Vertices& v) { return Simplices{{{v[0], v[1]}}, {}, {}}; }, 1);
    check({8, 3, 5}, [](const Vertices& v) { return Simplices{{}, {{v[0], v[1], v[2]}}, {}}; }, 2);
    check(
        {8, 3, 5, 0},
        [](const Vertices& v) { return Simplices{{}, {}, {{v[0], v[1], v[2], v[3]}}}; }, 3);
}

TEST_CASE("a simplex given twice is one, and has no orientation when they disagree") {
    const SimplicialComplex same(
        3, {.edges = {}, .triangles = {{0, 2, 1}, {2, 1, 0}}, .tetrahedra = {}});
    CHECK(same.count(2) == 1);
    CHECK(same.sign(2, 0) == -1);
    const SimplicialComplex both(
        3, {.edges = {}, .triangles = {{0, 2, 1}, {0, 1, 2}}, .tetrahedra = {}});
    CHECK(both.count(2) == 1);
    CHECK(both.sign(2, 0) == 0);
    CHECK(both.triangle(0) == std::array{0, 1, 2});
}

TEST_CASE("given simplices keep their order, the closure follows sorted", "[SH6]") {
    const SimplicialComplex complex(
        6, {.edges = {{5, 4}, {2, 1}}, .triangles = {{3, 2, 1}, {0, 1, 2}}, .tetrahedra = {}});
    std::vector<Vertices> edges;
    std::vector<int> signs;
    for (int e = 0; e < complex.count(1); ++e) {
        edges.push_back(verticesOf(complex, 1, e));
        signs.push_back(complex.sign(1, e));
    }
    CHECK(edges == std::vector<Vertices>{{4, 5}, {1, 2}, {0, 1}, {0, 2}, {1, 3}, {2, 3}});
    CHECK(signs == std::vector<int>{-1, -1, 1, 1, 1, 1});
    CHECK(complex.edge(0) == std::array{5, 4});
    CHECK(verticesOf(complex, 2, 0) == Vertices{1, 2, 3});
    CHECK(complex.triangle(0) == std::array{1, 3, 2});
}

TEST_CASE("closure, parents, valences, boundaries and rings of random complexes hold", "[SH5]") {
    std::mt19937 bits(20090);
    for (int run = 0; run < 300; ++run) {
        const int vertexCount = 6 + run % 7;
        const Simplices given = randomSimplices(bits, vertexCount);
        const SimplicialComplex complex(vertexCount, given);

        // The closure by sets.
        std::array<std::set<Vertices>, 4> closure;
        for (int v = 0; v < vertexCount; ++v) closure[0].insert({v});
        const auto add = [&](Vertices simplex) {
            std::ranges::sort(simplex);
            for (unsigned subset = 1; subset < 1u << simplex.size(); ++subset) {
                Vertices face;
                for (std::size_t i = 0; i < simplex.size(); ++i)
                    if (subset >> i & 1) face.push_back(simplex[i]);
                closure[face.size() - 1].insert(face);
            }
        };
        for (const auto& s : given.edges) add({s.begin(), s.end()});
        for (const auto& s : given.triangles) add({s.begin(), s.end()});
        for (const auto& s : given.tetrahedra) add({s.begin(), s.end()});

        for (int k = 0; k <= 3; ++k) {
            std::set<Vertices> found;
            for (int i = 0; i < complex.count(k); ++i) found.insert(verticesOf(complex, k, i));
            REQUIRE(found == closure[k]);
            REQUIRE(complex.count(k) == static_cast<int>(found.size()));
        }

        for (int k = 0; k < 3; ++k) {
            const Csr parents = complex.parents(k);
            const std::vector<int> valences = complex.valences(k);
            Vertices boundary;
            for (int i = 0; i < complex.count(k); ++i) {
                Vertices expected;
                for (int p = 0; p < complex.count(k + 1); ++p)
                    if (std::ranges::includes(complex.vertices(k + 1, p), complex.vertices(k, i)))
                        expected.push_back(p);
                REQUIRE(Vertices(parents[i].begin(), parents[i].end()) == expected);
                REQUIRE(valences[i] == static_cast<int>(expected.size()));
                if (expected.size() == 1) boundary.push_back(i);
            }
            REQUIRE(complex.boundary(k) == boundary);
        }
        REQUIRE(complex.valences(3) == std::vector<int>(complex.count(3)));
        REQUIRE(complex.parents(3).size() == complex.count(3));

        const Csr ring = complex.oneRing();
        for (int v = 0; v < vertexCount; ++v) {
            Vertices expected;
            for (int u = 0; u < vertexCount; ++u)
                if (u != v && closure[1].contains({std::min(u, v), std::max(u, v)}))
                    expected.push_back(u);
            REQUIRE(Vertices(ring[v].begin(), ring[v].end()) == expected);
        }
        requireHingesByBruteForce(complex);
    }
}

TEST_CASE("the boundary of a boundary is zero", "[SH5]") {
    std::mt19937 bits(5);
    int cancelled = 0;
    for (int run = 0; run < 300; ++run) {
        const SimplicialComplex complex(9, randomSimplices(bits, 9));
        for (int k = 2; k <= 3; ++k)
            for (int i = 0; i < complex.count(k); ++i) {
                std::map<int, int> sum;
                for (int j = 0; j <= k; ++j) {
                    const int face = complex.faces(k, i)[j];
                    REQUIRE(std::abs(complex.incidence(k, i, j)) == 1);
                    for (int l = 0; l < k; ++l)
                        sum[complex.faces(k - 1, face)[l]] +=
                            complex.incidence(k, i, j) * complex.incidence(k - 1, face, l);
                }
                REQUIRE(sum.size() == (k == 2 ? 3U : 6U));
                for (const auto& [face, value] : sum) REQUIRE(value == 0);
                ++cancelled;
            }
    }
    REQUIRE(cancelled > 3000);
}

TEST_CASE("face j lacks vertex j, and the boundary of an edge is its end less its start") {
    const SimplicialComplex complex(
        4, {.edges = {{3, 1}}, .triangles = {}, .tetrahedra = {{0, 1, 2, 3}}});
    for (int k = 1; k <= 3; ++k)
        for (int i = 0; i < complex.count(k); ++i)
            for (int j = 0; j <= k; ++j) {
                Vertices expected = verticesOf(complex, k, i);
                expected.erase(expected.begin() + j);
                REQUIRE(verticesOf(complex, k - 1, complex.faces(k, i)[j]) == expected);
            }
    for (int j = 0; j < 2; ++j)
        CHECK(complex.incidence(1, 0, j) == (complex.faces(1, 0)[j] == 1 ? 1 : -1));
    CHECK(complex.faces(0, 0).empty());
}

TEST_CASE("mixed dimensions: a triangle, a dangling edge, a tetrahedron and a lone point",
          "[SH2]") {
    const SimplicialComplex complex(
        9, {.edges = {{2, 3}}, .triangles = {{0, 1, 2}}, .tetrahedra = {{4, 5, 6, 7}}});
    CHECK(complex.count(0) == 9);
    CHECK(complex.count(1) == 3 + 1 + 6);
    CHECK(complex.count(2) == 1 + 4);
    CHECK(complex.count(3) == 1);
    CHECK(complex.eulerCharacteristic() == 3);  // three pieces without holes
    CHECK(complex.valences(0) == std::vector<int>{2, 2, 3, 1, 3, 3, 3, 3, 0});
    CHECK(complex.boundary(2).size() == 4);
    CHECK(complex.boundary(1).size() == 3);
    CHECK(complex.hinges().size() == 6);
    CHECK(complex.boundary(0) == std::vector<int>{3});
    CHECK(complex.oneRing()[8].empty());
}

TEST_CASE("hinges: the first triangle keeps its orientation, three on an edge give every pair") {
    const SimplicialComplex flat(
        4, {.edges = {}, .triangles = {{2, 1, 0}, {1, 2, 3}}, .tetrahedra = {}});
    REQUIRE(flat.hinges().size() == 1);
    CHECK(flat.hinges()[0].vertices == std::array{2, 1, 0, 3});
    const SimplicialComplex fan(
        5, {.edges = {{1, 0}}, .triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}, .tetrahedra = {}});
    const auto hinges = fan.hinges();
    REQUIRE(hinges.size() == 3);
    CHECK(hinges[0].vertices == std::array{0, 1, 2, 3});
    CHECK(hinges[1].vertices == std::array{0, 1, 2, 4});
    CHECK(hinges[2].vertices == std::array{0, 1, 3, 4});
    CHECK(hinges[2].edge == 0);
    requireHingesByBruteForce(disc({.rings = 3}).complex);
    requireHingesByBruteForce(moebius(5));
}

TEST_CASE("an appended complex is the complex of both lists") {
    std::mt19937 bits(77);
    for (int run = 0; run < 50; ++run) {
        const Simplices a = randomSimplices(bits, 8), b = randomSimplices(bits, 6);
        SimplicialComplex joined(8, a);
        const SimplicialComplex before = joined, other(6, b);
        const Range range = joined.append(other);
        REQUIRE(range.first == 8);
        REQUIRE(range.last == 14);
        REQUIRE(joined.count(0) == 14);
        for (int k = 0; k <= 3; ++k) {
            REQUIRE(joined.count(k) == before.count(k) + other.count(k));
            for (int i = 0; i < other.count(k); ++i) {
                const int shifted = before.count(k) + i;
                Vertices expected = verticesOf(other, k, i);
                for (int& v : expected) v += 8;
                REQUIRE(verticesOf(joined, k, shifted) == expected);
                REQUIRE(joined.sign(k, shifted) == other.sign(k, i));
                for (int j = 0; k > 0 && j <= k; ++j)
                    REQUIRE(joined.faces(k, shifted)[j] ==
                            other.faces(k, i)[j] + before.count(k - 1));
            }
        }
        REQUIRE(joined.hinges().size() == before.hinges().size() + other.hinges().size());
    }
    SimplicialComplex twice = torus(4, 4);
    twice.append(twice);
    CHECK(twice.count(0) == 32);
    CHECK(twice.count(2) == 64);
    CHECK(twice.vertices(2, 40)[0] == twice.vertices(2, 8)[0] + 16);
    CHECK(twice.boundary(1).empty());
}

TEST_CASE("what is no complex is refused with its reason") {
    const auto message = [](int vertexCount, const Simplices& given) -> std::string {
        try {
            SimplicialComplex complex(vertexCount, given);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "accepted";
    };
    CHECK(message(-1, {}) == "SimplicialComplex: negative vertex count");
    CHECK(message(3, {.edges = {{0, 1}, {0, 3}}, .triangles = {}, .tetrahedra = {}}) ==
          "SimplicialComplex: edge 1: vertex 3 is not one of 3");
    CHECK(message(3, {.edges = {}, .triangles = {{0, -1, 2}}, .tetrahedra = {}}) ==
          "SimplicialComplex: triangle 0: vertex -1 is not one of 3");
    CHECK(message(5, {.edges = {}, .triangles = {}, .tetrahedra = {{4, 1, 2, 4}}}) ==
          "SimplicialComplex: tetrahedron 0: a vertex stands twice");
    CHECK_THROWS_AS(SimplicialComplex().count(4), std::invalid_argument);
    CHECK_THROWS_AS(SimplicialComplex().parents(-1), std::invalid_argument);
}
