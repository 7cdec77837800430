// Ready-made shapes: a complex and where its vertices are. Lengths in metres.
//
// Builders throw std::invalid_argument that names the parameter: counts below the least that makes
// the shape or too large for int indices, lengths that are not finite and positive, a frame whose
// directions are not of unit length and perpendicular (to 1e-6).
#pragma once

#include <vector>

#include "../numbers/math.h"
#include "complex.h"

namespace plait {

struct Shape {
    SimplicialComplex complex;
    std::vector<Vec<double>> positions;
};

// Where a shape stands: its own x runs along `across`, its y along `up`, its z along across x up.
struct Frame {
    Vec<double> origin{0, 0, 0};
    Vec<double> across{1, 0, 0};
    Vec<double> up{0, 1, 0};
};

struct GridParameters {
    int columns = 2;  // of vertices, at least 2
    int rows = 2;     // of vertices, at least 2
    double width = 1;
    double height = 1;
};

// A rectangle from the origin to (width, height, 0). Vertex i = row * columns + column. Each cell's
// diagonal runs from (row, column) to (row + 1, column + 1); its triangles are 2 cell and 2 cell +
// 1, cell = row * (columns - 1) + column. Normals along z.
Shape grid(const GridParameters& parameters, const Frame& frame = {});

struct DiscParameters {
    int rings = 1;  // of triangles around the centre, at least 1
    double radius = 1;
};

// A disc in the plane z = 0 around the origin, normals along z. Vertex 0 is the centre; ring r has
// 6 r vertices, from the x axis towards y, the first of them vertex 1 + 3 r (r - 1); 6 rings^2
// triangles.
Shape disc(const DiscParameters& parameters, const Frame& frame = {});

struct TubeParameters {
    int segments = 16;  // around, at least 3
    int rings = 2;      // of vertices, at least 2
    double radius = 1;
    double height = 1;
};

// An open cylinder around y, from y = 0 to height, normals outward. Vertex i = ring * segments +
// segment; segment 0 is on the x axis, the next towards -z (counter-clockwise seen from above).
Shape tube(const TubeParameters& parameters, const Frame& frame = {});

struct SphereParameters {
    int subdivisions = 2;  // 0 to 10: 10 * 4^subdivisions + 2 vertices
    double radius = 1;
};

// An icosahedron around the origin, each triangle cut in four as often as told, all vertices on the
// sphere, normals outward. The vertices of the coarser spheres come first.
Shape sphere(const SphereParameters& parameters, const Frame& frame = {});

struct HelixParameters {
    int links = 16;  // at least 1
    double radius = 1;
    double turns = 1;    // at most 1e5
    double pitch = 0.1;  // rise in one turn, 0 or more
};

// A right-handed coil around y of straight links, vertices in order, starting at (radius, 0, 0).
Shape helix(const HelixParameters& parameters, const Frame& frame = {});

struct ChainParameters {
    int links = 1;  // at least 1
    Vec<double> from{0, 0, 0};
    Vec<double> to{1, 0, 0};  // not `from`
};

// A straight curve of equal links, vertices in order; edge i joins vertices i and i + 1.
Shape chain(const ChainParameters& parameters);

struct BlockParameters {
    int columns = 1;  // of cells along x, at least 1
    int rows = 1;     // of cells along y, at least 1
    int layers = 1;   // of cells along z, at least 1
    double width = 1;
    double height = 1;
    double depth = 1;
};

// A box from the origin to (width, height, depth), six tetrahedra a cell around the diagonal from
// its lowest to its highest corner (Kuhn's; neighbouring cells match), all of positive volume.
// Vertex i = (layer * (rows + 1) + row) * (columns + 1) + column.
Shape block(const BlockParameters& parameters, const Frame& frame = {});

}  // namespace plait
