// A 64-bit hash of bytes, the same on every run and machine of one byte order (x86-64).
//
// FNV-1a on words of 8 bytes, little end first, with a shift after the multiplication:
//     h = seed;  for each word:  h = (h ^ word) * 0x100000001b3,  h ^= h >> 32
// the last word filled up with zeros, then once more with the number of bytes as the word. The
// shift brings high bits down: without it the flipped signs of two numbers could cancel. Every step
// can be undone, so two inputs that differ in one word never collide. Not for keeping secrets.
//
// 0 and -0 hash differently, and so do NaNs of different bits: assert allFinite first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ranges>
#include <span>
#include <type_traits>

namespace plait {

inline constexpr std::uint64_t hashSeed = 0xcbf29ce484222325;

inline std::uint64_t hashWord(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x100000001b3;
    return hash ^ (hash >> 32);
}

// Hash of the objects' bytes, which have no padding: a span, vector or array. Give the last hash as
// seed to go on with it.
template <std::ranges::contiguous_range Range>
std::uint64_t hashOf(const Range& objects, std::uint64_t seed = hashSeed) {
    static_assert(std::is_trivially_copyable_v<std::ranges::range_value_t<Range>>);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(objects));
    const std::size_t size = bytes.size();
    std::uint64_t hash = seed;
    for (std::size_t i = 0; i < size; i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, &bytes[i], size - i < 8 ? size - i : 8);
        hash = hashWord(hash, word);
    }
    return hashWord(hash, size);
}

}  // namespace plait
