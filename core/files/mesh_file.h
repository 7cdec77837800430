// Triangle meshes, curves and point clouds from OBJ and PLY files.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "../complex/shapes.h"

namespace plait {

// A mesh file that cannot be read. The message is one line, "file:line: cause", in the body of a
// binary file "file:byte N: cause" (counted from 0); line 0 is the file as a whole.
struct MeshFileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Reads a Wavefront OBJ or a PLY file (ascii or binary of either byte order), told apart by the
// extension. Units are the file's.
//
// Vertices keep their order, used or not. A face a b c d ... becomes the fan (a, b, c), (a, c, d),
// ...: quads are split to the left, along their first diagonal (M 4.3). From OBJ also `l` lines as
// edges (a closed line may end where it began) and negative indices; `p` adds nothing, since every
// vertex is a point. From PLY the elements vertex (x, y, z), face (vertex_indices or vertex_index)
// and edge (vertex1, vertex2). Texture coordinates, normals, groups, materials and other PLY
// elements and properties are skipped.
//
// What is wrong with the mesh itself is for inspection/inspect.h to say.
//
// Throws MeshFileError. Memory is bounded by a multiple of the file size, whatever the file
// declares.
Shape readMesh(const std::filesystem::path& path);

}  // namespace plait
