// Rows of one kind on curves: what the matrix and the right-hand side are made of. In double,
// whatever the run is in: in float the end of a long rod never rests.
#pragma once

#include "../constraints/constants.h"
#include "chain_kernels.h"
#include "chain_kinds.h"
#include "chain_lanes.h"

namespace plait {
inline namespace PLAIT_ISA {

// How a vertex enters a row; `velocity` is of no meaning where no rates are asked for.
template <class T>
struct ChainVertex {
    Vec<T> x, before, velocity;
    T s;
};

// Where lanes are curves, id is one for all of them, else one a lane.
template <class Kind, class T, bool along>
ChainVertex<T> chainVertex(const ChainRows& rows, const int* id, int lane) {
    constexpr int n = Lanes<T>::count;
    const auto four = [&](int first, T* out) {
        if constexpr (along) {
            Record records[n];
            for (int i = 0; i < n; ++i)
                records[i] = record(rows.vertices + vertexNumbers * id[i] + first);
            columns(records, out);
        } else {
            const int width = n > 1 ? n : rows.width;
            for (int m = 0; m < 4; ++m)
                out[m] =
                    load<T>(rows.vertices + (vertexNumbers * id[0] + first + m) * width + lane);
        }
    };
    ChainVertex<T> v{};
    T number[4];
    four(0, number);
    v.x = {number[0], number[1], number[2]};
    v.s = number[3];
    if (valuesOf<Kind>() > 1) {
        four(4, number);
        v.before = {number[0], number[1], number[2]};
    }
    if (rows.rates) {
        four(8, number);
        v.velocity = {number[0], number[1], number[2]};
    }
    return v;
}

template <class Kind, class T>
typename Kind::template Row<T> chainRow(const double* at, int width) {
    using Row = typename Kind::template Row<T>;
    constexpr int members = sizeof(Row) / sizeof(T);
    T member[members];
    for (int m = 0; m < members; ++m) member[m] = load<T>(at + m * width);
    Row row;
    __builtin_memcpy(&row, member, sizeof row);
    return row;
}

template <class Kind>
inline constexpr int chainNumbers = valuesOf<Kind>() * (valueNumbers + 3 * Kind::arity) +
                                    (__is_same(Kind, Stretch) ? linkNumbers : 0);

// Where what is left of a row goes, one number after another.
template <class T>
struct ChainOut {
    double* at;
    int width;

    void keep(const T& number) {
        store(at, number);
        at += width;
    }
    void keep(const Vec<T>& v) {
        keep(v.x);
        keep(v.y);
        keep(v.z);
    }
};

// One value of a row at these vertices.
template <class T, int arity>
void keepValue(ChainOut<T>& out, const ChainRows& rows, const Stencil<ChainVertex<T>, arity>& v,
               const T& value, const T& compliance, const Stencil<Vec<T>, arity>& gradient) {
    const T a = rows.rates ? T(0) : compliance * T(rows.inverseH2);
    T c = value, own = a;
    if (rows.rates) {
        c = T(0);
        for (int i = 0; i < arity; ++i) c = c + dot(gradient[i], v[i].velocity);
    }
    if (rows.falls) {
        const Vec<T> fall{T(rows.fall[0]), T(rows.fall[1]), T(rows.fall[2])};
        for (int i = 0; i < arity; ++i) c = c - select(v[i].s > T(0), T(0), dot(gradient[i], fall));
    }
    Stencil<Vec<T>, arity> scaled;
    for (int i = 0; i < arity; ++i) {
        scaled[i] = v[i].s * gradient[i];
        own = own + dot(scaled[i], scaled[i]);
    }
    out.keep(c);
    out.keep(a);
    out.keep(own);
    for (int i = 0; i < arity; ++i) out.keep(scaled[i]);
}

// All that is left of a row.
template <class Kind, class T>
void keepRow(ChainOut<T> out, const ChainRows& rows, const Stencil<ChainVertex<T>, Kind::arity>& v,
             const typename Kind::template Row<T>& row) {
    constexpr int arity = Kind::arity, values = valuesOf<Kind>();
    Stencil<Vec<T>, arity> x;
    for (int a = 0; a < arity; ++a) x[a] = v[a].x - v[0].x;
    x[0] = {T(0), T(0), T(0)};
    if constexpr (values > 1) {
        Stencil<Vec<T>, arity> before;
        for (int a = 0; a < arity; ++a) before[a] = v[a].before - v[0].before;
        typename Kind::template Gradients<T> gradient;
        const auto c = Kind::evaluate(row, x, before, gradient), compliance = Kind::compliance(row);
        for (int k = 0; k < values; ++k) keepValue(out, rows, v, c[k], compliance[k], gradient[k]);
    } else {
        Stencil<Vec<T>, arity> gradient;
        const T c = Kind::evaluate(row, x, gradient);
        keepValue(out, rows, v, c, Kind::compliance(row, T(1)), gradient);
        if constexpr (__is_same(Kind, Stretch)) {
            out.keep(gradient[1]);
            out.keep(length(x[1]));
        }
    }
}

template <class Kind, class T, bool along>
[[gnu::flatten]] void chainRows(const ChainRows& rows) {
    constexpr int arity = Kind::arity, n = Lanes<T>::count;
    constexpr int members = sizeof(typename Kind::template Row<double>) / sizeof(double);
    const int width = n > 1 ? n : rows.width;
    for (int block = 0; block < rows.blocks; ++block)
        for (int lane = 0; lane < width; lane += n) {
            const int* const ids =
                rows.ids + (along ? arity * block * width + lane : arity * block);
            Stencil<ChainVertex<T>, arity> v;
            for (int a = 0; a < arity; ++a)
                v[a] = chainVertex<Kind, T, along>(rows, ids + (along ? a * width : a), lane);
            keepRow<Kind, T>({rows.out + chainNumbers<Kind> * block * width + lane, width}, rows, v,
                             chainRow<Kind, T>(rows.rows + members * block * width + lane, width));
        }
}

template <class Kind, class T>
inline constexpr ChainRowsTable chainRowsOf = {
    {chainRows<Kind, T, false>, chainRows<Kind, T, true>}};

}  // namespace PLAIT_ISA
}  // namespace plait
