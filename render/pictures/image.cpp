#include "image.h"

#include "whole_file.h"

#include <libdeflate.h>
#include <cstdlib>
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

const stbi_uc* bytesOf(const std::string& file) {
    return reinterpret_cast<const stbi_uc*>(file.data());
}

// A picture of the size of `file`, without pixels, and the pixels in `channels` of stb's: 3 are
// RGB, 2 are grey and alpha.
Pixels decode(const std::filesystem::path& path, const std::string& file, int channels,
              Picture& picture, int* channelsThere = nullptr) {
    Pixels pixels(stbi_load_from_memory(bytesOf(file), static_cast<int>(file.size()),
                                        &picture.width, &picture.height, channelsThere, channels),
                  std::free);
    if (!pixels) throw FileError(path.string() + ": is not a whole PNG: " + stbi_failure_reason());
    return pixels;
}

Picture colorsOf(const std::filesystem::path& path, const std::string& file) {
    Picture picture;
    const Pixels pixels = decode(path, file, 3, picture);
    picture.rgb.assign(pixels.get(), pixels.get() + byteCount(picture));
    return picture;
}

}  // namespace

void writePng(const std::filesystem::path& path, const Picture& picture) {
    if (picture.rgb.empty() || picture.rgb.size() != byteCount(picture))
        throw std::invalid_argument(path.string() + ": a picture without pixels");
    int size = 0;
    const Pixels bytes(stbi_write_png_to_mem(picture.rgb.data(), 3 * picture.width, picture.width,
                                             picture.height, 3, &size),
                       std::free);
    if (!bytes) throw FileError(path.string() + ": cannot be written: out of memory");
    writeWhole(path, {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)});
}

Picture readPng(const std::filesystem::path& path) { return colorsOf(path, readWhole(path)); }

PngFile readPngFile(const std::filesystem::path& path) {
    const std::string file = readWhole(path);
    PngFile png{.picture = colorsOf(path, file), .alpha = {}, .channels = 0, .bits = 8};
    const Pixels pixels = decode(path, file, 2, png.alpha, &png.channels);
    png.alpha.rgb.resize(byteCount(png.alpha));
    for (std::size_t i = 0; i < png.alpha.rgb.size(); ++i)
        png.alpha.rgb[i] = pixels.get()[2 * (i / 3) + 1];
    if (stbi_is_16_bit_from_memory(bytesOf(file), static_cast<int>(file.size()))) png.bits = 16;
    return png;
}

}  // namespace plait
