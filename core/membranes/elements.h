// Of what a membrane is made, one element at a time: energy, forces and the part of the second
// derivative that is not negative, so that a step of Newton always goes downhill.
#pragma once

#include "../numbers/math.h"
#include "rubber.h"

#include <array>

namespace plait {

// A 3 x 3 matrix by columns.
struct Block {
    Vec<double> column[3];

    void addOuter(double s, const Vec<double>& u, const Vec<double>& v) {
        column[0] += s * v.x * u;
        column[1] += s * v.y * u;
        column[2] += s * v.z * u;
    }
    Block transposed() const {
        return {{{column[0].x, column[1].x, column[2].x},
                 {column[0].y, column[1].y, column[2].y},
                 {column[0].z, column[1].z, column[2].z}}};
    }
};

// A spring between two vertices: its force pulls vertex 0 and pushes vertex 1, its block couples
// them (and, negative, is that of each).
struct Spring {
    double rest;         // m
    double stiffness;    // N/m, in extension
    double compression;  // N/m, in compression

    double energy(const Vec<double>& d) const;
    // The force on vertex 0 (N); `block` is d force / d d, what is negative of it cut.
    Vec<double> force(const Vec<double>& d, Block& block) const;
};

// A triangle of rubber.
struct Patch {
    double inverse[3];  // 1/m: of the edges' matrix at rest, upper triangle xx, xy, yy
    double volume;      // m^3, of rubber

    // At rest, with a thickness of t (m). Throws std::invalid_argument for one without area.
    Patch(const Vec<double>& x0, const Vec<double>& x1, const Vec<double>& x2, double t);

    // Of the edges from vertex 0 (m). Blocks: 00, 11, 22, 01, 02, 12.
    double energy(const Ogden& law, bool relaxed, const Vec<double>& d1,
                  const Vec<double>& d2) const;
    double forces(const Ogden& law, bool relaxed, const Vec<double>& d1, const Vec<double>& d2,
                  std::array<Vec<double>, 3>& forces, std::array<Block, 6>& blocks) const;
};

// F = u1 a v1^T + u2 b v2^T of a triangle: its principal stretches, the larger first, and where
// they point.
struct Principal {
    double a, b;
    Vec<double> u1, u2, normal;
    double cosine, sine;  // v1 = (cosine, sine), v2 = (-sine, cosine), the first edge along (1, 0)
};
Principal principal(const Patch& patch, const Vec<double>& d1, const Vec<double>& d2);

}  // namespace plait
