// Query sets of continuous collision detection with their exact answers, from compressed tables.
#pragma once

#include <plait/collision/query.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plait {

// A row: point and triangle, or two edges, in the order of the queries.
struct CcdQuery {
    std::string id;
    bool edges;                  // edge and edge
    bool touches;                // thin
    double timeLow, timeHigh;    // bracket of the first time, where they touch
    bool distances;              // whether the rest may be used
    double leastLow, leastHigh;  // bracket of the least distance in the step (m)
    double thickness;            // a distance that they come within (m)
    double thickLow, thickHigh;  // bracket of the first time they do
    MovingVertex vertex[4];

    // The longest way of a vertex (m).
    double speed() const;
};

// The folder that PLAIT_CCD_DATA names, or `otherwise`.
std::filesystem::path ccdFolder(const std::filesystem::path& otherwise);

// The names of the tables of that folder, without those that are not there.
std::vector<std::string> ccdTables(const std::filesystem::path& folder);

// The whole of a gzip file of one member and at most 256 MB. Throws FileError, naming the file.
std::string gunzip(const std::filesystem::path& file);

// What lies between the separators.
std::vector<std::string_view> split(std::string_view text, char separator);

// Throws FileError, naming the file, where it cannot be read, uncompressed or understood.
std::vector<CcdQuery> readCcdQueries(const std::filesystem::path& file);

// The answer of core/collision/query.h; thin with a thickness of 0.
Impact answer(const CcdQuery& query, double thickness);

}  // namespace plait
