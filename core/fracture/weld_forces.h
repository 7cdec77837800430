// What the welds of a cluster bear: rigid pieces and a spring a face (Kawai 1978; Bolander and
// Saito 1998), six unknowns a piece, solved at once.
#pragma once

#include "../numbers/symmetric.h"
#include "clusters.h"

#include <Eigen/SparseCholesky>

#include <memory>

namespace plait {

struct PieceForce {
    Vec<double> force{}, torque{};  // N, N m about its centre
};

// Of a face, on the second piece.
struct WeldForce {
    Vec<double> force{}, moment{};  // N; N m about where the spring acts
};

// Largest tension by pull and bending, Pa.
double stressOf(const Weld& weld, const WeldForce& force);

// As all starts, about its centre.
struct PieceMass {
    Vec<double> centre{};  // m
    double mass = 0;       // kg
    Symmetric<double> inertia{};
};

class WeldForces {
public:
    WeldForces(const std::vector<Weld>& welds, double stiffness, std::vector<PieceMass> masses)
        : welds_(&welds), stiffness_(stiffness), masses_(std::move(masses)) {}

    // Adds what each of the cluster's welds, in their order, bears of these loads, one a piece in
    // their order, in the axes of the start. What does not add up to 0 on a cluster that is free
    // moves it as one, and its inertia is a load. `pinned`: by piece of the cluster.
    // `time` (s): how long they act, with inertia in between; 0: for long.
    void add(const Cluster& cluster, std::span<const unsigned char> pinned,
             std::vector<PieceForce> loads, double time, std::vector<WeldForce>& forces);

    const PieceMass& massOf(int piece) const { return masses_[static_cast<std::size_t>(piece)]; }
    long factors() const { return factors_; }  // factorisations so far
    long solves() const { return solves_; }

private:
    using Matrix = Eigen::SparseMatrix<double>;
    using Factors = Eigen::SimplicialLDLT<Matrix>;
    struct Known {  // factors of a cluster under loads that last
        std::vector<int> pieces, welds;
        std::unique_ptr<Factors> factors;
    };

    bool lasts(const Cluster& cluster, double time) const;
    Matrix matrixOf(const Cluster& cluster, std::span<const int> rows, int size, double time) const;
    const Factors& factorsOf(const Cluster& cluster, std::span<const int> rows, int size);
    void balance(const Cluster& cluster, std::vector<PieceForce>& loads) const;

    const std::vector<Weld>* welds_;
    double stiffness_;
    std::vector<PieceMass> masses_;
    std::vector<Known> known_;  // by leader; made on demand
    long factors_ = 0, solves_ = 0;
};

}  // namespace plait
