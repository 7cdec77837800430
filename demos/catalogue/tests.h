// What the tests say: which rows of the seeds they hold, and which scenes they run.
#pragma once

#include "sources.h"

#include <string>
#include <vector>

namespace plait {

struct SeedRow {
    std::string id;     // "DC3"
    std::string words;  // "fold and twist"
};
struct SeedSection {
    std::string id;     // "DC"
    std::string words;  // "deformation"
    std::vector<SeedRow> rows;
};

struct SeedTest {
    std::string name, file;
    int line = 0;
    std::vector<std::string> tags;  // without brackets
    std::string body;               // its text, up to the next test

    bool hidden() const;
    bool isLong() const;
    std::vector<std::string> rows() const;  // of the seeds, among its tags
};

struct Seeds {
    std::vector<SeedSection> sections;
    std::vector<SeedTest> tests;

    const SeedRow* row(const std::string& id) const;
    const SeedSection* section(const std::string& id) const;
    // Tests that hold a row; those that run a scene, by its name or its tag.
    std::vector<const SeedTest*> holding(const std::string& id) const;
    std::vector<const SeedTest*> running(const std::string& scene) const;
};

// Of tests/catalogue.txt and tests/**/*.cpp. Throws FileError.
Seeds readSeeds(const Sources& sources);

}  // namespace plait
