// Rods described by their wire: no stiffness is fitted.
#pragma once

#include "../world.h"

#include <span>
#include <vector>

namespace plait {

// What a wire is made of, and its section: a rectangle of `along` by `across` the director, or,
// without the latter, a circle of the diameter `along`.
struct Wire {
    double youngs = 200e9;  // Pa; steel
    double poisson = 0.3;
    double density = 7850;  // kg/m^3
    double along = 1e-3;    // m
    double across = 0;      // m

    double area() const;         // m^2
    double bending() const;      // N m^2, about the director
    double bendingSide() const;  // N m^2, across it
    double twisting() const;     // N m^2; of a rectangle within 0.2 % (Roark, "Formulas for stress
                                 // and strain", table of torsion)
    double gyration() const;     // m, about the axis
};

// What holds the shape of a rod. One of points only costs less, and has no twist that could spread
// and relax: a curved one is too stiff where ends turn or sideways load twists it, a straight one
// never twists.
enum class RodModel {
    framed,  // bending and twist of a material frame: any section, any shape
    curved,  // angles, and torsion by the dihedral of four points: where no joint is straight, the
             // director being the normal of the curve
    straight,  // bending alike in every direction, straight at rest, of a round wire
};

struct RodOptions {
    Wire wire{};
    RodModel model = RodModel::framed;
    // The curvature at rest about the director and about b = t x director (1/m), and the twist
    // (rad/m): one for each joint, in the order of edges, or one for all. None: what the curve has.
    // A curved rod has none about its director, and the torsion of the curve for its twist.
    std::vector<Vec<double>> natural{};
    // Framed only. Where the director of each edge points, one for each or one for all; only what
    // is across the edge counts. None: any that does not twist.
    std::vector<Vec<double>> toward{};
    // m, from an edge to its director; 0: half the mean edge, at least twice the gyration.
    double arm = 0;
    // What contacts may leave of it in a link before the rod is solved once more in the substep.
    double strain = 0.05;
};

struct Rod {
    Range points, directors;  // a director an edge, in the order of edges; none unless framed
};

// Adds a curve, its vertices in order, each joined to the next by an edge and the last one to the
// first if it is closed; and the set that holds it: lengths exactly, bending and twist as its wire
// does. Directors have the wire's inertia about its axis, which their edge's vertices lack, so that
// the mass is the wire's. To clamp an end pin two points and the director between them: in the
// middle of its edge it is then held, so let the curve begin half an edge before the clamp. Throws
// std::invalid_argument, naming the rod and the value, for one out of range, a curve of another
// kind, and an arm too short for the inertia.
Rod addRod(World& world, const Shape& curve, const RodOptions& options, SetOptions set);

// The same of any number of curves, in one set: of equal joints they run side by side, a
// lane each. Their points follow each other, and after these all their directors.
std::vector<Rod> addRods(World& world, std::span<const Shape> curves, const RodOptions& options,
                         SetOptions set);

}  // namespace plait
