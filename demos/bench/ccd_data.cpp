#include "ccd_data.h"

#include "demos/tools/errors.h"
#include "demos/tools/files.h"

#include <libdeflate.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

namespace plait {
namespace {

// 0 where the field is empty.
double number(std::string_view field) {
    double a = 0;
    const auto [end, error] = std::from_chars(field.begin(), field.end(), a);
    if (!field.empty() && (error != std::errc() || end != field.end() || !std::isfinite(a)))
        throw FileError("no number: " + std::string(field));
    return a;
}

constexpr std::size_t columns = 38, coordinates = 14;

CcdQuery row(std::string_view line) {
    const auto field = split(line, ',');
    if (field.size() != columns) throw FileError("a row has not 38 fields");
    CcdQuery query{.id = std::string(field[0]),
                   .edges = field[1] == "ee",
                   .touches = field[2] == "1",
                   .timeLow = number(field[5]),
                   .timeHigh = number(field[6]),
                   .distances = field[13] == "1",
                   .leastLow = number(field[8]),
                   .leastHigh = number(field[9]),
                   .thickness = number(field[10]),
                   .thickLow = number(field[11]),
                   .thickHigh = number(field[12]),
                   .vertex = {}};
    const auto point = [&](std::size_t i) {
        return Vec<double>{number(field[i]), number(field[i + 1]), number(field[i + 2])};
    };
    for (std::size_t i = 0; i < 4; ++i)
        query.vertex[i] = {point(coordinates + 3 * i), point(coordinates + 12 + 3 * i)};
    return query;
}

}  // namespace

double CcdQuery::speed() const {
    double most = 0;
    for (const MovingVertex& m : vertex) most = std::max(most, length(m.end - m.start));
    return most;
}

std::filesystem::path ccdFolder(const std::filesystem::path& otherwise) {
    const char* named = std::getenv("PLAIT_CCD_DATA");
    return named && *named ? std::filesystem::path(named) : otherwise;
}

std::vector<std::string> ccdTables(const std::filesystem::path& folder) {
    std::vector<std::string> found;
    for (const char* name :
         {"handcrafted-vf", "handcrafted-ee", "simulation-vf", "simulation-ee"}) {
        if (std::filesystem::exists(folder / "open" / (std::string(name) + ".csv.gz")))
            found.emplace_back(name);
    }
    return found;
}

std::string gunzip(const std::filesystem::path& file) {
    const std::string packed = readWhole(file);
    const auto fail = [&](const char* what) { throw FileError(file.string() + ": " + what); };
    if (packed.size() < 18 || !packed.starts_with("\x1f\x8b")) fail("is no gzip file");
    std::uint32_t size = 0;  // the last four bytes, modulo 2^32
    for (std::size_t i = 1; i <= 4; ++i)
        size = size << 8 | static_cast<unsigned char>(packed[packed.size() - i]);
    if (size > 1U << 28) fail("is larger than 256 MB");
    std::string content(size, '\0');
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> reader(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (!reader || libdeflate_gzip_decompress(reader.get(), packed.data(), packed.size(),
                                              content.data(), content.size(), nullptr))
        fail("cannot be uncompressed");
    return content;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

std::vector<CcdQuery> readCcdQueries(const std::filesystem::path& file) {
    const std::string text = gunzip(file);
    std::vector<CcdQuery> queries;
    bool header = true;
    for (const std::string_view line : split(text, '\n')) {
        if (!header && !line.empty()) {
            try {
                queries.push_back(row(line));
            } catch (const FileError& error) {
                throw FileError(file.string() + ": " + error.what());
            }
        }
        header = false;
    }
    return queries;
}

Impact answer(const CcdQuery& query, double thickness) {
    const auto& [a, b, c, d] = query.vertex;
    return query.edges ? thickEdgeEdge(a, b, c, d, thickness)
                       : thickPointTriangle(a, b, c, d, thickness);
}

}  // namespace plait
