#include "files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace plait {

void makeFolder(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error || !std::filesystem::is_directory(path))
        throw FileError(path.string() +
                        ": cannot be made: " + (error ? error.message() : "a file is in the way"));
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0) throw FileError(folder.string() + ": cannot be opened: " + std::strerror(errno));
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    if (errno != EWOULDBLOCK) {
        std::fprintf(stderr,
                     "plait: warning: %s: no locks here (%s): let no other run write to it\n",
                     folder.c_str(), std::strerror(errno));
        return;
    }
    ::close(file_);
    throw FileError(folder.string() + ": another run is at work here");
}

FolderLock::~FolderLock() { ::close(file_); }

}  // namespace plait
