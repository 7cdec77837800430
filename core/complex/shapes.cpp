#include "shapes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "../numbers/elementary.h"

namespace plait {

namespace {

using Point = Vec<double>;

[[noreturn]] void fail(const std::string& parameter, const std::string& demand) {
    throw std::invalid_argument(parameter + " must be " + demand);
}

void requireAtLeast(int least, int value, const char* parameter) {
    if (value < least) fail(parameter, "at least " + std::to_string(least));
}

void requirePositive(double value, const char* parameter) {
    if (!(value > 0) || !std::isfinite(value)) fail(parameter, "finite and above 0");
}

void requireFinite(const Point& value, const char* parameter) {
    if (!std::isfinite(dot(value, value))) fail(parameter, "finite");
}

// Products of counts are formed in double, where none overflows. The bound leaves room for the
// edges of the triangles, six a vertex, in int.
void requireIndexable(double vertices, const char* parameters) {
    if (vertices > 1 << 27) fail(parameters, "fewer: too many vertices for an int");
}

void place(std::vector<Point>& positions, const Frame& frame) {
    requireFinite(frame.origin, "frame: origin");
    const auto isUnit = [](const Point& a) { return std::abs(length(a) - 1) < 1e-6; };
    if (!isUnit(frame.across)) fail("frame: across", "of unit length");
    if (!isUnit(frame.up)) fail("frame: up", "of unit length");
    if (!(std::abs(dot(frame.across, frame.up)) < 1e-6))
        fail("frame: up", "perpendicular to across");
    const Point out = cross(frame.across, frame.up);
    for (Point& p : positions) p = frame.origin + (p.x * frame.across + p.y * frame.up + p.z * out);
}

// The unit vector at a fraction of the full turn: from x towards y.
Point onCircle(double turn) {
    const double angle = 2 * std::numbers::pi * turn;
    return {cosine(angle), sine(angle), 0};
}

// Cut along the diagonal a c, to the left as mesh files are.
void addQuad(Simplices& simplices, int a, int b, int c, int d) {
    simplices.triangles.push_back({a, b, c});
    simplices.triangles.push_back({a, c, d});
}

Shape curve(std::vector<Point> positions) {
    Simplices simplices;
    const int count = static_cast<int>(positions.size());
    for (int i = 0; i + 1 < count; ++i) simplices.edges.push_back({i, i + 1});
    return {SimplicialComplex(count, simplices), std::move(positions)};
}

// Each triangle in four; the midpoint of edge e becomes vertex e behind the old ones, on the unit
// sphere.
SimplicialComplex subdivided(const SimplicialComplex& coarse, std::vector<Point>& positions) {
    const int corners = coarse.count(0);
    for (int e = 0; e < coarse.count(1); ++e) {
        const auto [a, b] = coarse.edge(e);
        const Point sum = positions[a] + positions[b];
        positions.push_back(1 / length(sum) * sum);
    }
    Simplices fine;
    for (int t = 0; t < coarse.count(2); ++t) {
        // Face j lies opposite vertex j of the ascending order; the given orientation may swap two.
        const auto [a, b, c] = coarse.triangle(t);
        const bool even = coarse.sign(2, t) > 0;
        const auto edges = coarse.faces(2, t);
        const int bc = corners + edges[0], ca = corners + edges[even ? 1 : 2],
                  ab = corners + edges[even ? 2 : 1];
        for (const auto& triangle : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            fine.triangles.push_back(triangle);
    }
    return SimplicialComplex(corners + coarse.count(1), fine);
}

// Kuhn's six tetrahedra of a cell are its six ways from the lowest corner to the highest along the
// axes. Ways that are odd permutations of x y z are left-handed and have two corners swapped.
Simplices blockSimplices(const BlockParameters& p) {
    const int x = 1, y = p.columns + 1, z = y * (p.rows + 1);
    Simplices simplices;
    for (int layer = 0; layer < p.layers; ++layer)
        for (int row = 0; row < p.rows; ++row)
            for (int column = 0; column < p.columns; ++column) {
                const int low = layer * z + row * y + column, high = low + x + y + z;
                for (const auto& [first, second] : {std::pair(x, y), {y, z}, {z, x}})
                    simplices.tetrahedra.push_back({low, low + first, low + first + second, high});
                for (const auto& [first, second] : {std::pair(y, x), {z, y}, {x, z}})
                    simplices.tetrahedra.push_back({low, low + first + second, low + first, high});
            }
    return simplices;
}

}  // namespace

Shape grid(const GridParameters& p, const Frame& frame) {
    requireAtLeast(2, p.columns, "grid: columns");
    requireAtLeast(2, p.rows, "grid: rows");
    requirePositive(p.width, "grid: width");
    requirePositive(p.height, "grid: height");
    requireIndexable(double(p.columns) * p.rows, "grid: columns and rows");

    std::vector<Point> positions;
    for (int row = 0; row < p.rows; ++row)
        for (int column = 0; column < p.columns; ++column)
            positions.push_back(
                {p.width * column / (p.columns - 1), p.height * row / (p.rows - 1), 0});
    Simplices simplices;
    for (int row = 0; row + 1 < p.rows; ++row)
        for (int column = 0; column + 1 < p.columns; ++column) {
            const int i = row * p.columns + column, above = i + p.columns;
            addQuad(simplices, i, i + 1, above + 1, above);
        }
    place(positions, frame);
    return {SimplicialComplex(p.columns * p.rows, simplices), std::move(positions)};
}

Shape disc(const DiscParameters& p, const Frame& frame) {
    requireAtLeast(1, p.rings, "disc: rings");
    requirePositive(p.radius, "disc: radius");
    requireIndexable(3.0 * p.rings * (p.rings + 1.0), "disc: rings");

    std::vector<Point> positions{{0, 0, 0}};
    Simplices simplices;
    for (int ring = 1; ring <= p.rings; ++ring) {
        const int inner = ring - 1;
        const auto outerVertex = [&](int i) { return 1 + 3 * ring * inner + i % (6 * ring); };
        const auto innerVertex = [&](int i) {
            return inner == 0 ? 0 : 1 + 3 * inner * (inner - 1) + i % (6 * inner);
        };
        for (int i = 0; i < 6 * ring; ++i)
            positions.push_back(p.radius * ring / p.rings * onCircle(i / (6.0 * ring)));
        for (int side = 0; side < 6; ++side)
            for (int i = 0; i < ring; ++i) {
                const int out = side * ring + i, in = side * inner + i;
                simplices.triangles.push_back(
                    {innerVertex(in), outerVertex(out), outerVertex(out + 1)});
                if (i < inner)
                    simplices.triangles.push_back(
                        {innerVertex(in), outerVertex(out + 1), innerVertex(in + 1)});
            }
    }
    place(positions, frame);
    return {SimplicialComplex(static_cast<int>(positions.size()), simplices), std::move(positions)};
}

Shape tube(const TubeParameters& p, const Frame& frame) {
    requireAtLeast(3, p.segments, "tube: segments");
    requireAtLeast(2, p.rings, "tube: rings");
    requirePositive(p.radius, "tube: radius");
    requirePositive(p.height, "tube: height");
    requireIndexable(double(p.segments) * p.rings, "tube: segments and rings");

    std::vector<Point> positions;
    for (int ring = 0; ring < p.rings; ++ring)
        for (int segment = 0; segment < p.segments; ++segment) {
            const Point around = p.radius * onCircle(double(segment) / p.segments);
            positions.push_back({around.x, p.height * ring / (p.rings - 1), -around.y});
        }
    Simplices simplices;
    for (int ring = 0; ring + 1 < p.rings; ++ring)
        for (int segment = 0; segment < p.segments; ++segment) {
            const int i = ring * p.segments + segment;
            const int next = ring * p.segments + (segment + 1) % p.segments;
            addQuad(simplices, i, next, next + p.segments, i + p.segments);
        }
    place(positions, frame);
    return {SimplicialComplex(p.segments * p.rings, simplices), std::move(positions)};
}

Shape sphere(const SphereParameters& p, const Frame& frame) {
    requireAtLeast(0, p.subdivisions, "sphere: subdivisions");
    if (p.subdivisions > 10) fail("sphere: subdivisions", "at most 10");
    requirePositive(p.radius, "sphere: radius");

    const double g = std::numbers::phi;
    std::vector<Point> positions{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                 {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                 {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    const Simplices icosahedron{
        .edges = {},
        .triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}},
        .tetrahedra = {}};
    SimplicialComplex complex(12, icosahedron);
    for (Point& x : positions) x = 1 / length(x) * x;
    for (int i = 0; i < p.subdivisions; ++i) complex = subdivided(complex, positions);
    for (Point& x : positions) x = p.radius * x;
    place(positions, frame);
    return {std::move(complex), std::move(positions)};
}

Shape helix(const HelixParameters& p, const Frame& frame) {
    requireAtLeast(1, p.links, "helix: links");
    requirePositive(p.radius, "helix: radius");
    requirePositive(p.turns, "helix: turns");
    if (p.turns > 1e5) fail("helix: turns", "at most 100000");  // plait::sine ends at 1e6 rad
    if (!(p.pitch >= 0) || !std::isfinite(p.pitch)) fail("helix: pitch", "finite and at least 0");
    requireIndexable(p.links, "helix: links");

    std::vector<Point> positions;
    for (int i = 0; i <= p.links; ++i) {
        const double turn = p.turns * i / p.links;
        const Point around = p.radius * onCircle(turn);
        positions.push_back({around.x, p.pitch * turn, -around.y});
    }
    place(positions, frame);
    return curve(std::move(positions));
}

Shape chain(const ChainParameters& p) {
    requireAtLeast(1, p.links, "chain: links");
    requireFinite(p.from, "chain: from");
    requireFinite(p.to, "chain: to");
    if (p.from == p.to) fail("chain: to", "another point than from");
    requireIndexable(p.links, "chain: links");

    std::vector<Point> positions;
    positions.reserve(p.links + 1);
    for (int i = 0; i < p.links; ++i)
        positions.push_back(p.from + double(i) / p.links * (p.to - p.from));
    positions.push_back(p.to);
    return curve(std::move(positions));
}

Shape block(const BlockParameters& p, const Frame& frame) {
    requireAtLeast(1, p.columns, "block: columns");
    requireAtLeast(1, p.rows, "block: rows");
    requireAtLeast(1, p.layers, "block: layers");
    requirePositive(p.width, "block: width");
    requirePositive(p.height, "block: height");
    requirePositive(p.depth, "block: depth");
    requireIndexable((p.columns + 1.0) * (p.rows + 1.0) * (p.layers + 1.0) * 4,
                     "block: columns, rows and layers");

    std::vector<Point> positions;
    for (int layer = 0; layer <= p.layers; ++layer)
        for (int row = 0; row <= p.rows; ++row)
            for (int column = 0; column <= p.columns; ++column)
                positions.push_back({p.width * column / p.columns, p.height * row / p.rows,
                                     p.depth * layer / p.layers});
    place(positions, frame);
    return {SimplicialComplex(static_cast<int>(positions.size()), blockSimplices(p)),
            std::move(positions)};
}

}  // namespace plait
