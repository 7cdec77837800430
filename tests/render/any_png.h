// PNG files of forms that writePng never writes: grey, with alpha, of 16 bits.
#pragma once

#include <libdeflate.h>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

namespace plait::test {

inline std::string bigEndian(std::uint32_t word) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(word >> shift);
    return bytes;
}

inline std::string pngChunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    return bigEndian(static_cast<std::uint32_t>(data.size())) + body +
           bigEndian(libdeflate_crc32(0, body.data(), body.size()));
}

// `pixel` is one pixel, of 1 to 4 channels of 8 or 16 bits, in a picture of `width` x `height` that
// is all alike but for its first pixel.
inline void writeAnyPng(const std::filesystem::path& path, int width, int height, int bits,
                        const std::string& first, const std::string& pixel) {
    std::string rows;
    for (int y = 0; y < height; ++y) {
        rows += '\0';  // no filter
        for (int x = 0; x < width; ++x) rows += x + y == 0 ? first : pixel;
    }
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(6), libdeflate_free_compressor);
    std::string deflated(libdeflate_zlib_compress_bound(compressor.get(), rows.size()), '\0');
    deflated.resize(libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(),
                                             deflated.data(), deflated.size()));
    constexpr char colorTypes[] = {0, 4, 2, 6};  // by channels
    const std::size_t channels = pixel.size() / static_cast<std::size_t>(bits / 8);
    const std::string header = bigEndian(static_cast<std::uint32_t>(width)) +
                               bigEndian(static_cast<std::uint32_t>(height)) +
                               static_cast<char>(bits) + colorTypes[channels - 1] +
                               std::string(3, '\0');
    std::ofstream(path, std::ios::binary)
        << "\x89PNG\r\n\x1a\n"
        << pngChunk("IHDR", header) << pngChunk("IDAT", deflated) << pngChunk("IEND", "");
}

}  // namespace plait::test
