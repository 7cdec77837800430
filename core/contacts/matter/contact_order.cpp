// In which order contacts are gone through.
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
void ContactSet<Real>::sortParts(Workers& workers) {
    const auto vertices = start_.size();
    const auto place = [&](const Contact& c) -> int& {
        const std::array<int, 2> group = groupOf(c.pair);
        if (group[1] >= 0) return places_[std::max(group[0], 0)];
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
    workers.forBlocks(static_cast<int>(places_.size()), 1024, [&](int first, int last) {
        for (int i = first; i < last; ++i)
            std::ranges::sort(
                ordered_.begin() + (i ? places_[i - 1] : 0), ordered_.begin() + places_[i], {},
                [&](const Contact* c) { return std::pair(groupOf(c->pair), c->pair.vertices); });
    });
}

template <class Real>
std::array<int, 2> ContactSet<Real>::groupOf(const Pairing& pair) const {
    if (pieces_.count() == 0) return {-1, -1};
    std::array<int, 2> units{};
    for (std::size_t side = 0; side < 2; ++side) {
        const int v = pair.vertices[side == 0 ? 0 : 3];
        units[side] = unitOf(v);
        if (pieces_.of(v) >= 0) continue;
        const int from = side == 0 ? 0 : pair.first;
        const int to = side == 0 ? pair.first : pair.first + pair.second;
        for (int i = from; i < to; ++i)
            if (!pinned_[pair.vertices[i]]) return {-1, -1};
    }
    return {std::min(units[0], units[1]), std::max(units[0], units[1])};
}

// body(unit), of all that take the pushes of a contact.
template <class Real>
template <class Body>
void ContactSet<Real>::forUnits(const Contact& contact, const Body& body) const {
    const std::span vertices(contact.pair.vertices);
    for (const int v : vertices.first(contact.pair.first + contact.pair.second))
        if (const int unit = unitOf(v); unit >= 0) body(unit);
}

// Contacts of one group lie side by side by now.
template <class Real>
void ContactSet<Real>::group() {
    members_.clear();
    std::array<int, 2> last{-1, -1};
    for (int i = 0; i < std::ssize(ordered_); ++i) {
        const std::array<int, 2> of = groupOf(ordered_[i]->pair);
        if (of[1] < 0 || of != last) members_.push_back(i);
        last = of;
    }
    members_.push_back(static_cast<int>(ordered_.size()));
}

// Linear in the contacts. What is pinned is only read and needs no colour.
template <class Real>
void ContactSet<Real>::colour(Workers& workers) {
    group();
    std::ranges::fill(taken_, std::uint64_t{0});
    colors_.fill(0);
    const int count = static_cast<int>(members_.size()) - 1;
    for (int g = 0; g < count; ++g) {
        Contact& c = *ordered_[members_[g]];
        std::uint64_t taken = 0;
        forUnits(c, [&](int unit) { taken |= taken_[unit]; });
        c.color = std::countr_one(taken);
        if (c.color < colorLimit)
            forUnits(c, [&](int unit) { taken_[unit] |= std::uint64_t{1} << c.color; });
        ++colors_[c.color + 1];
    }
    std::partial_sum(colors_.begin(), colors_.end(), colors_.begin());
    // How large each group is, by its place; then where it begins.
    groups_.assign(count + 1, 0);
    auto next = colors_;
    for (int g = 0; g < count; ++g)
        groups_[next[ordered_[members_[g]]->color]++] = members_[g + 1] - members_[g];
    std::exclusive_scan(groups_.begin(), groups_.end(), groups_.begin(), 0);
    contacts_.resize(ordered_.size());
    watches_.resize(ordered_.size());
    near_.resize(ordered_.size());
    to_.resize(std::size_t(count));
    evaluation_ = 0;
    next = colors_;
    for (int g = 0; g < count; ++g) to_[g] = groups_[next[ordered_[members_[g]]->color]++];
    workers.forBlocks(count, 1024, [&](int first, int last) {
        for (int g = first; g < last; ++g)
            for (int i = members_[g], n = to_[g]; i < members_[g + 1]; ++i, ++n) {
                contacts_[n] = *ordered_[i];
                watches_[n] = contacts_[n].watch;
            }
    });
}

// In every fourth evaluation all of them, in between those that were not clear when all were last
// looked at: most never come to be.
template <class Real>
void ContactSet<Real>::project(const Sweep<Real>& sweep, Direction direction, Workers& workers) {
    looked_ = 0;
    if (gaveUp_) return;
    if (!ready_) prepare(sweep, workers);
    findPoses(sweep, workers);
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
            const int from = groups_[first + begin], to = groups_[first + end];
            const std::span near(near_.data() + from, near_.data() + to);
            // Vertices alone commute, but for those of too many contacts, which go forward twice.
            const bool back = direction == Direction::backward && pieces_.count() > 0;
            std::size_t seen = 0;
            if (all) {
                for (int k = 0; k < to - from; ++k) {
                    const int n = back ? to - 1 - k : from + k;
                    if (look(n)) near[seen++] = n;
                }
                if (back) std::reverse(near.begin(), near.begin() + std::ptrdiff_t(seen));
                if (seen < near.size()) near[seen] = -1;
                seen = near.size();
            } else {
                while (seen < near.size() && near[seen] >= 0) ++seen;
                for (std::size_t k = 0; k < seen; ++k) look(near[back ? seen - 1 - k : k]);
            }
            looked_ += static_cast<long>(seen);
        });
    }
}

template class ContactSet<float>;
template class ContactSet<double>;

}  // namespace plait
