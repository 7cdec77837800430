// A set of constraints of one kind as plain data, in double, before any method or precision is
// chosen: what scenes make and `World::constrain` takes.
#pragma once

#include "../numbers/math.h"

#include <functional>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace plait {

template <class Kind>
struct Rows {
    using Row = typename Kind::template Row<double>;

    std::vector<int> ids;     // Kind::arity vertices a constraint
    std::vector<Row> rows;    // one a constraint
    std::vector<int> colors;  // empty: greedy; else one a constraint, no vertex twice in a colour
    // Changes the rows to those of time t (s): targets, colliders and rest lengths that move.
    // Called at both ends of a frame; between them every number changes linearly [IN27, DC11].
    std::function<void(double t, std::span<Row> rows)> animate;

    int size() const { return static_cast<int>(rows.size()); }
};

// What recipes and sets have in common: nobody changes it.
template <class Kind>
using SharedRows = std::shared_ptr<const Rows<Kind>>;

// Everything that the rows hold, one number after another.
template <class Kind>
std::span<const double> numbersOf(const Rows<Kind>& set) {
    using Row = typename Rows<Kind>::Row;
    static_assert(std::is_trivially_copyable_v<Row> && sizeof(Row) % sizeof(double) == 0);
    return {reinterpret_cast<const double*>(set.rows.data()),
            set.rows.size() * (sizeof(Row) / sizeof(double))};
}

// The rows for which `rest` (positions by vertex, m) is the rest shape, with this compliance where
// the kind has one. `stencils` holds Kind::arity vertices a constraint.
template <class Kind>
Rows<Kind> restRows(std::vector<int> stencils, std::span<const Vec<double>> rest,
                    double compliance = 0) {
    Rows<Kind> set{std::move(stencils), {}, {}, {}};
    for (std::size_t n = 0; n < set.ids.size(); n += Kind::arity) {
        Stencil<Vec<double>, Kind::arity> x;
        for (int a = 0; a < Kind::arity; ++a)
            x[a] = rest[static_cast<std::size_t>(set.ids[n + static_cast<std::size_t>(a)])];
        auto row = Kind::rest(x);
        if constexpr (requires { row.compliance; }) row.compliance = compliance;
        if constexpr (requires { row.compression; }) row.compression = compliance;
        set.rows.push_back(row);
    }
    return set;
}

}  // namespace plait
