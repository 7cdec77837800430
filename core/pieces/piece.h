// A piece: matter that moves as one. It is vertices and nothing else, so that all that knows
// vertices knows pieces: its corners are what is seen and met, and spare ones among them give it
// the mass, the centre and the inertia of a solid, which corners alone have not (2.4 to 4 times the
// moment).
#pragma once

#include "../numbers/rotation.h"
#include "../world.h"

#include <string>

namespace plait {

// Its vertices: corners, then spare ones, which hang on no simplex.
struct Piece {
    Range vertices;
    int corners;

    // What meets others.
    Range surface() const { return {vertices.first, vertices.first + corners}; }
};

// How a closed surface becomes a piece.
struct PieceMatter {
    double density = 2500;  // kg/m^3
    // Where it starts: turned about its centre, then moved.
    Rotation turn = {};
    Vec<double> shift{};     // m
    Vec<double> velocity{};  // m/s, of its centre
    Vec<double> spin{};      // rad/s
};

// Adds a solid by its surface. Throws std::invalid_argument, naming `name`, if that is open, inside
// out or so flat that it has no volume, and for a density that is not positive and finite.
Piece addPiece(World& world, const Shape& solid, const PieceMatter& matter = {},
               const std::string& name = "piece");

// Holds all pieces that the world has by now rigid: the set is solved at once, each piece by its
// nearest pose (piece_set.h).
void holdPieces(World& world, SetOptions options);

}  // namespace plait
