// The rule by which a picture equals its golden.
#pragma once

#include "picture.h"

#include <filesystem>
#include <limits>
#include <span>
#include <string>

namespace plait {

struct Comparison {
    bool sameSize = true;  // if not, nothing else is measured and no rule is passed
    double beyond3 = 0;    // fraction of pixels further apart than 3/255 in any channel
    double beyond8 = 0;    // and than 8/255
    int largest = 0;       // difference of any channel, 0 to 255
    double meanFlip = 0;
};

Comparison compare(const Picture& actual, const Picture& golden);

// At most this much of everything.
struct PassRule {
    double beyond3 = 1, beyond8 = 1;
    double meanFlip = std::numeric_limits<double>::infinity();
};

// A stored state drawn again: only the renderer can break it.
inline constexpr PassRule tightRule{.beyond3 = 0.0005, .meanFlip = 0.002};
// Early frames simulated and drawn again.
inline constexpr PassRule looseRule{.beyond8 = 0.02};

bool passes(const Comparison& comparison, const PassRule& rule);

// One line of the figures.
std::string describe(const Comparison& comparison);

struct ComparisonEntry {
    std::string name;
    Picture actual, golden;
};

// Writes index.html, with actual, golden, difference (times 8) and FLIP map of every entry side by
// side, and the pictures beside it. Returns the page's path. Throws FileError.
std::filesystem::path writeComparisonPage(const std::filesystem::path& folder,
                                          std::span<const ComparisonEntry> entries);

}  // namespace plait
