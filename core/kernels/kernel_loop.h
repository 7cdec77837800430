// The one loop: gather - evaluate - project - scatter, for every kind, number type and pass.
#pragma once

#include "../constraints/constants.h"
#include "../numbers/lanes.h"
#include "kernels.h"

namespace plait {
inline namespace PLAIT_ISA {

enum class Pass { project, smooth, damp };

template <class Kind, class T>
typename Kind::template Row<T> loadRow(const Scalar<T>* block) {
    using Row = typename Kind::template Row<T>;
    constexpr int members = sizeof(Row) / sizeof(T);
    T member[members];
    for (int m = 0; m < members; ++m) member[m] = load<T>(block + m * blockSize);
    Row row;
    __builtin_memcpy(&row, member, sizeof row);
    return row;
}

// Where the stencil's vertices are, relative to the first or to the row's origin, and their w.
template <class Kind, class T>
Stencil<Quad<T>, Kind::arity> locate(const Scalar<T>* particles, const int* ids,
                                     const typename Kind::template Row<T>& row) {
    Stencil<Quad<T>, Kind::arity> x;
    if constexpr (anchored<Kind>) {
        for (int a = 0; a < Kind::arity; ++a) {
            x[a] = gather<T>(particles, ids + a * blockSize, 8);
            x[a].xyz = (x[a].xyz - Kind::origin(row)) +
                       gather<T>(particles + 4, ids + a * blockSize, 8).xyz;
        }
    } else {
        x[0] = gather<T>(particles, ids, 8);
        x[0].xyz = {T(0), T(0), T(0)};
        for (int a = 1; a < Kind::arity; ++a)
            x[a] = gatherRelative<T>(particles, ids, ids + a * blockSize);
    }
    return x;
}

// Flattened: a transpose that is a call costs as much as the projection.
template <class Kind, class T, Pass pass>
[[gnu::flatten]] void loop(const Sweep<Scalar<T>>& sweep, const Batch<Scalar<T>>& batch, int begin,
                           int end) {
    constexpr int arity = Kind::arity, lanes = Lanes<T>::count;
    constexpr int members = sizeof(typename Kind::template Row<T>) / sizeof(T);
    for (int n = begin; n < end; n += lanes) {
        const int lane = n % blockSize, first = n - lane;
        const int* ids = batch.ids + arity * first + lane;
        const auto row = loadRow<Kind, T>(batch.rows + members * first + lane);

        const auto located = locate<Kind, T>(sweep.particles, ids, row);
        Stencil<Vec<T>, arity> x, gradient, move;
        for (int a = 0; a < arity; ++a) x[a] = located[a].xyz;
        const T c = Kind::evaluate(row, x, gradient);
        T weight = T(0);
        for (int a = 0; a < arity; ++a) {
            move[a] = located[a].w * gradient[a];
            weight = weight + dot(gradient[a], move[a]);
        }

        // (XPBD Eq. 18) with the multiplier solved for rather than its change: lambda' = -s / (W +
        // a), s = C - W lambda. The sign of s says which side of C acts, so one-sided constraints
        // and links that buckle need no branch.
        const T lambda = T(sweep.keep) * load<T>(batch.lambda + n);
        const T s = c - weight * lambda;
        const T compliance = Kind::compliance(row, s);
        const auto acts = compliance < T(slack);
        const T a = compliance * T(sweep.inverseH2);

        T change;
        if constexpr (pass == Pass::damp) {
            T rate = T(0);
            for (int i = 0; i < arity; ++i)
                rate = rate + dot(gradient[i], gather<T>(sweep.out, ids + i * blockSize, 4).xyz);
            change = select(acts, -(T(sweep.strength) * divide(rate, weight)), T(0));
        } else {
            const T target = select(acts, -divide(s, weight + a), T(0));
            change = T(sweep.strength) * (target - lambda);
            if constexpr (pass == Pass::smooth) change = change * load<T>(batch.relax + n);
            store(batch.lambda + n, lambda + change);
        }
        Scalar<T>* const to = pass == Pass::project ? sweep.particles + 4 : sweep.out;
        constexpr int stride = pass == Pass::project ? 8 : 4;
        for (int i = 0; i < arity; ++i)
            scatterAdd<T>(to, ids + i * blockSize, stride, change * move[i]);
    }
}

template <class Kind, class T>
inline constexpr KernelTable<Scalar<T>> kernelsOf = {
    loop<Kind, T, Pass::project>, loop<Kind, T, Pass::smooth>, loop<Kind, T, Pass::damp>};

}  // namespace PLAIT_ISA
}  // namespace plait
