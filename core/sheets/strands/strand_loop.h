// One Newton step for the multipliers of whole strands, each lane a strand: a tridiagonal system,
// factored on the way there (L D L^T) and solved on the way back. With geometric stiffness there is
// a second system, of vertices, eliminated on that way back and solved on the way there once more.
#pragma once

#include "../../kernels/kernel_loop.h"
#include "strand_kernels.h"

namespace plait {
inline namespace PLAIT_ISA {

// What the way there leaves for the way back.
template <class T>
struct StrandLink {
    Vec<T> along;  // gradient: unit, from the link's first vertex to its second
    T factor;      // of L, towards the link before
    T solved;      // right-hand side after L and D
    T w;           // of the link's second vertex
    T length;
};

// What the way back leaves, in its place, for the way there once more: the vertex moves by
// moved + e, with e = part + share * (e of the vertex before).
template <class T>
struct StrandVertex {
    Vec<T> moved, part;
    T share;
};

template <class Real>
Real* workOf(const StrandBlock<Real>& block, int k, int lane) {
    return block.work + strandWork * (k * (block.end - block.begin) + lane - block.begin);
}

// Numbers kept for lanes from `lane` on. One by one: a whole struct is copied in wider registers
// than its members are read in, and every read then waits for the copy.
template <class T>
void keep(const T (&numbers)[strandWork], const StrandBlock<Scalar<T>>& block, int k, int lane) {
    Scalar<T>* to = workOf(block, k, lane);
    for (int m = 0; m < strandWork; ++m) store(to + m * Lanes<T>::count, numbers[m]);
}

template <class T>
void keep(const StrandLink<T>& l, const StrandBlock<Scalar<T>>& block, int k, int lane) {
    keep<T>({l.along.x, l.along.y, l.along.z, l.factor, l.solved, l.w, l.length}, block, k, lane);
}

template <class T>
void keep(const StrandVertex<T>& v, const StrandBlock<Scalar<T>>& block, int k, int lane) {
    keep<T>({v.moved.x, v.moved.y, v.moved.z, v.part.x, v.part.y, v.part.z, v.share}, block, k,
            lane);
}

template <class T>
T keptNumber(const StrandBlock<Scalar<T>>& block, int k, int lane, int m) {
    return load<T>(workOf(block, k, lane) + m * Lanes<T>::count);
}

template <class T>
StrandLink<T> keptLink(const StrandBlock<Scalar<T>>& block, int k, int lane) {
    const auto number = [&](int m) { return keptNumber<T>(block, k, lane, m); };
    return {{number(0), number(1), number(2)}, number(3), number(4), number(5), number(6)};
}

template <class T>
StrandVertex<T> keptVertex(const StrandBlock<Scalar<T>>& block, int k, int lane) {
    const auto number = [&](int m) { return keptNumber<T>(block, k, lane, m); };
    return {{number(0), number(1), number(2)}, {number(3), number(4), number(5)}, number(6)};
}

// A pivot below this part of its link's own weight is rounding: the links before fix the link
// already (a straight strand between two pins, two pinned ends), and its multiplier stays.
template <class T>
inline constexpr double redundant = sizeof(Scalar<T>) == 4 ? 1e-5 : 1e-12;

// C, or by how much its rate is to fall.
template <class T, Pass pass>
T residualOf(const Sweep<Scalar<T>>& sweep, const int* from, const Vec<T>& along, T c) {
    if constexpr (pass != Pass::damp) return c;
    const Vec<T> rate =
        gather<T>(sweep.out, from + blockSize, 4).xyz - gather<T>(sweep.out, from, 4).xyz;
    return T(sweep.strength) * dot(along, rate);
}

template <class T, Pass pass>
void factor(const Sweep<Scalar<T>>& sweep, const StrandBlock<Scalar<T>>& block, int lane) {
    const int* ids = block.ids + lane;
    T w = gather<T>(sweep.particles, ids, 8).w;
    StrandLink<T> last{{T(0), T(0), T(0)}, T(0), T(0), T(0), T(0)};
    T inverse = T(0);
    for (int k = 0; k < block.links; ++k, ids += blockSize) {
        const Quad<T> apart = gatherRelative<T>(sweep.particles, ids, ids + blockSize);
        const T l = length(apart.xyz);
        StrandLink<T> link{divide(T(1), l) * apart.xyz, T(0), T(0), apart.w, l};
        const Scalar<T>* row = block.rows + 2 * k * blockSize + lane;
        T a(0), lambda(0);
        if (pass != Pass::damp && block.lambda) {
            a = load<T>(row + blockSize) * T(sweep.inverseH2);
            lambda = T(sweep.keep) * load<T>(block.lambda + k * blockSize + lane);
        }
        const T c = residualOf<T, pass>(sweep, ids, link.along, l - load<T>(row));

        const Vec<T> pull = w * link.along;
        const T beside = -dot(last.along, pull);
        T weight = dot(link.along, pull);
        w = apart.w;
        link.factor = beside * inverse;
        weight = weight + dot(link.along, w * link.along) + a;
        const T pivot = weight - beside * link.factor;
        inverse = select(pivot > T(redundant<T>) * weight, divide(T(1), pivot), T(0));
        // `solved` of the last link is D^-1 times what L left of it, and beside = factor * D.
        link.solved = inverse * (-(c + a * lambda) - beside * last.solved);
        keep(link, block, k, lane);
        last = link;
    }
}

template <class T>
void addMultiplier(const Sweep<Scalar<T>>& sweep, const StrandBlock<Scalar<T>>& block, int k,
                   int lane, T change) {
    if (!block.lambda) return;
    Scalar<T>* const lambda = block.lambda + k * blockSize + lane;
    store(lambda, T(sweep.keep) * load<T>(lambda) + change);
}

template <class T, Pass pass>
void solve(const Sweep<Scalar<T>>& sweep, const StrandBlock<Scalar<T>>& block, int lane) {
    const int* ids = block.ids + block.links * blockSize + lane;
    Scalar<T>* const to = pass == Pass::project ? sweep.particles + 4 : sweep.out;
    constexpr int stride = pass == Pass::project ? 8 : 4;
    const T strength = pass == Pass::project ? T(sweep.strength) : T(1);
    StrandLink<T> next{{T(0), T(0), T(0)}, T(0), T(0), T(0), T(0)};
    T change = T(0);
    for (int k = block.links - 1; k >= 0; --k, ids -= blockSize) {
        const StrandLink<T> link = keptLink<T>(block, k, lane);
        const Vec<T> pulled = change * next.along;
        change = link.solved - next.factor * change;
        scatterAdd<T>(to, ids, stride, strength * (link.w * (change * link.along - pulled)));
        if (pass == Pass::project) addMultiplier(sweep, block, k, lane, strength * change);
        next = link;
    }
    const T first = gather<T>(sweep.particles, ids, 8).w;
    scatterAdd<T>(to, ids, stride, strength * (first * (-change * next.along)));
}

// A link that pulls: what its turning asks of its vertices, and what it has against being turned
// on.
template <class T>
struct TurnedLink {
    Vec<T> pull;
    T stiffness;
};

// From `apart` before its multiplier changed to `apart` + `moved`. What pushes would turn further
// and further: it is left as it is.
template <class T>
TurnedLink<T> turned(const StrandLink<T>& link, const Vec<T>& moved, T change) {
    const Vec<T> apart = link.length * link.along + moved;
    const T inverse = divide(T(1), length(apart)), tension = select(change < T(0), -change, T(0));
    return {tension * (link.along - inverse * apart), tension * inverse};
}

// As solve(), with the changes of multipliers acting along where links come to lie (strand_set.h).
// Vertex i moves by e_i more, where w is its inverse mass, s the stiffness and p the pull of links:
//     (1 + w (s_i-1 + s_i)) e_i - w s_i-1 e_i-1 - w s_i e_i+1 = w (p_i-1 - p_i)
// Diagonally dominant, and the e / w sum to 0.
template <class T>
void solveTurning(const Sweep<Scalar<T>>& sweep, const StrandBlock<Scalar<T>>& block, int lane) {
    const Vec<T> zero{T(0), T(0), T(0)};
    const T strength(sweep.strength);
    const int* ids = block.ids + lane;
    const T first = gather<T>(sweep.particles, ids, 8).w;
    // Of the link and of the vertex after the link at hand.
    StrandLink<T> next{zero, T(0), T(0), T(0), T(0)};
    StrandVertex<T> after{zero, zero, T(0)};
    TurnedLink<T> beyond{zero, T(0)};
    T change(0), nextChange(0);
    Vec<T> moved = zero;  // of the vertex between the link at hand and the next one
    // Both ends of the next link are known: its second vertex can be eliminated.
    const auto eliminate = [&](int k, const Vec<T>& before) {
        const TurnedLink<T> turn = turned(next, moved - before, nextChange);
        const T scale = divide(
            next.w, T(1) + next.w * (turn.stiffness + beyond.stiffness * (T(1) - after.share)));
        after = {moved, scale * (turn.pull - beyond.pull + beyond.stiffness * after.part),
                 scale * turn.stiffness};
        keep(after, block, k, lane);
        beyond = turn;
    };
    for (int k = block.links - 1; k >= 0; --k) {
        const StrandLink<T> link = keptLink<T>(block, k, lane);
        const Vec<T> pulled = nextChange * next.along;
        change = link.solved - next.factor * change;
        const T added = strength * change;
        addMultiplier(sweep, block, k, lane, added);
        const Vec<T> here = link.w * (added * link.along - pulled);
        if (k + 1 < block.links) eliminate(k + 1, here);
        moved = here;
        next = link;
        nextChange = added;
    }
    const Vec<T> here = first * (-nextChange * next.along);
    eliminate(0, here);
    const T scale = divide(first, T(1) + first * beyond.stiffness * (T(1) - after.share));
    Vec<T> e = scale * (beyond.stiffness * after.part - beyond.pull);
    scatterAdd<T>(sweep.particles + 4, ids, 8, here + e);
    for (int k = 0; k < block.links; ++k) {
        ids += blockSize;
        const StrandVertex<T> vertex = keptVertex<T>(block, k, lane);
        e = vertex.part + vertex.share * e;
        scatterAdd<T>(sweep.particles + 4, ids, 8, vertex.moved + e);
    }
}

template <class T, Pass pass>
[[gnu::flatten]] void strandLoop(const Sweep<Scalar<T>>& sweep,
                                 const StrandBlock<Scalar<T>>& block) {
    for (int lane = block.begin; lane < block.end; lane += Lanes<T>::count) {
        factor<T, pass>(sweep, block, lane);
        if (pass == Pass::project && block.turns)
            solveTurning<T>(sweep, block, lane);
        else
            solve<T, pass>(sweep, block, lane);
    }
}

template <class T>
inline constexpr StrandTable<Scalar<T>> strandKernelsOf = {strandLoop<T, Pass::project>,
                                                           strandLoop<T, Pass::damp>};

}  // namespace PLAIT_ISA
}  // namespace plait
