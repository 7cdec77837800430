#include "mesh_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <system_error>
#include <utility>

#include "mesh_reader.h"

namespace plait {

namespace {

// from_chars is the one reader of numbers that no locale changes; it knows no plus sign.
template <class T>
T parsed(const MeshBuilder& mesh, std::string_view word, const char* kind) {
    T value{};
    const bool plus = word.starts_with('+') && !word.starts_with("+-");
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data() + (plus ? 1 : 0), end, value);
    if (error == std::errc::result_out_of_range) mesh.fail(quoted(word) + " is out of range");
    if (error != std::errc() || rest != end) mesh.fail(quoted(word) + " is not " + kind);
    return value;
}

}  // namespace

std::string contentOf(const std::filesystem::path& path, const MeshBuilder& mesh) {
    std::error_code error;
    const auto type = std::filesystem::status(path, error).type();
    if (type == std::filesystem::file_type::not_found) mesh.fail("no such file");
    // Devices and pipes have no end to wait for.
    if (type != std::filesystem::file_type::regular) mesh.fail("not a file");
    const auto size = std::filesystem::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream) mesh.fail("cannot be opened");
    std::string content(size, '\0');
    stream.read(content.data(), static_cast<std::streamsize>(size));
    if (!stream) mesh.fail("cannot be read");
    return content;
}

std::string_view takeLine(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

void splitWords(std::string_view line, std::vector<std::string_view>& words) {
    constexpr std::string_view blanks = " \t\r\v\f";
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
    throw MeshFileError(file + ":" + unit + std::to_string(position) + ": " + cause);
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
    for (std::size_t i = 2; i < corners.size(); ++i)
        simplices.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

Shape MeshBuilder::finished() {
    unit = "";
    position = 0;
    if (positions.empty()) fail("no vertices");
    constexpr std::size_t most = std::numeric_limits<int>::max();
    if (positions.size() > most || simplices.edges.size() + 3 * simplices.triangles.size() > most)
        fail("too many vertices or faces");
    return {SimplicialComplex(static_cast<int>(positions.size()), simplices), std::move(positions)};
}

Shape readMesh(const std::filesystem::path& path) {
    const MeshBuilder mesh{.file = path.string(), .positions = {}, .simplices = {}};
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    });
    if (extension == ".obj") return readObj(mesh.file, contentOf(path, mesh));
    if (extension == ".ply") return readPly(mesh.file, contentOf(path, mesh));
    mesh.fail("neither .obj nor .ply");
}

}  // namespace plait
