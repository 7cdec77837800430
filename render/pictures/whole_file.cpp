#include "whole_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

namespace plait {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
    throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(error));
}

}  // namespace

WholeFile::WholeFile(std::filesystem::path path)
    : path_(std::move(path)), part_(path_.string() + ".part") {}

WholeFile::~WholeFile() {
    if (!committed_) std::remove(part_.c_str());
}

void WholeFile::write(std::span<const std::uint8_t> bytes) const {
    std::FILE* file = std::fopen(part_.c_str(), "wb");
    if (!file) fail(path_, errno);
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int error = errno;
    if (std::fclose(file) != 0) fail(path_, errno);
    if (!written) fail(path_, error);
}

void WholeFile::commit() {
    if (std::rename(part_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    committed_ = true;
}

}  // namespace plait
