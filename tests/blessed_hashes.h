// The state of each scene as golden/hashes.txt has it (hash.cpp): what any solver must come to,
// whatever runs it. So a test of threads, lanes or a pause runs a scene once.
#pragma once

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>

namespace plait::test {

constexpr int blessedFrames = 4;  // of draft

template <class Real>
std::uint64_t blessedHash(const std::string& scene) {
    std::ifstream file(PLAIT_ROOT "/golden/hashes.txt");
    std::string name, precision, hash;
    while (file >> name >> precision >> hash)
        if (name == scene && precision == (sizeof(Real) == sizeof(float) ? "float" : "double"))
            return std::stoull(hash, nullptr, 16);
    throw std::runtime_error("golden/hashes.txt has no " + scene);
}

}  // namespace plait::test
