// Folders, and who works in them; files by the common writer.
#pragma once

#include "render/pictures/whole_file.h"

#include <filesystem>

namespace plait {

// Throws FileError.
void makeFolder(const std::filesystem::path& path);

// Held while a program works in a folder; the kernel lets go of it however the program ends.
class FolderLock {
public:
    // Throws FileError if another program holds it. Where the file system has no locks it warns and
    // goes on without.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int file_;
};

}  // namespace plait
