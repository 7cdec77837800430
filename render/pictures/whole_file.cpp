#include "whole_file.h"

#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <utility>

namespace plait {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
    throw FileError(path.string() + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

WholeFile::WholeFile(std::filesystem::path path)
    : path_(std::move(path)),
      part_(path_.string() + "." + std::to_string(getpid()) + ".part"),
      file_(nullptr, std::fclose) {}

WholeFile::~WholeFile() {
    file_.reset();
    if (!committed_) std::remove(part_.c_str());
}

void WholeFile::write(std::span<const std::byte> bytes) {
    if (!file_) file_.reset(std::fopen(part_.c_str(), "wb"));
    if (!file_ || std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
        std::fflush(file_.get()) != 0)
        fail(path_, "cannot be written");
}

void WholeFile::commit() {
    if (file_ && std::fclose(file_.release()) != 0) fail(path_, "cannot be written");
    if (std::rename(part_.c_str(), path_.c_str()) != 0) fail(path_, "cannot be written");
    committed_ = true;
}

void writeWhole(const std::filesystem::path& path, std::string_view bytes) {
    WholeFile file(path);
    file.write(std::as_bytes(std::span(bytes)));
    file.commit();
}

std::string readWhole(const std::filesystem::path& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
    if (!file) fail(path, "cannot be read");
    std::string bytes;
    char buffer[65536];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get()))
        bytes.append(buffer, n);
    if (std::ferror(file.get())) fail(path, "cannot be read");
    return bytes;
}

}  // namespace plait
