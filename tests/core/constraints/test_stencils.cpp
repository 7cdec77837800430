// How many constraints a mesh has, and their colours.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/complex/shapes.h>
#include <plait/sets/coloring.h>
#include <plait/stencils.h>

#include <algorithm>
#include <set>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

double ratio(const std::vector<int>& stencils, int arity, int simplices) {
    return static_cast<double>(stencils.size()) / arity / simplices;
}

Range all(const SimplicialComplex& complex) { return {0, complex.count(0)}; }

// What is missing at borders goes as one over the length of a side.
void converges(const std::string& what, const std::vector<double>& ratios, double limit) {
    for (std::size_t i = 1; i < ratios.size(); ++i)
        CHECK(std::fabs(ratios[i] - limit) < 0.55 * std::fabs(ratios[i - 1] - limit) + 1e-12);
    CHECK(
        report(what + ", of " + std::to_string(limit), std::fabs(ratios.back() / limit - 1), 0.05));
}

}  // namespace

// By Euler: a triangle mesh has 3/2 edges a triangle, a chain as many joints as links; a cube cut
// in six tetrahedra has 7 edges and 12 triangles a vertex.
TEST_CASE("stencils: constraints a simplex are those of the mesh's dimension", "[DC4]") {
    std::vector<double> joints, edges, hinges, corners, tetEdges, tetTriangles;
    for (const int n : {4, 8, 16, 32}) {
        const SimplicialComplex line = chain({.links = n}).complex;
        CHECK(ratio(edgeStencils(line, all(line)), 2, n) == 1);
        joints.push_back(ratio(jointStencils(line, all(line)), 3, n));

        const SimplicialComplex sheet = grid({.columns = n + 1, .rows = n + 1}).complex;
        edges.push_back(ratio(edgeStencils(sheet, all(sheet)), 2, sheet.count(2)));
        hinges.push_back(ratio(hingeStencils(sheet, all(sheet)), 4, sheet.count(2)));
        corners.push_back(ratio(cornerStencils(sheet, all(sheet)), 3, sheet.count(2)));

        const SimplicialComplex body = block({.columns = n, .rows = n, .layers = n}).complex;
        tetEdges.push_back(ratio(edgeStencils(body, all(body)), 2, body.count(3)));
        tetTriangles.push_back(ratio(triangleStencils(body, all(body)), 3, body.count(3)));
    }
    converges("joints a link", joints, 1);
    converges("edges a triangle", edges, 1.5);
    converges("hinges a triangle", hinges, 1.5);
    for (const double three : corners) CHECK(three == 3);
    converges("edges a tetrahedron", tetEdges, 7.0 / 6);
    converges("triangles a tetrahedron", tetTriangles, 2);
    // What has no border has them from the start.
    for (int n = 1; n <= 3; ++n) {
        const SimplicialComplex ball = sphere({.subdivisions = n}).complex;
        CHECK(ratio(edgeStencils(ball, all(ball)), 2, ball.count(2)) == 1.5);
        CHECK(ratio(hingeStencils(ball, all(ball)), 4, ball.count(2)) == 1.5);
    }
}

TEST_CASE("stencils: no two of a colour share a vertex, and each has the lowest it may", "[MS6]") {
    Random random(5);
    for (const int arity : {1, 2, 3, 4})
        for (const int vertices : {4, 40, 400}) {
            std::vector<int> stencils;
            for (int i = 0; i < 300; ++i) {
                std::set<int> corners;
                while (std::ssize(corners) < arity) corners.insert(random.below(vertices));
                stencils.insert(stencils.end(), corners.begin(), corners.end());
            }
            const std::vector<int> colors = greedyColors(stencils, arity, vertices);
            REQUIRE(colors.size() == 300);
            const auto taken = [&](std::size_t before, std::size_t i, int color) {
                for (std::size_t j = 0; j < before; ++j)
                    for (int a = 0; colors[j] == color && a < arity; ++a)
                        for (int b = 0; b < arity; ++b)
                            if (stencils[j * arity + a] == stencils[i * arity + b]) return true;
                return false;
            };
            for (std::size_t i = 0; i < colors.size(); ++i) {
                REQUIRE_FALSE(taken(i, i, colors[i]));
                for (int lower = 0; lower < colors[i]; ++lower) REQUIRE(taken(i, i, lower));
            }
        }
}
