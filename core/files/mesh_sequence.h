// A character's surface as other programs give it: meshes of one topology, one a frame.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "mesh_file.h"

namespace plait {

struct MeshSequenceOptions {
    double frameRate = 24;  // meshes in a second, above 0
    double start = 0;       // s, when the first is there; before that it stands still
    bool smooth = true;     // between meshes: Catmull-Rom, or straight
};

// Calls visit(bytes) with the content of every file that belongs to `path`, in the order in which
// they are read: those of a sequence (MeshSequence), or a mesh alone. Throws MeshFileError.
void forContents(const std::filesystem::path& path,
                 const std::function<void(std::string_view bytes)>& visit);

// Before its first mesh and behind its last a sequence holds still; if smooth, it comes to rest
// there, and so its velocity is continuous at all times. Copies share what was read.
class MeshSequence {
public:
    // Reads `path`, which is one of two:
    //
    // A pattern with one `*` in the name of the files, OBJ or PLY: all that match as in a shell (no
    // hidden files but for a pattern that begins with a dot), by the last number in what stands for
    // the `*`. A minus right before the number is its sign, unless a letter or a digit stands right
    // before the minus: body.-0001 and body--0001 are -1, body-0001 is 1. Files with such a dash
    // beside files with none there are refused. Numbers may start and step as they like, but with
    // no gap. Polygons are split in all files as in the first.
    //
    // A PC2 file (point cache 2, as `--export pc2` writes it; .PC2 is the same) beside an OBJ or
    // PLY of the same name that holds the faces: an OBJ before a PLY, small letters before capitals
    // in the extension. Samples count by its rate in frames; its own first frame is ignored.
    //
    // Throws MeshFileError (mesh_file.h), and std::invalid_argument for a rate or start out of
    // range. Memory is bounded by a multiple of the files' size.
    explicit MeshSequence(const std::filesystem::path& path,
                          const MeshSequenceOptions& options = {});

    const Shape& first() const { return *first_; }
    const std::filesystem::path& file() const { return file_; }      // that of first()'s faces
    int count() const { return static_cast<int>(meshes_->size()); }  // meshes, 1 or more
    double end() const;                                              // s, when the last is there

    // Where its vertices are at time t (s): an Animation for World::pin. `positions` has one entry
    // a vertex of first(), in m if the files are.
    void operator()(double t, std::span<Vec<double>> positions) const;

private:
    using Meshes = std::vector<std::vector<Vec<double>>>;

    MeshSequenceOptions options_;
    std::filesystem::path file_;
    std::shared_ptr<const Shape> first_;
    std::shared_ptr<const Meshes> meshes_;
};

// From one sequence to another of the same faces: `weight(t)`, 0 to 1, is the second's part at time
// t (s), the rest the first's. An Animation for World::pin. Throws std::invalid_argument where
// their faces differ or there is no weight.
std::function<void(double t, std::span<Vec<double>> positions)> blend(
    const MeshSequence& first, const MeshSequence& second, std::function<double(double t)> weight);

}  // namespace plait
