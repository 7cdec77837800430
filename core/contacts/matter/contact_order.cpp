// In which order contacts are gone through.
#include "contact_set.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>

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
    near_.resize(ordered_.size());
    evaluation_ = 0;
    auto next = colors_;
    for (const Contact* const c : ordered_) {
        const int n = next[c->color]++;
        contacts_[n] = *c;
        watches_[n] = c->watch;
    }
}

// In every fourth evaluation all of them, in between those that were not clear when all were last
// looked at: most never come to be.
template <class Real>
void ContactSet<Real>::project(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
    looked_ = 0;
    if (gaveUp_) return;
    if (!ready_) prepare(sweep, workers);
    const bool all = evaluation_ < 4 || evaluation_ % 4 == 3;
    ++evaluation_;
    // Whether it was not clear.
    const auto look = [&](int n) {
        if (clear(sweep, watches_[n])) return false;
        part(sweep, contacts_[n]);
        watches_[n] = contacts_[n].watch;
        if (contacts_[n].push != 0) watches_[n].first = 0;
        return true;
    };
    for (int i = 0; i <= colorLimit; ++i) {
        const int c = direction == Direction::forward ? i : colorLimit - i;
        const int first = colors_[c], count = colors_[c + 1] - first;
        const int block = c == colorLimit ? count : 64;
        workers.forBlocks(count, block, [&](int begin, int end) {
            const std::span near(near_.data() + first + begin, near_.data() + first + end);
            std::size_t seen = 0;
            if (all) {
                for (int n = first + begin; n < first + end; ++n)
                    if (look(n)) near[seen++] = n;
                if (seen < near.size()) near[seen] = -1;
                seen = near.size();
            } else {
                for (; seen < near.size() && near[seen] >= 0; ++seen) look(near[seen]);
            }
            looked_ += static_cast<long>(seen);
        });
    }
}

template class ContactSet<float>;
template class ContactSet<double>;

}  // namespace plait
