// A set of constraints as methods other than sweeps see it: C, its gradient and its second
// derivatives at the positions of a state, all from the same `evaluate`. With the compliance alpha
// they are a potential U = C^2 / (2 alpha), or a constraint C = 0 where alpha is 0.
#pragma once

#include "constraints/constants.h"
#include "numbers/arctangent.h"
#include "numbers/dual.h"
#include "state.h"

#include <span>
#include <vector>

namespace plait {

// One entry a constraint, but for ids and gradient (arity) and curvature ((3 arity)^2 of it, row by
// row; empty unless it was asked for).
template <class Real>
struct Terms {
    int arity = 0;
    std::vector<int> ids;
    std::vector<Real> value;         // C
    std::vector<Real> above, below;  // compliance where C > 0, and else; from `slack` on none acts
    std::vector<Vec<Real>> gradient;
    std::vector<Real> curvature;  // d2C / dx2

    int size() const { return static_cast<int>(value.size()); }
    // On the side where C lies, or where `side` does in its place.
    Real compliance(int n) const { return compliance(n, value[n]); }
    Real compliance(int n, Real side) const { return side > Real(0) ? above[n] : below[n]; }
    // On either side.
    bool rigid(int n) const { return !(above[n] > Real(0) && below[n] > Real(0)); }
    // The 3 x 3 block of vertices a and b in the second derivatives of constraint n; its rows are
    // 3 arity numbers apart.
    const Real* block(int n, int a, int b) const {
        const std::size_t vertices = arity, first = vertices * n + a;
        return &curvature[9 * vertices * first + 3 * static_cast<std::size_t>(b)];
    }
    // For `constraints` of them; keeps its memory.
    void resize(int constraints, int vertices, bool curved) {
        arity = vertices;
        const std::size_t n = constraints, a = vertices;
        ids.resize(n * a);
        value.resize(n);
        above.resize(n);
        below.resize(n);
        gradient.resize(n * a);
        curvature.resize(curved ? n * 9 * a * a : 0);
    }
};

// Where the vertices of a stencil are, relative to the first or to the row's origin.
template <class Kind, class Real>
Stencil<Vec<Real>, Kind::arity> located(const State<Real>& state, const int* ids,
                                        const typename Kind::template Row<Real>& row) {
    Stencil<Vec<Real>, Kind::arity> x{};
    const Particle<Real>& first = state.particles[ids[0]];
    for (int a = 0; a < Kind::arity; ++a) {
        const Particle<Real>& p = state.particles[ids[a]];
        if constexpr (anchored<Kind>)
            x[a] = (p.x - Kind::origin(row)) + p.d;
        else if (a > 0)
            x[a] = (p.x - first.x) + (p.d - first.d);
    }
    return x;
}

// Every member of a row, or of positions, as T.
template <class To, class From, class T, class S>
To eachAs(const From& from) {
    constexpr int members = sizeof(From) / sizeof(S);
    Stencil<S, members> in;
    Stencil<T, members> out;
    __builtin_memcpy(&in, &from, sizeof from);
    for (int m = 0; m < members; ++m) out[m] = T(in[m]);
    To to;
    __builtin_memcpy(&to, &out, sizeof to);
    return to;
}

// A row in the precision of a run.
template <class Kind, class Real>
typename Kind::template Row<Real> narrow(const typename Kind::template Row<double>& row) {
    if constexpr (requires { Kind::template narrow<Real>(row); })
        return Kind::template narrow<Real>(row);
    else
        return eachAs<typename Kind::template Row<Real>, typename Kind::template Row<double>, Real,
                      double>(row);
}

// Writes constraint i: `ids` are its vertices.
template <class Kind, class Real>
void setTerm(Terms<Real>& terms, int i, const int* ids,
             const typename Kind::template Row<Real>& row, const State<Real>& state) {
    constexpr int arity = Kind::arity, numbers = 3 * arity;
    const auto x = located<Kind>(state, ids, row);
    Stencil<Vec<Real>, arity> gradient;
    terms.value[i] = Kind::evaluate(row, x, gradient);
    terms.above[i] = Kind::compliance(row, Real(1));
    terms.below[i] = Kind::compliance(row, Real(-1));
    for (int a = 0; a < arity; ++a) {
        terms.ids[arity * i + a] = ids[a];
        terms.gradient[arity * i + a] = gradient[a];
    }
    if (terms.curvature.empty()) return;
    using D = Dual<Real>;
    const auto dualRow =
        eachAs<typename Kind::template Row<D>, typename Kind::template Row<Real>, D, Real>(row);
    Real* const curvature = &terms.curvature[numbers * numbers * i];
    for (int n = 0; n < numbers; ++n) {
        auto dual = eachAs<Stencil<Vec<D>, arity>, Stencil<Vec<Real>, arity>, D, Real>(x);
        // Unless there is an origin, the first vertex is where the others are measured from.
        const Vec<D> step{D(0, n % 3 == 0), D(0, n % 3 == 1), D(0, n % 3 == 2)};
        if (n / 3 > 0 || anchored<Kind>)
            dual[n / 3] += step;
        else
            for (int a = 1; a < arity; ++a) dual[a] -= step;
        Stencil<Vec<D>, arity> slope;
        Kind::evaluate(dualRow, dual, slope);
        for (int a = 0; a < arity; ++a) {
            curvature[numbers * n + 3 * a] = slope[a].x.slope;
            curvature[numbers * n + 3 * a + 1] = slope[a].y.slope;
            curvature[numbers * n + 3 * a + 2] = slope[a].z.slope;
        }
    }
}

// The constraints at the places `which` of a set, or all of it where that is empty. ids: of the
// set; row(i): of constraint i.
template <class Kind, class Real, class RowOf>
void setTerms(Terms<Real>& terms, std::span<const int> ids, std::span<const int> which, bool curved,
              const State<Real>& state, const RowOf& row) {
    const auto all = static_cast<int>(ids.size()) / Kind::arity;
    const int count = which.empty() ? all : static_cast<int>(which.size());
    terms.resize(count, Kind::arity, curved);
    for (int n = 0; n < count; ++n) {
        const int i = which.empty() ? n : which[n];
        setTerm<Kind>(terms, n, &ids[Kind::arity * i], row(i), state);
    }
}

}  // namespace plait
