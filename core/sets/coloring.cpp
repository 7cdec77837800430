#include "coloring.h"

#include <bit>
#include <cstdint>

namespace plait {
namespace {

// The colours taken at each vertex, 64 to a word, words added as they are needed.
class Taken {
public:
    explicit Taken(std::size_t vertices) : vertices_(vertices) {}

    std::uint64_t word(std::size_t w, int v) const {
        return w < words_.size() ? words_[w][static_cast<std::size_t>(v)] : 0;
    }
    void add(int color, int v) {
        const auto w = static_cast<std::size_t>(color / 64);
        while (words_.size() <= w) words_.emplace_back(vertices_, 0);
        words_[w][static_cast<std::size_t>(v)] |= std::uint64_t{1} << (color % 64);
    }

private:
    std::size_t vertices_;
    std::vector<std::vector<std::uint64_t>> words_;
};

}  // namespace

std::vector<int> greedyColors(std::span<const int> stencils, int arity, int vertices) {
    Taken taken(static_cast<std::size_t>(vertices));
    std::vector<int> colors;
    const auto size = static_cast<std::size_t>(arity);
    colors.reserve(stencils.size() / size);
    for (std::size_t first = 0; first < stencils.size(); first += size) {
        const auto stencil = stencils.subspan(first, size);
        int color = -1;
        for (std::size_t w = 0; color < 0; ++w) {
            std::uint64_t used = 0;
            for (const int v : stencil) used |= taken.word(w, v);
            if (~used) color = static_cast<int>(64 * w) + std::countr_one(used);
        }
        for (const int v : stencil) taken.add(color, v);
        colors.push_back(color);
    }
    return colors;
}

}  // namespace plait
