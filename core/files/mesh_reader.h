// What the readers of OBJ, PLY and PC2 share; not for use outside them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_file.h"

namespace plait {

// Takes the first line off `rest`, without its end ("\n" or "\r\n").
std::string_view takeLine(std::string_view& rest);

// Appends the words of a line, which blanks and tabs part.
void splitWords(std::string_view line, std::vector<std::string_view>& words);

// A piece of the file as it may stand in a message: quoted, printable, not long.
std::string quoted(std::string_view text);

// Gathers the mesh and knows where the reader is, so that every complaint says so.
struct MeshBuilder {
    std::string file;
    const char* unit = "";     // "byte " in binary data
    std::size_t position = 0;  // line or byte
    std::vector<Vec<double>> positions;
    Simplices simplices;

    [[noreturn]] void fail(const std::string& cause) const;

    // A whole word as a finite number or an integer.
    double number(std::string_view word) const;
    long long integer(std::string_view word) const;

    void addEdge(int a, int b);
    void addFace(std::span<const int> corners);

    Shape finished();
};

// All of a file; fails through `mesh`.
std::string contentOf(const std::filesystem::path& path, const MeshBuilder& mesh);

Shape readObj(const std::string& file, std::string_view content);
Shape readPly(const std::string& file, std::string_view content);

}  // namespace plait
