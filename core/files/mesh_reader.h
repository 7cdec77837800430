// What the readers of OBJ, PLY and PC2 share; not for use outside them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_file.h"

namespace plait {

// Takes the first line off `rest`, without its end: "\n", "\r\n" or "\r" ("\r\r\n" is one, too).
std::string_view takeLine(std::string_view& rest);

constexpr std::string_view blanks = " \t\r\n\v\f";

// Appends the words of a line, which blanks part.
void splitWords(std::string_view line, std::vector<std::string_view>& words);

// A piece of the file as it may stand in a message: quoted, printable, not long.
std::string quoted(std::string_view text);

// A face of more than 3 corners, which stands in the mesh as a fan until all vertices are read.
struct Polygon {
    std::size_t firstTriangle, corners;
    std::size_t position;  // line or byte
};

// Gathers the mesh and knows where the reader is, so that every complaint says so.
struct MeshBuilder {
    std::string file;
    const char* unit = "";     // "byte " in binary data
    std::size_t position = 0;  // line or byte
    std::string note;          // behind the cause of every complaint
    std::vector<Vec<double>> positions;
    Simplices simplices;  // polygons as fans
    std::vector<Polygon> polygons;

    [[noreturn]] void fail(const std::string& cause) const;

    // A whole word as a finite number or an integer.
    double number(std::string_view word) const;
    long long integer(std::string_view word) const;

    void addEdge(int a, int b);
    void addFace(std::span<const int> corners);

    // Triangle strips parted by -1, turning like their first triangle; what repeats a vertex only
    // leads from one part of a strip to the next.
    void addStrips(std::span<const int> corners);

    // What joins the vertices, polygons still as fans: the same for all meshes with the same faces.
    SimplicialComplex fans() const;

    // The mesh, polygons split by their shape. Takes the positions.
    Shape finished();

private:
    void split(const Polygon& polygon);
};

// Refuses a file as a whole, at line 0.
[[noreturn]] void failAsWhole(const std::filesystem::path& file, const std::string& cause);

// All of a file.
std::string contentOf(const std::filesystem::path& path);

// What stands behind a byte order mark, if there is one; fails through `mesh` if it is UTF-16's.
std::string_view textOf(std::string_view content, MeshBuilder& mesh);

// What the folder of `path` holds, sorted.
std::vector<std::filesystem::path> pathsBeside(const std::filesystem::path& path);

// In small letters.
std::string extensionOf(const std::filesystem::path& path);

// readMesh (mesh_file.h) before polygons are split.
MeshBuilder gatherMesh(const std::filesystem::path& path);

void readObj(MeshBuilder& mesh, std::string_view content);
void readPly(MeshBuilder& mesh, std::string_view content);

}  // namespace plait
