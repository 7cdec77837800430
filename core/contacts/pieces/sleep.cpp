#include "sleep.h"

#include "../../state.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plait {

Sleep::Sleep(int pieces, const SleepOptions& options) : options_(options) {
    if (!options) return;
    beds_.assign(place(pieces), -1);
    calm_.assign(place(pieces), 0);
    joined_.resize(place(pieces));
    restless_.resize(place(pieces));
}

template <class Real>
void Sleep::furnish(Drawer<Real>& drawer) const {
    drawer.integers.insert(drawer.integers.end(), beds_.begin(), beds_.end());
    drawer.integers.insert(drawer.integers.end(), calm_.begin(), calm_.end());
}

template <class Real>
void Sleep::read(const Drawer<Real>& drawer) {
    const auto own = std::span(drawer.integers).last(integersEach * beds_.size());
    std::ranges::copy(own.first(beds_.size()), beds_.begin());
    std::ranges::copy(own.last(calm_.size()), calm_.begin());
}

template <class Real>
void Sleep::write(Drawer<Real>& drawer) const {
    const auto own = std::span(drawer.integers).last(integersEach * beds_.size());
    std::ranges::copy(beds_, own.begin());
    std::ranges::copy(calm_, own.begin() + std::ssize(beds_));
}

void Sleep::wake(int piece) {
    const std::int32_t bed = beds_[place(piece)];
    if (bed < 0) return;
    for (std::size_t p = 0; p < beds_.size(); ++p) {
        if (beds_[p] != bed) continue;
        beds_[p] = -1;
        calm_[p] = 0;
    }
}

int Sleep::rootOf(int piece) {
    while (joined_[place(piece)] != piece)
        piece = joined_[place(piece)] = joined_[place(joined_[place(piece)])];
    return piece;
}

void Sleep::begin() { std::iota(joined_.begin(), joined_.end(), 0); }

void Sleep::join(int first, int second) {
    const int a = rootOf(first), b = rootOf(second);
    joined_[place(std::max(a, b))] = std::min(a, b);
}

void Sleep::note(int piece, double speed, double h) {
    std::int32_t& calm = calm_[place(piece)];
    if (asleep(piece)) return;
    const auto most = static_cast<std::int32_t>(std::ceil(options_.delay / h));
    calm = speed < 0 || speed > options_.speed ? 0 : std::min(calm + 1, most);
}

void Sleep::fall(double h) {
    const auto most = static_cast<std::int32_t>(std::ceil(options_.delay / h));
    std::ranges::fill(restless_, most);
    for (int p = 0; p < std::ssize(beds_); ++p) {
        std::int32_t& least = restless_[place(rootOf(p))];
        if (!asleep(p)) least = std::min(least, calm_[place(p)]);
    }
    for (int p = 0; p < std::ssize(beds_); ++p)
        if (!asleep(p) && restless_[place(rootOf(p))] == most)
            beds_[place(p)] = static_cast<std::int32_t>(rootOf(p));
}

template void Sleep::furnish(Drawer<float>&) const;
template void Sleep::furnish(Drawer<double>&) const;
template void Sleep::read(const Drawer<float>&);
template void Sleep::read(const Drawer<double>&);
template void Sleep::write(Drawer<float>&) const;
template void Sleep::write(Drawer<double>&) const;

}  // namespace plait
