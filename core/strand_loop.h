// One Newton step for the multipliers of whole strands, each lane a strand: a tridiagonal system,
// factored on the way there (L D L^T) and solved on the way back.
#pragma once

#include "kernel_loop.h"
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
};

template <class Real>
Real* workOf(const StrandBlock<Real>& block, int k, int lane) {
    return block.work + strandWork * (k * (block.end - block.begin) + lane - block.begin);
}

// Its numbers, kept for lanes from `lane` on. One by one: a whole StrandLink is copied in wider
// registers than its members are read in, and every read then waits for the copy.
template <class T>
void keep(const StrandLink<T>& link, const StrandBlock<Scalar<T>>& block, int k, int lane) {
    Scalar<T>* to = workOf(block, k, lane);
    for (const T& number :
         {link.along.x, link.along.y, link.along.z, link.factor, link.solved, link.w}) {
        store(to, number);
        to += Lanes<T>::count;
    }
}

template <class T>
StrandLink<T> kept(const StrandBlock<Scalar<T>>& block, int k, int lane) {
    const Scalar<T>* from = workOf(block, k, lane);
    const auto number = [&](int m) { return load<T>(from + m * Lanes<T>::count); };
    return {{number(0), number(1), number(2)}, number(3), number(4), number(5)};
}

template <class T, bool inAir>
Response<T, inAir> responseOf(const Sweep<Scalar<T>>& sweep, const int* ids, T w) {
    Response<T, inAir> response{w, {}};
    if constexpr (inAir) response.q = gather<T>(sweep.air, ids, 4).xyz;
    return response;
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

template <class T, Pass pass, bool inAir>
void factor(const Sweep<Scalar<T>>& sweep, const StrandBlock<Scalar<T>>& block, int lane) {
    const int* ids = block.ids + lane;
    auto response = responseOf<T, inAir>(sweep, ids, gather<T>(sweep.particles, ids, 8).w);
    StrandLink<T> last{{T(0), T(0), T(0)}, T(0), T(0), T(0)};
    T inverse = T(0);
    for (int k = 0; k < block.links; ++k, ids += blockSize) {
        const Quad<T> apart = gatherRelative<T>(sweep.particles, ids, ids + blockSize);
        const T l = length(apart.xyz);
        StrandLink<T> link{divide(T(1), l) * apart.xyz, T(0), T(0), apart.w};
        const Scalar<T>* row = block.rows + 2 * k * blockSize + lane;
        T a(0), lambda(0);
        if (pass != Pass::damp && block.lambda) {
            a = load<T>(row + blockSize) * T(sweep.inverseH2);
            lambda = T(sweep.keep) * load<T>(block.lambda + k * blockSize + lane);
        }
        const T c = residualOf<T, pass>(sweep, ids, link.along, l - load<T>(row));

        const Vec<T> pull = response.of(link.along);
        const T beside = -dot(last.along, pull);
        T weight = dot(link.along, pull);
        response = responseOf<T, inAir>(sweep, ids + blockSize, apart.w);
        link.factor = beside * inverse;
        weight = weight + dot(link.along, response.of(link.along)) + a;
        const T pivot = weight - beside * link.factor;
        inverse = select(pivot > T(redundant<T>) * weight, divide(T(1), pivot), T(0));
        // `solved` of the last link is D^-1 times what L left of it, and beside = factor * D.
        link.solved = inverse * (-(c + a * lambda) - beside * last.solved);
        keep(link, block, k, lane);
        last = link;
    }
}

template <class T, Pass pass, bool inAir>
void solve(const Sweep<Scalar<T>>& sweep, const StrandBlock<Scalar<T>>& block, int lane) {
    const int* ids = block.ids + block.links * blockSize + lane;
    Scalar<T>* const to = pass == Pass::project ? sweep.particles + 4 : sweep.out;
    constexpr int stride = pass == Pass::project ? 8 : 4;
    const T strength = pass == Pass::project ? T(sweep.strength) : T(1);
    StrandLink<T> next{{T(0), T(0), T(0)}, T(0), T(0), T(0)};
    T change = T(0);
    for (int k = block.links - 1; k >= 0; --k, ids -= blockSize) {
        const StrandLink<T> link = kept<T>(block, k, lane);
        const Vec<T> pulled = change * next.along;
        change = link.solved - next.factor * change;
        const auto response = responseOf<T, inAir>(sweep, ids, link.w);
        scatterAdd<T>(to, ids, stride, strength * response.of(change * link.along - pulled));
        if (pass == Pass::project && block.lambda) {
            Scalar<T>* const lambda = block.lambda + k * blockSize + lane;
            store(lambda, T(sweep.keep) * load<T>(lambda) + strength * change);
        }
        next = link;
    }
    const auto response = responseOf<T, inAir>(sweep, ids, gather<T>(sweep.particles, ids, 8).w);
    scatterAdd<T>(to, ids, stride, strength * response.of(-change * next.along));
}

template <class T, Pass pass, bool inAir>
[[gnu::flatten]] void strandLoop(const Sweep<Scalar<T>>& sweep,
                                 const StrandBlock<Scalar<T>>& block) {
    for (int lane = block.begin; lane < block.end; lane += Lanes<T>::count) {
        factor<T, pass, inAir>(sweep, block, lane);
        solve<T, pass, inAir>(sweep, block, lane);
    }
}

template <class T>
inline constexpr StrandTable<Scalar<T>> strandKernelsOf = {
    {strandLoop<T, Pass::project, false>, strandLoop<T, Pass::project, true>},
    {strandLoop<T, Pass::damp, false>, strandLoop<T, Pass::damp, true>}};

}  // namespace PLAIT_ISA
}  // namespace plait
