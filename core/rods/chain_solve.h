// From what is left of the rows of a curve to where its vertices go: J W J^T + a, assembled and
// eliminated vertex by vertex along the curve, and what tension has against being turned.
#pragma once

#include "../kernels/kernels.h"
#include "band.h"
#include "chain_kernels.h"
#include "chain_lanes.h"

namespace plait {
inline namespace PLAIT_ISA {

// Vertices of curves as their rows see them (chain_kernels.h).
template <class T, class Real>
[[gnu::flatten]] void gatherChain(const Sweep<Real>& sweep, const ChainSystem& chain) {
    constexpr int n = Lanes<T>::count;
    const Strip<T> numbers{chain.vertexNumbers};
    const T fall[3]{T(chain.fall[0]), T(chain.fall[1]), T(chain.fall[2])};
    Record x0[n], d0[n];
    for (int v = 0; v < chain.vertices; ++v) {
        const int* const ids = chain.ids + v * n;
        Record x[n], d[n];
        for (int i = 0; i < n; ++i) {
            x[i] = record(sweep.particles + 8L * ids[i]);
            d[i] = record(sweep.particles + 8L * ids[i] + 4);
            if (v == 0) {
                x0[i] = x[i], d0[i] = d[i];
                x0[i].v[3] = 0;
            }
            x[i] = x[i] - x0[i];
            d[i] = x[i] + (d[i] - d0[i]);
        }
        const Strip<T> to = numbers + v * vertexNumbers;
        T before[4], now[4];
        columns(x, before);
        columns(d, now);
        const T w = now[3];
        now[3] = squareRoot(w);
        for (int k = 0; k < 3; ++k) now[k] = now[k] + select(w > T(0), T(0), fall[k]);
        if (chain.rates) {
            Record out[n];
            for (int i = 0; i < n; ++i) out[i] = record(sweep.out + 4L * ids[i]);
            T velocity[4];
            columns(out, velocity);
            for (int k = 0; k < 4; ++k) to.put(8 + k, velocity[k]);
        }
        for (int k = 0; k < 4; ++k) {
            to.put(k, now[k]);
            to.put(4 + k, before[k]);
        }
    }
}

// Numbers that a system needs to work in, of a curve alone (T double) or several.
template <class T>
int chainWork(const BandShape& rows, const BandShape& links, int moving) {
    return Band<T, -1, 1>::room(rows) + Band<T, -1, 3>::room(links) + 3 * moving;
}

template <class T>
class ChainSolve {
public:
    explicit ChainSolve(const ChainSystem& chain) : chain_(chain), memory_{chain.work} {
        linkMemory_ = memory_ + Band<T, -1, 1>::room(chain.rows);
        moves_ = linkMemory_ + Band<T, -1, 3>::room(chain.links);
    }

    // The multipliers' change.
    void findChange() const {
        switch (chain_.rows.halfWidth) {
            case 7:
                return findChange<7>();  // straight rods
            case 14:
                return findChange<14>();  // those with frames
            default:
                return findChange<-1>();
        }
    }

    // W J^T change by vertex.
    void gather() const {
        for (int v = 0; v < chain_.moving; ++v) {
            Vec<T> sum{T(0), T(0), T(0)};
            for (int m = chain_.begins[v]; m < chain_.begins[v + 1]; ++m) {
                const ChainMeeting& meeting = chain_.meetings[m];
                sum += changeOf(meeting.row) * three(meeting.place);
            }
            putVec(moves_ + 3 * v, rootMass(v) * sum);
        }
    }

    // Links that pull act along where they come to lie, not along where they were: geometric
    // stiffness, as strands have it (sheets/strands/README.md). With tensions T = -change / length,
    // (M + K) e = (J(x) - J(x at first))^T change, K the sum of T (I, -I; -I, I); of sqrt(M) e.
    void turn() const {
        if (chain_.links.halfWidth == 1)
            turn<1>();
        else
            turn<-1>();
    }

    // The part of the step to take, as of DirectSet: no vertex goes further than the curve is long.
    T bounded() const {
        T size = T(0), furthest = T(0);
        for (int j = 0; j < chain_.jointCount; ++j) {
            const ChainJoint& joint = chain_.joints[j];
            const T c = left(joint.row, 0);
            size = size + (number(joint.place, 3) + select(c < T(0), -c, c));
        }
        for (int v = 0; v < chain_.moving; ++v) {
            const Vec<T> move = vec(moves_ + 3 * v);
            const T far = dot(move, move);
            furthest = select(far > furthest, far, furthest);
        }
        const T far = squareRoot(furthest);
        const auto cut = select(size > T(0), far, T(0)) > size;
        return select(cut, size, T(1)) / select(cut, far, T(1));
    }

    void addMultipliers(const T& strength) const {
        const Strip<T> lambda{chain_.lambda};
        for (int i = 0; i < chain_.rows.rows; ++i)
            lambda.put(i, T(chain_.keep) * lambda[i] + strength * changeOf(i));
    }

    // To the three numbers of each vertex, `stride` apart.
    template <class Real>
    void add(const T& strength, Real* to, long stride) const {
        constexpr int n = Lanes<T>::count;
        for (int v = 0; v < chain_.moving; ++v) {
            const Vec<T> move = strength * vec(moves_ + 3 * v);
            const T column[4]{move.x, move.y, move.z, T(0)};
            Record moved[n];
            records(column, moved);
            for (int i = 0; i < n; ++i) {
                Real* const at = to + stride * chain_.ids[v * n + i];
                keepRecord(at, record(at) + moved[i]);
            }
        }
    }

private:
    T number(int place, int m) const { return load<T>(chain_.out + place + m * chain_.step); }
    T left(int row, int m) const { return number(chain_.places[row], m); }
    Vec<T> three(int place) const { return {number(place, 0), number(place, 1), number(place, 2)}; }
    static Vec<T> vec(const Strip<T>& at) { return {at[0], at[1], at[2]}; }
    static void putVec(const Strip<T>& at, const Vec<T>& v) {
        at.put(0, v.x);
        at.put(1, v.y);
        at.put(2, v.z);
    }
    T changeOf(int row) const { return Band<T, -1, 1>(chain_.rows, memory_).side(row)[0]; }
    T rootMass(int v) const { return Strip<T>{chain_.vertexNumbers}[v * vertexNumbers + 3]; }

    template <int near>
    void findChange() const {
        const Band<T, near, 1> band(chain_.rows, memory_);
        const Strip<T> lambda{chain_.lambda};
        const auto least = [&](int i) { return T(chain_.redundant) * left(i, 2); };
        band.clear();
        for (int i = 0; i < chain_.rows.rows; ++i) {
            band.row(i).put(0, left(i, 2));
            band.side(i).put(0, -(left(i, 0) + left(i, 1) * (T(chain_.keep) * lambda[i])));
        }
        // Several curves, whose numbers fill the cache, in one go along them; of one, packs would
        // be read before what they are made of has come to the cache. What the border is made of
        // is to be all there before anything is taken from it.
        const bool atOnce = Lanes<T>::count > 1 && chain_.rows.border == 0;
        int done = 0;
        for (int v = 0; v < chain_.moving; ++v) {
            couple(band, v);
            for (; atOnce && done < chain_.ready[v]; ++done) band.eliminate(done, least(done));
        }
        for (; done < bandOf(chain_.rows); ++done) band.eliminate(done, least(done));
        band.finish(least);
    }

    // What the rows that meet at a vertex have in common.
    template <int near>
    void couple(const Band<T, near, 1>& band, int v) const {
        const int begin = chain_.begins[v], edge = chain_.edges[v], end = chain_.begins[v + 1];
        for (int p = begin; p < end; ++p) {
            const int i = chain_.meetings[p].row;
            const Vec<T> g = three(chain_.meetings[p].place);
            const auto meet = [&](int first, int last, const Strip<T>& from) {
                for (int q = first; q < last; ++q) {
                    const ChainMeeting& other = chain_.meetings[q];
                    from.put(other.row, from[other.row] + dot(g, three(other.place)));
                }
            };
            if (p < edge) {
                meet(p + 1, edge, band.within(i));
                meet(edge, end, band.across(i));
            } else {
                meet(p + 1, end, band.within(i));
            }
        }
    }

    template <int near>
    void turn() const {
        const Band<T, near, 3> band(chain_.links, linkMemory_);
        // Of what is pinned: back to where it is from where rows were linear.
        const Vec<T> back{T(-chain_.fall[0]), T(-chain_.fall[1]), T(-chain_.fall[2])};
        band.clear();
        for (int k = 0; k < chain_.joined; ++k) band.row(k).put(0, T(1));
        const auto addTo = [](const Strip<T>& at, const T& number) { at.put(0, at[0] + number); };
        for (int j = 0; j < chain_.jointCount; ++j) {
            const ChainJoint& joint = chain_.joints[j];
            const int a = joint.left, b = joint.right;
            const T change = changeOf(joint.row), tension = select(change < T(0), -change, T(0));
            const Vec<T> along = three(joint.place),
                         turned = number(joint.place, 3) * along +
                                  ((b < 0 ? back : vec(moves_ + 3 * joint.b)) -
                                   (a < 0 ? back : vec(moves_ + 3 * joint.a)));
            const T inverse = divide(T(1), length(turned)), stiffness = tension * inverse;
            const Vec<T> pull = tension * (along - inverse * turned);
            const T sa = a < 0 ? T(0) : rootMass(joint.a), sb = b < 0 ? T(0) : rootMass(joint.b);
            if (a >= 0) {
                addTo(band.row(a), sa * sa * stiffness);
                putVec(band.side(a), vec(band.side(a)) - sa * pull);
            }
            if (b >= 0) {
                addTo(band.row(b), sb * sb * stiffness);
                putVec(band.side(b), vec(band.side(b)) + sb * pull);
            }
            if (a < 0 || b < 0) continue;
            const int low = a < b ? a : b, high = a < b ? b : a;
            const bool beside = low < bandOf(chain_.links) && high >= bandOf(chain_.links);
            addTo((beside ? band.across(low) : band.within(low)) + high, -(sa * sb * stiffness));
        }
        const auto none = [](int) { return T(0); };
        for (int k = 0; k < bandOf(chain_.links); ++k) band.eliminate(k, T(0));
        band.finish(none);
        for (int k = 0; k < chain_.joined; ++k) {
            const int v = chain_.joinedAt[k];
            putVec(moves_ + 3 * v, vec(moves_ + 3 * v) + rootMass(v) * vec(band.side(k)));
        }
    }

    const ChainSystem& chain_;
    Strip<T> memory_, linkMemory_{}, moves_{};
};

template <class T, class Real>
[[gnu::flatten]] void solveChain(const Sweep<Real>& sweep, const ChainSystem& chain) {
    const ChainSolve<T> solve(chain);
    solve.findChange();
    solve.gather();
    if (chain.rates) return solve.add(T(sweep.strength), sweep.out, 4);
    solve.turn();
    const T strength = T(sweep.strength) * solve.bounded();
    solve.addMultipliers(strength);
    solve.add(strength, sweep.particles + 4, 8);
}

template <class T, class Real>
inline constexpr ChainTable<Real> chainTableOf = {{gatherChain<T, Real>, gatherChain<double, Real>},
                                                  {solveChain<T, Real>, solveChain<double, Real>}};

}  // namespace PLAIT_ISA
}  // namespace plait
