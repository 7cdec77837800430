// Which grains may meet in a substep, and in what order pairs are taken.
#include "grain_set.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace plait {
namespace {

constexpr int searched = 128;  // that a thread takes at least

}  // namespace

template <class Real>
bool GrainSet<Real>::mayMeet(int i, int j) const {
    return i != j && (grains_.pieces.empty() || grains_.pieces[i] < 0 ||
                      grains_.pieces[i] != grains_.pieces[j]);
}

template <class Real>
void GrainSet<Real>::look(const Sweep<Real>& sweep, Workers& workers) {
    const int first = grains_.vertices.first, count = grains_.vertices.size();
    present_.clear();
    for (int i = 0; i < count; ++i)
        if (!spare_[i] || sweep.particles[8L * (first + i) + 3] > 0) present_.push_back(i);
    const Real scale = static_cast<Real>(grains_.searchScale);
    const auto place = [&](int n) { return at(sweep, present_[n]); };
    cells_.sort(static_cast<int>(present_.size()),
                2 * scale * largest_ + static_cast<Real>(grains_.cling), place, workers);
    for (std::vector<int>& found : found_) found.clear();
    workers.forBlocks(cells_.count(), searched, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            const int i = present_[cells_.order()[s]];
            cells_.around(cells_.point(s), [&](int other) {
                const int j = present_[cells_.order()[other]];
                const Real reach =
                    scale * (radii_[i] + radii_[j]) + static_cast<Real>(grains_.cling);
                const Vec<Real> apart = cells_.point(s) - cells_.point(other);
                if (mayMeet(i, j) && dot(apart, apart) < reach * reach) found_[i].push_back(j);
            });
            keepNearest(i, found_[i], sweep);
        }
    });
    neighbors_.clear();
    for (int i = 0; i < count; ++i) {
        neighbors_.insert(neighbors_.end(), found_[i].begin(), found_[i].end());
        start_[i + 1] = static_cast<int>(neighbors_.size());
    }
    touch_.assign(neighbors_.size(), {});
    touching_.assign(radii_.size(), 0);
    if (grains_.averaging == Averaging::inTurn) color();
}

// Pairs of a colour have no grain in common: the lowest that neither of both has.
template <class Real>
void GrainSet<Real>::color() {
    taken_.assign(radii_.size(), 0);
    colorOf_.clear(), colors_.assign(mostColors + 1, 0);
    const auto each = [&](const auto& visit) {
        for (int i = 0; i < grains_.vertices.size(); ++i)
            for (int k = start_[i]; k < start_[i + 1]; ++k)
                if (i < neighbors_[k]) visit(i, k);
    };
    each([&](int i, int k) {
        const std::uint64_t taken = taken_[i] | taken_[neighbors_[k]];
        const int color = std::min(std::countr_one(taken), mostColors - 1);
        taken_[i] |= std::uint64_t{1} << color, taken_[neighbors_[k]] |= std::uint64_t{1} << color;
        colorOf_.push_back(color);
        ++colors_[color + 1];
    });
    for (int c = 0; c < mostColors; ++c) colors_[c + 1] += colors_[c];
    pairs_.resize(colorOf_.size());
    std::vector<int> place(colors_.begin(), colors_.end() - 1);
    auto color = colorOf_.begin();
    each([&](int i, int k) { pairs_[place[*color++]++] = {i, k}; });
}

template <class Real>
void GrainSet<Real>::keepNearest(int i, std::vector<int>& found, const Sweep<Real>& sweep) const {
    const auto most = static_cast<std::size_t>(grains_.mostNeighbours);
    if (most == 0 || found.size() <= most) return;
    std::ranges::sort(found, {}, [&](int j) { return std::pair(near(sweep, i, j).gap, j); });
    found.resize(most);
}

template class GrainSet<float>;
template class GrainSet<double>;

}  // namespace plait
