#include "mesh_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <system_error>
#include <type_traits>
#include <utility>

#include "mesh_reader.h"
#include "polygons.h"

namespace plait {

namespace {

// from_chars is the one reader of numbers that no locale changes; it knows no plus sign.
template <class T>
T parsed(const MeshBuilder& mesh, std::string_view word, const char* kind) {
    T value{};
    const bool plus = word.starts_with('+') && !word.starts_with("+-");
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data() + (plus ? 1 : 0), end, value);
    if (error == std::errc::result_out_of_range && std::is_floating_point_v<T> &&
        (word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos))
        return 0;  // nearer to 0 than any other number
    if (error == std::errc::result_out_of_range) mesh.fail(quoted(word) + " is out of range");
    if (error != std::errc() || rest != end) mesh.fail(quoted(word) + " is not " + kind);
    return value;
}

}  // namespace

void failAsWhole(const std::filesystem::path& file, const std::string& cause) {
    throw MeshFileError(file.string() + ":0: " + cause);
}

std::string contentOf(const std::filesystem::path& path) {
    std::error_code error;
    const auto type = std::filesystem::status(path, error).type();
    if (type == std::filesystem::file_type::not_found) failAsWhole(path, "no such file");
    // Devices and pipes have no end to wait for.
    if (type != std::filesystem::file_type::regular) failAsWhole(path, "not a file");
    const auto size = std::filesystem::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream) failAsWhole(path, "cannot be opened");
    std::string content(size, '\0');
    stream.read(content.data(), static_cast<std::streamsize>(size));
    if (!stream) failAsWhole(path, "cannot be read");
    if (content.starts_with("version https://git-lfs."))
        failAsWhole(path, "a pointer of Git LFS in place of the file: get it by git lfs pull");
    return content;
}

std::string_view textOf(std::string_view content, MeshBuilder& mesh) {
    mesh.position = 1;
    for (const std::string_view mark : {"\xff\xfe", "\xfe\xff"})
        if (content.starts_with(mark)) mesh.fail("UTF-16 text: save it as UTF-8");
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (content.starts_with(mark)) content.remove_prefix(mark.size());
    return content;
}

std::vector<std::filesystem::path> pathsBeside(const std::filesystem::path& path) {
    std::vector<std::filesystem::path> found;
    std::error_code error;
    std::filesystem::directory_iterator entry(path.has_parent_path() ? path.parent_path() : ".",
                                              error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
        found.push_back(entry->path());
    if (error) failAsWhole(path, "the folder cannot be read");
    std::ranges::sort(found);
    return found;
}

std::string extensionOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    });
    return extension;
}

std::string_view takeLine(std::string_view& rest) {
    const std::size_t length = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = rest.substr(0, length);
    rest.remove_prefix(length);
    for (const std::string_view end : {"\r\r\n", "\r\n", "\r", "\n"})
        if (rest.starts_with(end)) {
            rest.remove_prefix(end.size());
            break;
        }
    return line;
}

void splitWords(std::string_view line, std::vector<std::string_view>& words) {
    for (;;) {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        if (line.empty()) return;
        words.push_back(line.substr(0, line.find_first_of(blanks)));
        line.remove_prefix(words.back().size());
    }
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 24;
    std::string shown(text.substr(0, longest));
    std::ranges::replace_if(shown, [](char c) { return c < ' ' || c > '~'; }, '?');
    return "'" + shown + (text.size() > longest ? "...'" : "'");
}

void MeshBuilder::fail(const std::string& cause) const {
    throw MeshFileError(file + ":" + unit + std::to_string(position) + ": " + cause + note);
}

double MeshBuilder::number(std::string_view word) const {
    const auto value = parsed<double>(*this, word, "a number");
    if (!std::isfinite(value)) fail(quoted(word) + " is not finite");
    return value;
}

long long MeshBuilder::integer(std::string_view word) const {
    return parsed<long long>(*this, word, "an integer");
}

void MeshBuilder::addEdge(int a, int b) {
    if (a == b) fail("an edge joins a vertex to itself");
    simplices.edges.push_back({a, b});
}

void MeshBuilder::addFace(std::span<const int> corners) {
    if (corners.size() < 3) fail("a face with fewer than 3 vertices");
    std::vector<int> sorted(corners.begin(), corners.end());
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end()) fail("a vertex stands twice in a face");
    if (corners.size() > 3)
        polygons.push_back({simplices.triangles.size(), corners.size(), position});
    for (std::size_t i = 2; i < corners.size(); ++i)
        simplices.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

void MeshBuilder::addStrips(std::span<const int> corners) {
    std::size_t start = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] < 0) start = i + 1;
        if (i < start + 2) continue;
        int a = corners[i - 2], b = corners[i - 1];
        const int c = corners[i];
        if (a == b || b == c || c == a) continue;
        if ((i - start) % 2 == 1) std::swap(a, b);
        simplices.triangles.push_back({a, b, c});
    }
}

SimplicialComplex MeshBuilder::fans() const {
    constexpr std::size_t most = std::numeric_limits<int>::max();
    if (positions.empty()) failAsWhole(file, "no vertices");
    if (positions.size() > most || simplices.edges.size() + 3 * simplices.triangles.size() > most)
        failAsWhole(file, "too many vertices or faces");
    return SimplicialComplex(static_cast<int>(positions.size()), simplices);
}

void MeshBuilder::split(const Polygon& polygon) {
    const auto triangles =
        std::span(simplices.triangles).subspan(polygon.firstTriangle, polygon.corners - 2);
    std::vector<int> corners{triangles[0][0], triangles[0][1]};
    for (const auto& triangle : triangles) corners.push_back(triangle[2]);
    std::vector<Vec<double>> x;
    for (const int corner : corners) x.push_back(positions[static_cast<std::size_t>(corner)]);
    position = polygon.position;
    const auto parts = splitPolygon(x);
    if (parts.empty()) fail("a face that crosses itself, seen along its normal");
    for (std::size_t t = 0; t < parts.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            triangles[t][k] = corners[static_cast<std::size_t>(parts[t][k])];
}

Shape MeshBuilder::finished() {
    for (const Polygon& polygon : polygons) split(polygon);
    return {fans(), std::move(positions)};
}

MeshBuilder gatherMesh(const std::filesystem::path& path) {
    MeshBuilder mesh;
    mesh.file = path.string();
    const std::string extension = extensionOf(path);
    if (extension != ".obj" && extension != ".ply") failAsWhole(path, "neither .obj nor .ply");
    const std::string content = contentOf(path);
    (extension == ".obj" ? readObj : readPly)(mesh, content);
    return mesh;
}

Shape readMesh(const std::filesystem::path& path) { return gatherMesh(path).finished(); }

}  // namespace plait
