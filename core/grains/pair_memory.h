// What pairs of grains keep past a substep, in the drawer of their set: by the one that comes
// first.
#pragma once

#include "../state.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace plait {

// Of one over the other, the push along their normal and the rub across it as accelerations.
template <class Real>
struct PairMemory {
    Real push = 0;     // m/s^2
    Vec<Real> rub{};   // m/s^2
    Vec<Real> slip{};  // m, since they stuck
};

template <class Real>
class PairMemories {
public:
    using Partner = std::pair<std::int32_t, PairMemory<Real>>;

    static void furnish(Drawer<Real>& kept, std::size_t grains) {
        kept.integers.assign(most * grains, -1);
        kept.numbers.assign(most * grains * numbersEach, Real(0));
    }

    // Of a grain and one that comes after it; none: they did not touch.
    static std::optional<PairMemory<Real>> of(const std::int32_t* partners, const Real* numbers,
                                              int grain, int other) {
        const auto first = static_cast<std::ptrdiff_t>(most) * grain;
        const std::int32_t* const end = partners + first + most;
        const std::int32_t* const found = std::find(partners + first, end, other);
        if (found == end) return {};
        const Real* const n = numbers + numbersEach * (found - partners);
        return PairMemory<Real>{n[0], {n[1], n[2], n[3]}, {n[4], n[5], n[6]}};
    }

    // In place of what a grain knew; of more than there is room for the most pressed.
    static void write(Drawer<Real>& kept, int grain, std::vector<Partner>& now) {
        std::ranges::sort(now, {},
                          [](const Partner& p) { return std::pair(-p.second.push, p.first); });
        for (std::size_t n = 0; n < most; ++n) {
            const auto& [other, m] = n < now.size() ? now[n] : Partner{-1, {}};
            const std::size_t at = most * static_cast<std::size_t>(grain) + n;
            kept.integers[at] = other;
            std::ranges::copy(
                std::array{m.push, m.rub.x, m.rub.y, m.rub.z, m.slip.x, m.slip.y, m.slip.z},
                &kept.numbers[numbersEach * at]);
        }
    }

private:
    // No more of its size find room on a grain.
    static constexpr std::size_t most = 12, numbersEach = 7;
};

}  // namespace plait
