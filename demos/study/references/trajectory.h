// Where everything was, frame by frame, and how far two such records are apart.
#pragma once

#include <plait/numbers/math.h>

#include <string>
#include <vector>

namespace plait {

// Positions in m: those of frame f + 1 of vertex i at [f][i]. The start is not among them.
using Trajectory = std::vector<std::vector<Vec<double>>>;

// Root of the mean square distance in the first `frames` frames, or in that of index `frame`, over
// the `moving` vertices that are not pinned and so the only ones that are apart: in m, infinite
// where a number is not finite. Throws std::invalid_argument where a frame is missing or vertices
// differ in number.
double rmsDistance(const Trajectory& a, const Trajectory& b, int frames, int moving);
double rmsDistanceAt(const Trajectory& a, const Trajectory& b, int frame, int moving);

// A line a vertex, "frame,vertex,x,y,z", in numbers that read back as the same.
std::string csvOf(const Trajectory& trajectory);
// Throws FileError that begins with `name`.
Trajectory trajectoryFrom(const std::string& csv, const std::string& name);

}  // namespace plait
