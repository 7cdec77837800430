// A file that appears whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace plait {

// Written beside under the name `part()` and renamed by commit(); what was not committed is
// removed.
class WholeFile {
public:
    explicit WholeFile(std::filesystem::path path);
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    const std::filesystem::path& part() const { return part_; }

    // Makes the part from these bytes. Both throw std::runtime_error, "file: cause".
    void write(std::span<const std::uint8_t> bytes) const;
    void commit();

private:
    std::filesystem::path path_, part_;
    bool committed_ = false;
};

}  // namespace plait
