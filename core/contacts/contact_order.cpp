// In which order contacts are gone through, and which of them.
#include "contact_set.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>
#include <utility>

namespace plait {

// All parts in one list, in an order that depends on nothing but what is in it. Linear in the
// contacts, but for the few of one first vertex.
template <class Real>
void ContactSet<Real>::sortParts() {
    const auto vertices = start_.size();
    const auto place = [&](const Contact& c) -> int& {
        return places_[std::size_t(c.pair.first - 1) * vertices + std::size_t(c.pair.vertices[0])];
    };
    places_.assign(2 * vertices, 0);
    for (const auto& part : parts_)
        for (const Contact& c : part) ++place(c);
    std::exclusive_scan(places_.begin(), places_.end(), places_.begin(), 0);
    std::size_t count = 0;
    for (const auto& part : parts_) count += part.size();
    ordered_.resize(count);
    for (auto& part : parts_)
        for (Contact& c : part) ordered_[place(c)++] = &c;
    int begin = 0;
    for (const int end : places_) {
        std::ranges::sort(ordered_.begin() + begin, ordered_.begin() + end, {},
                          [](const Contact* c) { return c->pair.vertices; });
        begin = end;
    }
}

// Linear in the contacts. What is pinned is only read and needs no colour.
template <class Real>
void ContactSet<Real>::colour() {
    std::ranges::fill(taken_, std::uint64_t{0});
    colors_.fill(0);
    for (Contact* const c : ordered_) {
        std::uint64_t taken = 0;
        const auto vertices = std::span(c->pair.vertices).first(c->pair.first + c->pair.second);
        for (const int v : vertices)
            if (!pinned_[v]) taken |= taken_[v];
        c->color = std::countr_one(taken);
        if (c->color < colorLimit)
            for (const int v : vertices) taken_[v] |= std::uint64_t{1} << c->color;
        ++colors_[c->color + 1];
    }
    std::partial_sum(colors_.begin(), colors_.end(), colors_.begin());
    contacts_.resize(ordered_.size());
    watches_.resize(ordered_.size());
    auto next = colors_;
    for (const Contact* const c : ordered_) {
        const int n = next[c->color]++;
        contacts_[n] = *c;
        watches_[n] = c->watch;
    }
}

// Finds the contacts between which no plane is. A palindrome meets the same ones on its way back.
template <class Real>
void ContactSet<Real>::arouse(const Sweep<Real>& sweep, Workers& workers) {
    constexpr int grain = 1024;
    const int count = static_cast<int>(watches_.size()), parts = (count + grain - 1) / grain;
    if (stirring_.size() < std::size_t(parts)) stirring_.resize(parts);
    workers.forBlocks(parts, 1, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) {
            std::vector<int> list = std::move(stirring_[p]);  // threads would share its cache line
            list.clear();
            for (int n = p * grain; n < std::min(count, (p + 1) * grain); ++n)
                if (!clear(sweep, watches_[n])) list.push_back(n);
            stirring_[p] = std::move(list);
        }
    });
    awake_.clear();
    for (int p = 0; p < parts; ++p)
        awake_.insert(awake_.end(), stirring_[p].begin(), stirring_[p].end());
}

template <class Real>
void ContactSet<Real>::project(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
    if (!ready_) prepare(sweep, workers);
    const bool back = direction == Direction::backward && returns_;
    if (!back) arouse(sweep, workers);
    returns_ = !back;
    const auto placeOf = [&](int contact) {
        return static_cast<int>(std::ranges::lower_bound(awake_, contact) - awake_.begin());
    };
    for (int i = 0; i <= colorLimit; ++i) {
        const int c = direction == Direction::forward ? i : colorLimit - i;
        const int first = placeOf(colors_[c]), count = placeOf(colors_[c + 1]) - first;
        const int block = c == colorLimit ? count : 16;
        workers.forBlocks(count, block, [&](int begin, int end) {
            for (const int n : std::span(awake_).subspan(first + begin, end - begin)) {
                part(sweep, contacts_[n]);
                watches_[n] = contacts_[n].watch;
                if (contacts_[n].push != 0) watches_[n].first = 0;
            }
        });
    }
}

template class ContactSet<float>;
template class ContactSet<double>;

}  // namespace plait
