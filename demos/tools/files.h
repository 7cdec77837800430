// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace plait {

// Where this process writes a file before it is renamed to `path`.
std::filesystem::path partOf(const std::filesystem::path& path);

// Writes beside, then renames. Throws FileError, as all of these do.
void writeWhole(const std::filesystem::path& path, std::string_view bytes);
std::string readWhole(const std::filesystem::path& path);
void makeFolder(const std::filesystem::path& path);

// Held while a program works in a folder; the kernel lets go of it however the program ends.
class FolderLock {
public:
    // Throws FileError if another program holds it.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int file_;
};

}  // namespace plait
