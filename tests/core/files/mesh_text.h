// Meshes from text that a test has at hand.
#pragma once

#include "tests/scratch_folder.h"

#include <plait/files/mesh_file.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace plait::test {

using Triangles = std::vector<std::array<int, 3>>;

inline void write(const std::filesystem::path& path, const std::string& content) {
    std::filesystem::remove(path);
    std::ofstream(path, std::ios::binary) << content;
}

inline Shape shapeOf(const std::string& name, const std::string& content) {
    const ScratchFolder folder;
    write(folder / name, content);
    return readMesh(folder / name);
}

inline Triangles triangles(const Shape& shape) {
    Triangles all;
    for (int t = 0; t < shape.complex.count(2); ++t) all.push_back(shape.complex.triangle(t));
    return all;
}

// What `read` says against the folder's files, without the folder.
template <class Read>
std::string refusalIn(const ScratchFolder& folder, const Read& read) {
    try {
        read();
    } catch (const MeshFileError& error) {
        std::string message = error.what();
        const std::string place = (folder / "").string();
        for (std::size_t i; (i = message.find(place)) != std::string::npos;)
            message.erase(i, place.size());
        return message;
    }
    return "accepted";
}

inline std::string refusal(const std::string& name, const std::string& content) {
    const ScratchFolder folder;
    write(folder / name, content);
    return refusalIn(folder, [&] { readMesh(folder / name); });
}

}  // namespace plait::test
