// Order matters to what sweeps have not solved. One by chance favours nobody (V, S 6), and is the
// same again by its seed.
#pragma once

#include "../constraints/rows.h"
#include "../numbers/splitmix.h"

#include <cstdint>
#include <numeric>
#include <utility>

namespace plait {

// The same rows in another order, each order as likely as any (Fisher and Yates).
template <class Kind>
Rows<Kind> shuffled(const Rows<Kind>& set, std::uint64_t seed) {
    std::vector<std::size_t> from(set.rows.size());
    std::iota(from.begin(), from.end(), std::size_t{0});
    Splitmix random(seed);
    for (std::size_t left = from.size(); left > 1; --left)
        std::swap(from[left - 1],
                  from[static_cast<std::size_t>(random.next() * static_cast<double>(left))]);
    Rows<Kind> order;
    for (const std::size_t i : from) {
        for (std::size_t a = 0; a < Kind::arity; ++a)
            order.ids.push_back(set.ids[Kind::arity * i + a]);
        order.rows.push_back(set.rows[i]);
        if (!set.colors.empty()) order.colors.push_back(set.colors[i]);
    }
    if (set.animate)
        order.animate = [animate = set.animate, from, before = set.rows](
                            double t, std::span<typename Rows<Kind>::Row> rows) mutable {
            for (std::size_t i = 0; i < rows.size(); ++i) before[from[i]] = rows[i];
            animate(t, before);
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = before[from[i]];
        };
    return order;
}

}  // namespace plait
