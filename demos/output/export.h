// A run for other programs: a sequence of meshes, or a point cache.
//
//   obj, ply  export/00000.obj ...: a mesh a frame, from the start on; triangles, torn as they are
//             in that frame, and edges that no triangle has
//   pc2       export/points.pc2: every vertex of every frame, and export/points.obj, the mesh they
//             belong to at the start
//
// Metres, y up, as the solver has them.
#pragma once

#include "demos/runs/run_folder.h"

#include <span>
#include <string>
#include <vector>

namespace plait {

const std::vector<std::string>& exportFormats();

// Writes frames 0 to `last` of the folder's cache. Throws FileError.
void exportRun(const RunFolder& folder, const Run& run, int last, const std::string& format);

// The bytes of one file. `title` becomes a comment.
std::string objOf(const SimplicialComplex& complex, std::span<const Vec<double>> positions,
                  const std::string& title);
std::string plyOf(const SimplicialComplex& complex, std::span<const Vec<double>> positions,
                  const std::string& title);  // binary, little endian, float
// A PC2 file's 32 bytes ahead of its points: "POINTCACHE2" and a zero, int32 version 1 and points,
// float first frame 0 and frames between samples 1, int32 samples.
std::string pc2Header(int points, int samples);

}  // namespace plait
