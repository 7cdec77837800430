// What is wrong with a mesh that someone else made: mended or said before anything is built on it.
#pragma once

#include "../complex/shapes.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace plait {

// What its user wants of a mesh.
struct MeshWanted {
    bool solid = false;  // a body: closed, its triangles counter-clockwise from outside; else cloth
    // m, of its height (y) if it is a body, else of the longest side of its box; `usual` tells
    // which unit it may be in instead. 0: of any size.
    double least = 0, usual = 0, most = 0;
};

struct InspectedMesh {
    Shape shape;                        // to the bit what was read, where nothing was to be mended
    std::vector<int> vertices;          // by vertex of the shape: which of the file, from 0
    std::vector<std::string> warnings;  // what was mended and what looks odd, one line each
    std::filesystem::path file;

    // "file: cause", and a vertex of the shape as the file counts: from 1 in OBJ, from 0 in PLY.
    std::string told(const std::string& cause) const;
    std::string name(int vertex) const;
};

// The table is in README.md. Throws std::invalid_argument, one line, for what cannot be mended.
// About n log n in time.
InspectedMesh inspect(Shape mesh, const std::filesystem::path& file, const MeshWanted& wanted = {});

// Throws std::invalid_argument, one line that names an edge and a triangle or two vertices, if the
// mesh goes through itself or touches itself where its vertices are at `positions` (m).
void refuseCrossing(const InspectedMesh& mesh, std::span<const Vec<double>> positions);

}  // namespace plait
