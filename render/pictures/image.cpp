#include "image.h"

#include "whole_file.h"

#include <libdeflate.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

// What stb calls instead of its own deflate; stb frees the result.
unsigned char* deflate(unsigned char* data, int size, int* deflatedSize, int level) {
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor) return nullptr;
    const auto length = static_cast<std::size_t>(size);
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), length);
    auto* deflated = static_cast<unsigned char*>(std::malloc(bound));
    if (!deflated) return nullptr;
    *deflatedSize =
        static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, length, deflated, bound));
    return deflated;
}

}  // namespace

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS deflate
#include <stb/stb_image_write.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace plait {
namespace {

using Pixels = std::unique_ptr<unsigned char, decltype(&std::free)>;

// Dithered frames: rows less the row above, at the fastest level, are a fifth smaller in half the
// time of level 3 without a filter. Set before main, since stb keeps its settings in globals and
// several threads write frames.
[[maybe_unused]] const bool configured = [] {
    stbi_write_png_compression_level = 1;
    stbi_write_force_png_filter = 2;
    return true;
}();

std::size_t byteCount(const Picture& picture) {
    return 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

std::vector<std::uint8_t> readFile(const std::filesystem::path& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
    std::vector<std::uint8_t> bytes;
    std::uint8_t buffer[65536];
    while (file) {
        const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get());
        if (n == 0) break;
        bytes.insert(bytes.end(), buffer, buffer + n);
    }
    if (!file || std::ferror(file.get()))
        throw std::runtime_error(path.string() + ": cannot be read: " + std::strerror(errno));
    return bytes;
}

}  // namespace

void writePng(const std::filesystem::path& path, const Picture& picture) {
    if (picture.rgb.empty() || picture.rgb.size() != byteCount(picture))
        throw std::invalid_argument(path.string() + ": a picture without pixels");
    int size = 0;
    const Pixels bytes(stbi_write_png_to_mem(picture.rgb.data(), 3 * picture.width, picture.width,
                                             picture.height, 3, &size),
                       std::free);
    if (!bytes) throw std::runtime_error(path.string() + ": cannot be written: out of memory");
    WholeFile file(path);
    file.write({bytes.get(), static_cast<std::size_t>(size)});
    file.commit();
}

Picture readPng(const std::filesystem::path& path) {
    const auto bytes = readFile(path);
    Picture picture;
    const Pixels pixels(stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()),
                                              &picture.width, &picture.height, nullptr, 3),
                        std::free);
    if (!pixels)
        throw std::runtime_error(path.string() + ": is not a whole PNG: " + stbi_failure_reason());
    const std::size_t size =
        3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.rgb.assign(pixels.get(), pixels.get() + size);
    return picture;
}

}  // namespace plait
