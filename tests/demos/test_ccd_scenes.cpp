// Whole frames of cloth and rods, and every pair of theirs that truly collides.
#include "ccd_folder.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/collision/hash_grid.h>
#include <plait/collision/kdop_tree.h>
#include <plait/files/mesh_reader.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using namespace plait;

namespace {

using Pairs = std::set<Candidate>;

Shape frame(const std::filesystem::path& file) {
    MeshBuilder mesh;
    mesh.file = file.string();
    readPly(mesh, gunzip(file));
    return mesh.finished();
}

// A step, and the pairs that collide in it: of points and triangles, of edges.
struct CcdScene {
    std::vector<Vec<double>> start, end;
    SimplicialComplex complex;
    Pairs pointTriangle, edgeEdge;
    int missed = 0, late = 0, invented = 0;  // by the queries, of the table's pairs

    explicit CcdScene(const std::filesystem::path& folder) {
        const Shape first = frame(folder / "t0.ply.gz");
        start = first.positions;
        end = frame(folder / "t1.ply.gz").positions;
        complex = first.complex;
        std::map<std::vector<int>, int> index;  // of an edge or a triangle
        for (const int k : {1, 2})
            for (int i = 0; i < complex.count(k); ++i) {
                const auto v = complex.vertices(k, i);
                index[{v.begin(), v.end()}] = i;
            }
        const auto find = [&](std::vector<int> v) {
            std::ranges::sort(v);
            return index.at(v);
        };
        const std::string table = gunzip(folder / "pairs.csv.gz");
        for (const std::string_view line : split(table, '\n')) {
            const auto row = split(line, ',');
            if (row.size() != 8 || row[0] == "kind") continue;
            int v[4];
            for (int c = 0; c < 4; ++c) v[c] = std::stoi(std::string(row[1 + c]));
            ask(v, row);
            if (row[5] != "1") continue;
            if (row[0] == "vf") {
                pointTriangle.insert({v[0], find({v[1], v[2], v[3]})});
            } else {
                const auto [a, b] = std::minmax({find({v[0], v[1]}), find({v[2], v[3]})});
                edgeEdge.insert({a, b});
            }
        }
    }

    void ask(const int (&v)[4], const std::vector<std::string_view>& row) {
        CcdQuery query{};
        query.edges = row[0] == "ee";
        for (int c = 0; c < 4; ++c) query.vertex[c] = {start[v[c]], end[v[c]]};
        const Impact impact = answer(query, 0);
        const bool touches = row[5] == "1";
        missed += touches && !impact;
        invented += !touches && impact;
        late += touches && impact && *impact > std::stod(std::string(row[7]));
    }

    template <int k>
    auto bounds(int dimension) const {
        return [this, dimension](int i) {
            return sweptBounds<k>(complex.vertices(dimension, i), {start, end, 0, start[0]});
        };
    }
    auto apart(int a, int b) const {
        return [this, a, b](int i, int j) {
            for (const int v : complex.vertices(a, i))
                if (std::ranges::count(complex.vertices(b, j), v)) return false;
            return true;
        };
    }
};

// All that are expected, none twice.
bool holds(const Candidates& found, const Pairs& expected) {
    std::vector<Candidate> pairs(found.pairs().begin(), found.pairs().end());
    std::ranges::sort(pairs);
    return !expected.empty() && std::ranges::adjacent_find(pairs) == pairs.end() &&
           std::ranges::includes(pairs, expected);
}

template <int k>
void holdTree(const CcdScene& scene, Workers& workers) {
    INFO("k = " << k);
    const KDopTree<k> points(scene.complex.count(0), scene.bounds<k>(0), workers);
    const KDopTree<k> edges(scene.complex.count(1), scene.bounds<k>(1), workers);
    const KDopTree<k> triangles(scene.complex.count(2), scene.bounds<k>(2), workers);
    Candidates found;
    edges.selfPairs(found, workers, scene.apart(1, 1));
    CHECK(holds(found, scene.edgeEdge));
    auto count = found.pairs().size();
    points.pairs(triangles, found, workers, scene.apart(0, 2));
    CHECK(holds(found, scene.pointTriangle));
    count += found.pairs().size();
    test::note("candidates, k = " + std::to_string(k), static_cast<double>(count));
}

// Triangles behind the points in one grid.
void holdGrid(const CcdScene& scene, Workers& workers) {
    Candidates found;
    HashGrid grid;
    grid.build(scene.complex.count(1), scene.bounds<6>(1), workers);
    grid.selfPairs(found, workers, scene.apart(1, 1));
    CHECK(holds(found, scene.edgeEdge));
    const int points = scene.complex.count(0), triangles = scene.complex.count(2);
    const auto point = scene.bounds<6>(0), triangle = scene.bounds<6>(2);
    const auto apart = scene.apart(0, 2);
    grid.build(
        points + triangles, [&](int i) { return i < points ? point(i) : triangle(i - points); },
        workers);
    grid.selfPairs(found, workers,
                   [&](int a, int b) { return a < points && b >= points && apart(a, b - points); });
    Pairs expected;
    for (const auto& [a, b] : scene.pointTriangle) expected.insert({a, b + points});
    CHECK(holds(found, expected));
}

}  // namespace

TEST_CASE("every true pair of real frames is a candidate and told in time",
          "[broadphase][ccd][BP1][BP3][CC5]") {
    if (!test::haveCcdData()) return;
    Workers workers(2);
    for (const char* name : {"cloth-funnel", "rod-twist"}) {
        const CcdScene scene(test::ccdData() / "scenes" / name);
        test::note(std::string(name) + ", true pairs",
                   static_cast<double>(scene.edgeEdge.size() + scene.pointTriangle.size()));
        CHECK(test::report("  missed by queries", scene.missed, 0));
        CHECK(test::report("  told late", scene.late, 0));
        test::note("  told where they pass by", scene.invented);
        holdTree<6>(scene, workers);
        holdTree<14>(scene, workers);
        holdTree<18>(scene, workers);
        holdTree<26>(scene, workers);
        holdGrid(scene, workers);
    }
}
