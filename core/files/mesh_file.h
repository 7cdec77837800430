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
// extension, in small letters or capitals. Units are the file's.
//
// Text may begin with UTF-8's byte order mark, and its lines end in LF, CR LF or CR; words beyond
// ASCII may stand in comments and names. UTF-16 is refused.
//
// Vertices keep their order, used or not. A quad a b c d is split along its first diagonal, a c
// (M 4.3), if it is convex; other polygons by their shape, seen along their normal, whichever way
// they turn. One that crosses itself is refused.
//
// From OBJ also `l` lines as edges (a closed line may end where it began) and negative indices; `p`
// adds nothing, since every vertex is a point; what follows a vertex's x y z (w, colours) is
// skipped. A backslash joins a line to the next, blanks behind it or not. From PLY the elements
// vertex (x, y, z), face and tristrips (vertex_indices or vertex_index; -1 parts strips) and edge
// (vertex1, vertex2); in ascii, lines may end wherever values do. Texture coordinates, normals,
// groups, materials and other PLY elements and properties are skipped; free-form geometry in OBJ,
// and other elements of PLY with vertex_indices, are refused by name.
//
// What is wrong with the mesh itself is for inspection/inspect.h to say.
//
// Throws MeshFileError. Memory is bounded by a multiple of the file size, whatever the file
// declares.
Shape readMesh(const std::filesystem::path& path);

}  // namespace plait
