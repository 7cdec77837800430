#include "mesh_sequence.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ranges>
#include <stdexcept>
#include <string>
#include <utility>

#include "../numbers/finite.h"
#include "mesh_reader.h"
#include "numbered_files.h"

namespace plait {
namespace {

namespace fs = std::filesystem;
using Meshes = std::vector<std::vector<Vec<double>>>;

static_assert(std::endian::native == std::endian::little, "PC2 is read as it lies in memory");

std::string counts(const SimplicialComplex& complex) {
    return std::to_string(complex.count(0)) + " vertices, " + std::to_string(complex.count(1)) +
           " edges and " + std::to_string(complex.count(2)) + " triangles";
}

Shape readPattern(const fs::path& pattern, Meshes& meshes, fs::path& file) {
    const NumberedFiles files = filesOf(pattern);
    file = files[0].second;
    MeshBuilder first = gatherMesh(file);
    const SimplicialComplex faces = first.fans();
    Shape shape = first.finished();  // polygons are split as they are in the first mesh
    meshes.push_back(shape.positions);
    for (std::size_t i = 1; i < files.size(); ++i) {
        const auto& [number, path] = files[i];
        MeshBuilder mesh = gatherMesh(path);
        const SimplicialComplex others = mesh.fans();
        const std::string here = counts(others), there = counts(faces);
        if (here != there)
            failAsWhole(path, here + ", but " + files[0].second.string() + " has " + there);
        if (others != faces)
            failAsWhole(path, "its faces differ from those of " + files[0].second.string());
        meshes.push_back(std::move(mesh.positions));
    }
    return shape;
}

bool isPattern(const fs::path& path) {
    return path.filename().string().find('*') != std::string::npos;
}

bool isPc2(const fs::path& path) { return extensionOf(path) == ".pc2"; }

// The mesh that a point cache goes with.
fs::path meshBeside(const fs::path& cache) {
    const std::vector<fs::path> paths = pathsBeside(cache);
    for (const char* const extension : {".obj", ".ply"})
        for (const fs::path& path : std::views::reverse(paths))  // capitals sort first
            if (path.stem() == cache.stem() && extensionOf(path) == extension) return path;
    failAsWhole(cache, "neither an .obj nor a .ply of its name beside it");
}

// "POINTCACHE2" and a zero; int32 version and points; float first frame and frames between samples;
// int32 samples; then three floats a point (demos/output/export.h writes the same).
struct Pc2Header {
    char magic[12];
    std::int32_t version, points;
    float firstFrame, spacing;
    std::int32_t samples;
};
static_assert(sizeof(Pc2Header) == 32);

Pc2Header pc2Header(MeshBuilder& reader, std::string_view content) {
    Pc2Header header;
    if (content.size() < sizeof header) reader.fail("the file ends too early");
    std::memcpy(&header, content.data(), sizeof header);
    if (std::memcmp(header.magic, "POINTCACHE2", 12) != 0) reader.fail("not a PC2 file");
    if (header.version != 1) reader.fail("version " + std::to_string(header.version) + ", not 1");
    if (header.points < 1 || header.samples < 1) reader.fail("no points or no samples");
    if (!(header.spacing > 0) || !std::isfinite(header.spacing))
        reader.fail("its frames between samples must be positive");
    return header;
}

Shape readPc2(const fs::path& path, Meshes& meshes, fs::path& file, double& spacing) {
    MeshBuilder reader;
    reader.file = path.string();
    const std::string content = contentOf(path);
    reader.unit = "byte ";
    const Pc2Header header = pc2Header(reader, content);
    spacing = double{header.spacing};
    const std::size_t points = static_cast<std::size_t>(header.points),
                      samples = static_cast<std::size_t>(header.samples),
                      room = (content.size() - sizeof header) / 12;
    reader.position = content.size();
    if (room / points < samples) reader.fail("the file ends too early");
    if (content.size() != sizeof header + 12 * points * samples)
        reader.fail("more behind the last sample");
    file = meshBeside(path);
    Shape shape = readMesh(file);
    if (shape.positions.size() != points)
        reader.position = 16, reader.fail(std::to_string(points) + " points, but the mesh has " +
                                          std::to_string(shape.positions.size()) + " vertices");
    reader.position = sizeof header;
    meshes.assign(samples, std::vector<Vec<double>>(points));
    for (std::vector<Vec<double>>& mesh : meshes)
        for (Vec<double>& x : mesh) {
            float at[3];
            std::memcpy(at, &content[reader.position], sizeof at);
            x = {double{at[0]}, double{at[1]}, double{at[2]}};
            if (!isFinite(x)) reader.fail("a coordinate that is not finite");
            reader.position += sizeof at;
        }
    shape.positions = meshes[0];
    return shape;
}

}  // namespace

void forContents(const fs::path& path, const std::function<void(std::string_view)>& visit) {
    std::vector<fs::path> files{path};
    if (isPc2(path)) files.push_back(meshBeside(path));
    if (isPattern(path) && !fs::exists(path)) {
        files.clear();
        for (const auto& [number, file] : filesOf(path)) files.push_back(file);
    }
    for (const fs::path& file : files) visit(contentOf(file));
}

MeshSequence::MeshSequence(const fs::path& path, const MeshSequenceOptions& options)
    : options_(options) {
    if (!(options.frameRate > 0) || !std::isfinite(options.frameRate))
        throw std::invalid_argument("a sequence's frame rate must be positive");
    if (!std::isfinite(options.start))
        throw std::invalid_argument("a sequence's start must be finite");
    Meshes meshes;
    double spacing = 1;
    const bool pattern = isPattern(path);
    if (!pattern && !isPc2(path)) failAsWhole(path, "neither a pattern with a * nor a .pc2");
    first_ = std::make_shared<const Shape>(pattern ? readPattern(path, meshes, file_)
                                                   : readPc2(path, meshes, file_, spacing));
    meshes_ = std::make_shared<const Meshes>(std::move(meshes));
    options_.frameRate /= spacing;
}

double MeshSequence::end() const { return options_.start + (count() - 1) / options_.frameRate; }

void MeshSequence::operator()(double t, std::span<Vec<double>> positions) const {
    if (positions.size() != first_->positions.size())
        throw std::invalid_argument("a sequence of " + std::to_string(first_->positions.size()) +
                                    " vertices moves " + std::to_string(positions.size()));
    const int last = count() - 1;
    const double place =
        std::clamp((t - options_.start) * options_.frameRate, 0.0, static_cast<double>(last));
    const int i = std::min(static_cast<int>(place), std::max(last - 1, 0));
    const double s = place - i;
    const auto mesh = [&](int k) -> const std::vector<Vec<double>>& {
        return (*meshes_)[static_cast<std::size_t>(k)];
    };
    const auto &a = mesh(i), &b = mesh(std::min(i + 1, last));
    // Half the way from the mesh before to the one after, in a frame; at rest at both ends.
    const bool startsMoving = options_.smooth && i > 0,
               endsMoving = options_.smooth && i + 1 < last;
    const auto &before = mesh(std::max(i - 1, 0)), &after = mesh(std::min(i + 2, last));
    const double f = options_.smooth ? s * s * (3 - 2 * s) : s;
    const double fa = s * (1 - s) * (1 - s), fb = -s * s * (1 - s);
    for (std::size_t v = 0; v < positions.size(); ++v) {
        positions[v] = a[v] + f * (b[v] - a[v]);
        if (startsMoving) positions[v] += fa / 2 * (b[v] - before[v]);
        if (endsMoving) positions[v] += fb / 2 * (after[v] - a[v]);
    }
}

std::function<void(double, std::span<Vec<double>>)> blend(const MeshSequence& first,
                                                          const MeshSequence& second,
                                                          std::function<double(double)> weight) {
    if (!weight) throw std::invalid_argument("a blend needs a weight");
    if (first.first().complex != second.first().complex)
        throw std::invalid_argument("a blend is of two sequences of the same faces");
    return [first, second, weight = std::move(weight), other = second.first().positions](
               double t, std::span<Vec<double>> positions) mutable {
        first(t, positions);
        second(t, other);
        const double part = weight(t);
        for (std::size_t v = 0; v < positions.size(); ++v)
            positions[v] += part * (other[v] - positions[v]);
    };
}

}  // namespace plait
