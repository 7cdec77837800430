#include "files.h"

#include "errors.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace plait {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
    throw FileError(path.string() + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

std::filesystem::path partOf(const std::filesystem::path& path) {
    return path.string() + "." + std::to_string(getpid()) + ".part";
}

void writeWhole(const std::filesystem::path& path, std::string_view bytes) {
    const std::filesystem::path part = partOf(path);
    File file(std::fopen(part.c_str(), "wb"), std::fclose);
    if (!file) fail(path, "cannot be written");
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    if (!written || std::fclose(file.release()) != 0) {
        const int error = errno;
        std::remove(part.c_str());
        errno = error;
        fail(path, "cannot be written");
    }
    if (std::rename(part.c_str(), path.c_str()) != 0) fail(path, "cannot be renamed");
}

std::string readWhole(const std::filesystem::path& path) {
    const File file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) fail(path, "cannot be read");
    std::string bytes;
    char buffer[65536];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get()))
        bytes.append(buffer, n);
    if (std::ferror(file.get())) fail(path, "cannot be read");
    return bytes;
}

void makeFolder(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error || !std::filesystem::is_directory(path))
        throw FileError(path.string() +
                        ": cannot be made: " + (error ? error.message() : "a file is in the way"));
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0) fail(folder, "cannot be opened");
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    ::close(file_);
    throw FileError(folder.string() + ": another run is at work here");
}

FolderLock::~FolderLock() { ::close(file_); }

}  // namespace plait
