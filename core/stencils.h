// Which vertices each constraint of a set joins, read off the complex: arity vertices a constraint,
// one after another, of the simplices that lie wholly in `range`.
#pragma once

#include "complex/complex.h"
#include "constraints/kinds.h"
#include "constraints/rows.h"

#include <vector>

namespace plait {

std::vector<int> edgeStencils(const SimplicialComplex& complex, Range range);      // 2, for Stretch
std::vector<int> triangleStencils(const SimplicialComplex& complex, Range range);  // 3, for Shear
// Each corner of each triangle in the middle of its other two vertices: 3, for Angle.
std::vector<int> cornerStencils(const SimplicialComplex& complex, Range range);
// Vertices where exactly two edges meet and no triangle, between their neighbours: 3, for Angle.
std::vector<int> jointStencils(const SimplicialComplex& complex, Range range);
std::vector<int> hingeStencils(const SimplicialComplex& complex, Range range);  // 4, for Bend
std::vector<int> pointStencils(Range range);                                    // 1, for contacts

// Bending of a sheet of flexural rigidity D (N m): energy D |e|^2 / (2 (A1 + A2)) (theta - rest)^2
// a hinge, A1 and A2 its triangles' areas (discrete shells, Grinspun et al. 2003, without their
// factor 3: so scaled, a grid bent to a cylinder along its edges has the plate's energy D / 2 R^2
// an area). D = 0 gives no rows; a triangle without area has no angles, and its hinges do not
// act.
Rows<Bend> bendRows(const SimplicialComplex& complex, Range range,
                    std::span<const Vec<double>> rest, double rigidity);

// Bending of a curve of stiffness B (N m^2): energy B / (2 l) (theta - rest)^2 a joint, l the mean
// length of its two edges.
Rows<Angle> curveBendRows(const SimplicialComplex& complex, Range range,
                          std::span<const Vec<double>> rest, double stiffness);

}  // namespace plait
