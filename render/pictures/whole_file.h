// Files that appear whole or not at all. All that this project writes goes through here.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plait {

// A file that cannot be read or written. The message is one line, "file: cause".
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Written beside under the name `part()`, which no other process has, and renamed by commit(); what
// was not committed is removed.
class WholeFile {
public:
    explicit WholeFile(std::filesystem::path path);
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    const std::filesystem::path& part() const { return part_; }

    // Adds these bytes to the part. Both throw FileError.
    void write(std::span<const std::byte> bytes);
    void commit();

private:
    std::filesystem::path path_, part_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    bool committed_ = false;
};

// All of a file at once. Both throw FileError.
void writeWhole(const std::filesystem::path& path, std::string_view bytes);
std::string readWhole(const std::filesystem::path& path);

}  // namespace plait
