// The multipliers of all constraints of a tree at once: (J W J^T + a) dlambda = -(C + a lambda),
// exactly and in O(N) whatever the branching.
//
// The unknowns are eliminated leaves first, but per vertex instead of per pair of neighbouring
// constraints, as articulated bodies are (Featherstone 1983; Baraff, "Linear-time dynamics using
// Lagrange multipliers", 1996). Given that all constraints eliminated so far hold, a vertex answers
// an impulse p by  b + A p;  at first b = 0, A = w I. Each further constraint takes one direction
// from the A of its parent: a rank-one update. The pivots are those of L D L^T in this order.
#pragma once

#include "../numbers/symmetric.h"

#include <vector>

namespace plait {

// A vertex of the tree and the constraint between it and its parent.
template <class T>
struct TreeNode {
    // Given.
    int parent;      // index of a later node; -1 for the root, which has no constraint
    T w;             // 1/kg
    Vec<T> own, up;  // gradient of C by this vertex and by its parent
    T c;             // C
    T a;             // compliance / h^2
    T lambda;        // multiplier so far
    T weight;        // w gradient . gradient, both ends

    // Found.
    T change;        // of the multiplier
    Vec<T> impulse;  // w impulse is the displacement

    // On the way.
    Symmetric<T> mobility;  // A
    Vec<T> drift;           // b
    Vec<T> reach;           // A gradient of the parent, before this constraint held
    T residual, inversePivot;
};

// A constraint that those below fix already, to this part of its own weight, says nothing new (a
// straight chain between two pins, two pinned ends, coincident vertices): its multiplier stays as
// it is. Well above rounding, and below the pivots of mass ratios up to 1e12.
inline constexpr double redundant = 1e-12;

// Solves for the tree nodes[begin .. end); the root is the last.
template <class T>
void solveTree(std::vector<TreeNode<T>>& nodes, int begin, int end) {
    const Vec<T> zero{T(0), T(0), T(0)};
    for (int k = begin; k < end; ++k) {
        TreeNode<T>& n = nodes[k];
        n.mobility = {n.w, T(0), T(0), n.w, T(0), n.w};
        n.drift = n.impulse = zero;
    }
    for (int k = begin; k < end - 1; ++k) {
        TreeNode<T>& n = nodes[k];
        TreeNode<T>& parent = nodes[n.parent];
        n.reach = parent.mobility * n.up;
        const T pivot = dot(n.own, n.mobility * n.own) + dot(n.up, n.reach) + n.a;
        const bool informs = pivot > T(redundant) * (n.weight + n.a);
        n.inversePivot = informs ? divide(T(1), pivot) : T(0);
        n.residual = n.c + n.a * n.lambda + dot(n.own, n.drift) + dot(n.up, parent.drift);
        parent.mobility.addOuter(-n.inversePivot, n.reach);
        parent.drift -= (n.inversePivot * n.residual) * n.reach;
    }
    // Here the parent's impulse holds those of all constraints that were eliminated later.
    for (int k = end - 2; k >= begin; --k) {
        TreeNode<T>& n = nodes[k];
        TreeNode<T>& parent = nodes[n.parent];
        n.change = -(n.inversePivot * (n.residual + dot(n.reach, parent.impulse)));
        n.impulse += n.change * n.own;
        parent.impulse += n.change * n.up;
    }
}

}  // namespace plait
