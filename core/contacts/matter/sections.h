// Curves with a flat section: an ellipse, wide along the directors beside their edges. A linear map
// makes it round, and what is near, when paths meet, and which way is out are asked in the space
// that it leads to. Paths stay straight there, what crosses crosses there too, and nothing is
// further apart than it is, so that all that holds for round curves holds for these.
#pragma once

#include "../search/paths.h"
#include "../surface.h"

#include <span>

namespace plait {

struct World;

// The inverse of a lower triangular matrix: of the Cholesky factor of I + sum of c u u^T.
class Rounding {
public:
    Rounding() = default;
    // By the symmetric matrix's xx, xy, xz, yy, yz, zz.
    explicit Rounding(const std::array<double, 6>& matrix);

    bool flat() const { return flat_; }
    PairPoints to(const PairPoints& x) const;
    // The gradient, in space as it is, of a height along n in the space that is led to.
    Vec<double> back(const Vec<double>& n) const;

private:
    bool flat_ = false;
    std::array<double, 6> l_{};  // of the factor, row by row
};

class Sections {
public:
    Sections(const World& world, const std::vector<Surface>& surfaces);

    // Where directors point now; `at` in m, by vertex. To be called before any pair is asked about.
    void turn(std::span<const Vec<double>> at);
    // What makes a pair round that meets, or does at rest. Of two ellipses the ellipsoid of least
    // trace about their sum counts (Kurzhanski, Valyi, Ellipsoidal Calculus, 1997): the sum itself
    // where they lie alike or one is round, and up to 1.4 times as wide where they lie across.
    Rounding of(const Pairing& pair) const { return of(pair, across_); }
    Rounding atRest(const Pairing& pair) const { return of(pair, atRest_); }

private:
    struct Flat {
        Range vertices;
        int directors;             // the first
        double thickness, excess;  // m; (half the width / thickness)^2 - 1
    };
    Rounding of(const Pairing& pair, std::span<const Vec<double>> across) const;
    void find(std::span<const Vec<double>> at, std::vector<Vec<double>>& across) const;

    std::vector<Flat> flats_;
    std::vector<int> flatOf_;                   // by vertex; -1: round. Empty: all are
    std::vector<double> thickness_;             // m, by vertex
    std::vector<Vec<double>> across_, atRest_;  // by vertex: the way of its director
};

}  // namespace plait
