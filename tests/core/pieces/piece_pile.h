// Pieces that meet, for tests.
#pragma once

#include "piece_worlds.h"

#include <plait/contacts/pieces/piece_contacts.h>

#include <numeric>

namespace plait::test {

struct Pile {
    World world;
    std::vector<Piece> pieces;
    std::vector<Surface> surfaces;
    double restitution = 0;  // of what is added

    int add(const Shape& shape, const PieceMatter& matter, double thickness, double friction,
            bool pinned = false) {
        const Piece piece = addPiece(world, shape, matter);
        if (pinned) {
            std::vector<int> all(piece.vertices.size());
            std::iota(all.begin(), all.end(), piece.vertices.first);
            world.pin(all);
        }
        pieces.push_back(piece);
        surfaces.push_back({.vertices = piece.surface(),
                            .thickness = thickness,
                            .staticFriction = friction,
                            .dynamicFriction = friction,
                            .restitution = restitution,
                            .self = Self::none});
        return static_cast<int>(pieces.size()) - 1;
    }
    void floor(double thickness, double friction) {
        add(box({6, 0.2, 6}), {.shift = {0, -0.1, 0}}, thickness, friction, true);
    }
    void meet(const Vec<double>& gravity = {0, -9.81, 0}, double recovery = 0.5,
              const SleepOptions& sleep = {}) {
        world.act<Gravity>(GravityOptions{.acceleration = gravity});
        holdPieces(world, {.name = "pieces", .importance = 1});
        meetPieces(world, surfaces, {.name = "contacts", .recovery = recovery}, sleep);
    }
    Vec<double> middle(const std::vector<Vec<double>>& x, int piece) const {
        const Range& all = pieces[piece].vertices;
        Vec<double> sum{};
        double mass = 0;
        for (int v = all.first; v < all.last; ++v) {
            sum += world.mass[v] * x[v];
            mass += world.mass[v];
        }
        return (1 / mass) * sum;
    }
    template <class Real>
    const ContactCounts& counts(const Solver<Real>& solver) const {
        return dynamic_cast<const PieceContacts<Real>&>(
                   solver.set(static_cast<int>(world.sets.size()) - 1))
            .counts();
    }
};

inline SolverOptions options(int substeps, int passes, int threads = 1) {
    return {.integrator = Integrator::bdf2,
            .schedule = {.substeps = substeps,
                         .frameRate = {24, 1},
                         .iterations = 1,
                         .collisionPasses = passes},
            .threads = threads};
}

}  // namespace plait::test
