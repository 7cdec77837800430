// A complex that comes apart: names of corners, whatever is cut and in whichever order.
#include "tests/catch.h"
#include "tests/random.h"

#include <plait/complex/cuts.h>
#include <plait/complex/shapes.h>

#include <algorithm>
#include <map>
#include <set>

using namespace plait;
using namespace plait::test;

namespace {

// 5 x 5 vertices, and spare ones behind them.
struct Sheet {
    SimplicialComplex complex = grid({5, 5, 1, 1}).complex;
    Range matter{0, complex.count(0)}, spare{};

    explicit Sheet(int spares) { spare = complex.append(SimplicialComplex(spares)); }

    Cuts cuts(const std::vector<unsigned char>& held = {}) const {
        std::vector<unsigned char> all = held;
        all.resize(static_cast<std::size_t>(complex.count(0)));
        return Cuts(complex, {{matter, spare}}, all);
    }
    int edge(int a, int b) const {
        for (int e = 0; e < complex.count(1); ++e)
            if (complex.vertices(1, e)[0] == a && complex.vertices(1, e)[1] == b) return e;
        return -1;
    }
};

// Corners of the triangles around each vertex that hang together across edges that are not cut, by
// brute force: they have one name, and no other corner has it.
void checkNames(const Cuts& cuts) {
    const SimplicialComplex& whole = cuts.whole();
    const Csr wings = whole.parents(1);
    std::map<int, std::set<std::pair<int, int>>> named;  // by name: (vertex, fan)
    for (int v = 0; v < whole.count(0); ++v) {
        std::map<int, int> fan;  // by triangle
        for (const int t : cuts.around(v)) fan[t] = t;
        for (bool changed = true; changed;) {
            changed = false;
            for (int e = 0; e < whole.count(1); ++e) {
                const auto ends = whole.vertices(1, e);
                if (cuts.isCut(e) || (ends[0] != v && ends[1] != v)) continue;
                for (const int s : wings[e])
                    for (const int t : wings[e])
                        if (fan[s] < fan[t]) fan[t] = fan[s], changed = true;
            }
        }
        for (const auto& [t, least] : fan) named[cuts.nameIn(t, v)].insert({v, least});
    }
    for (const auto& [name, fans] : named) {
        CHECK(fans.size() == 1);
        CHECK(cuts.original(name) == fans.begin()->first);
    }
}

}  // namespace

TEST_CASE("cuts: vertices split where their triangles hang together no more", "[tearing][AT7]") {
    Sheet sheet(8);
    Cuts cuts = sheet.cuts();
    SECTION("from the border inwards one vertex an edge, the end stays whole") {
        CHECK(cuts.cut(sheet.edge(10, 11)));
        CHECK(cuts.splits().size() == 1);
        CHECK(cuts.cut(sheet.edge(11, 12)));
        CHECK(cuts.splits().size() == 2);
        CHECK(cuts.torn().eulerCharacteristic() == 1 + 6);  // a sheet, and spare points
    }
    SECTION("inside, one edge opens nothing and two open a hole") {
        CHECK(cuts.cut(sheet.edge(11, 12)));
        CHECK(cuts.splits().empty());
        CHECK(cuts.cut(sheet.edge(12, 13)));
        CHECK(cuts.splits().size() == 1);
        CHECK(cuts.torn().boundary(1).size() == sheet.complex.boundary(1).size() + 4);
    }
    SECTION("right across, two sheets") {
        for (int c = 0; c < 4; ++c) CHECK(cuts.cut(sheet.edge(10 + c, 11 + c)));
        CHECK(cuts.splits().size() == 5);
        // One more component of triangles; three spare vertices are left as points.
        CHECK(cuts.torn().eulerCharacteristic() == 1 + 1 + 3);
    }
    SECTION("around a vertex, an island: it doubles back in every triangle") {
        const Csr edges = sheet.complex.parents(0);
        for (const int e : edges[12]) CHECK(cuts.cut(e));
        CHECK(cuts.splits().size() == 5);
    }
    SECTION("a tear that meets another") {
        for (const auto& [a, b] : {std::pair{10, 11}, {11, 12}, {2, 7}, {7, 12}})
            CHECK(cuts.cut(sheet.edge(a, b)));
        CHECK(cuts.splits().size() == 5);
    }
    checkNames(cuts);
}

TEST_CASE("cuts: any edges in any order", "[tearing][AT7]") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Sheet sheet(200);
        Random random(seed);
        Cuts cuts = sheet.cuts();
        std::vector<int> list;
        for (int i = 0; i < 30; ++i) {
            const int e = random.below(sheet.complex.count(1));
            if (cuts.cut(e)) list.push_back(e);
        }
        checkNames(cuts);
        CHECK(cuts.torn().count(2) == sheet.complex.count(2));
        Cuts again = sheet.cuts();
        for (const int e : list) CHECK(again.cut(e));
        for (int t = 0; t < sheet.complex.count(2); ++t)
            CHECK(std::ranges::equal(cuts.corners(t), again.corners(t)));
    }
}

TEST_CASE("cuts: what is refused changes nothing", "[tearing][AT7]") {
    Sheet sheet(1);
    Cuts cuts = sheet.cuts();
    CHECK_FALSE(cuts.cut(sheet.edge(0, 1)));  // of one triangle
    CHECK(cuts.cut(sheet.edge(10, 11)));
    CHECK_FALSE(cuts.cut(sheet.edge(10, 11)));
    CHECK_FALSE(cuts.cut(sheet.edge(11, 12)));  // no spare vertex is left
    CHECK_FALSE(cuts.isCut(sheet.edge(11, 12)));
    CHECK(cuts.order().size() == 1);
    std::vector<unsigned char> held(25);
    held[10] = 1;
    Cuts pinned = sheet.cuts(held);
    CHECK(pinned.cut(sheet.edge(10, 11)));
    CHECK(pinned.splits().empty());  // what is held stays whole
}

TEST_CASE("cuts: stencils follow the triangles they lie in", "[tearing][AT7][AT19]") {
    Sheet sheet(8);
    Cuts cuts = sheet.cuts();
    for (int c = 0; c < 2; ++c) CHECK(cuts.cut(sheet.edge(10 + c, 11 + c)));
    int across = 0;
    for (const Hinge& hinge : sheet.complex.hinges()) {
        std::array<int, 4> stencil = hinge.vertices;
        const bool whole = cuts.rename(stencil);
        across += !whole;
        // The end of the tear, 12, is whole: both sides of the edge to it still meet there.
        CHECK(whole == (hinge.edge != sheet.edge(10, 11) && hinge.edge != sheet.edge(11, 12)));
        if (!whole) continue;
        for (std::size_t i = 0; i < 4; ++i) CHECK(cuts.original(stencil[i]) == hinge.vertices[i]);
    }
    CHECK(across == 2);
    std::array<int, 2> far{10, 14};
    CHECK_FALSE(cuts.rename(far));  // 10 has come apart, and no triangle has both
    std::array<int, 2> untouched{0, 24};
    CHECK(cuts.rename(untouched));
}
