// The equations of one implicit substep, with the multiplier of every constraint as an unknown
// beside the positions, so that a rigid constraint is a compliant one with alpha = 0:
//
//   M (x - y) + J^T lambda = 0,   C - a lambda = 0,   a = alpha / h'^2
//
// y is where vertices would be without constraints, M = W^-1 their masses, h' the step that
// compliance sees, and lambda / h'^2 the force against the gradient.
//
// Midpoint has the same form: J at (x0 + x) / 2, y = x0 + h (v0 + h W f / 2), h'^2 = h^2 / 2, and
// the mean of C at both ends in place of C (the mean strain of Simo, Tarnow and Wong, "Exact
// energy-momentum conserving algorithms", 1992), but for rigid constraints, which hold at the end.
//
// Which side a one-sided constraint is on, or whether it acts at all, follows from the sign of
// C + (J W J^T) lambda, the C that would be without it (primal-dual active sets, Hintermüller, Ito,
// Kunisch 2003).
#pragma once

#include "../../whole_step.h"

#include <Eigen/SparseCore>

namespace plait {

class NewtonEquations {
public:
    using Vector = Eigen::VectorXd;
    using Matrix = Eigen::SparseMatrix<double>;  // symmetric but under midpoint

    explicit NewtonEquations(bool midpoint) : midpoint_(midpoint) {}

    // A substep begins. `cold`: from where the vertices were and without forces, instead of from y
    // and the multipliers of the substep before.
    void begin(WholeSubstep<double>& substep, bool cold);

    // What is left of the equations at the state and the multipliers as they are, with this
    // compliance added to every constraint, in units of its own J W J^T. Returns the constraints
    // evaluated.
    long evaluate(WholeSubstep<double>& substep, double softness);
    // Newton's matrix and right-hand side there, in scales in which entries are about 1.
    void linearise(const State<double>& state, Matrix& matrix, Vector& right);
    // Goes on by `part` of a solution from where linearise() was called.
    void move(State<double>& state, const Vector& solution, double part);

    // Sum of squares of what is left in the scales of the last linearise(), kg m^2.
    double merit(const State<double>& state) const;
    // True: the force left on any vertex is below `tolerance` of the largest on one, and the way to
    // C = a lambda below a thousandth of that, of the size of the world.
    bool solved(const State<double>& state, double tolerance) const;
    // True: all that is left moves vertices by less than 1e-14 of the size of the world:
    // merit() is noise.
    bool rounded(const State<double>& state) const;
    double unbalanced(const State<double>& state) const;  // the former
    double apart() const;                                 // the latter

    // Unknowns: positions and multipliers.
    struct Unknowns {
        std::vector<Vec<double>> d;
        std::vector<double> lambda;
    };
    Unknowns unknowns(const State<double>& state) const;
    void restore(State<double>& state, const Unknowns& all);

private:
    struct Set {
        Terms<double> force, end;   // where forces are taken, and where the substep ends
        std::vector<double> first;  // C where the substep began
        int offset;                 // of its multipliers
    };
    struct Multiplier {
        double weight;      // J W J^T, 1/kg
        double compliance;  // a, 1/kg; 0 is rigid
        double left;        // C - a lambda, or what lambda moves where it should not act
        double scale;       // of its row and column
        bool acts;
    };

    const Terms<double>& endOf(const Set& set) const { return midpoint_ ? set.end : set.force; }
    void number(const State<double>& state, std::size_t sets);
    void evaluateSets(WholeSubstep<double>& substep);
    void judge(const Set& set, const State<double>& state, int n, double softness);
    void addMasses(const State<double>& state, Vector& right);
    void addConstraint(const Set& set, const State<double>& state, int n, Vector& right);
    void addCurvature(const Set& set, const State<double>& state, int n);

    bool midpoint_;
    double inverseH2_ = 0;               // 1/s^2, of h'
    double size_ = 0;                    // m, of the world
    std::vector<int> place_;             // by vertex: its first row, -1 where it does not move
    int rows_ = 0;                       // of the vertices
    std::vector<Vec<double>> y_, left_;  // by vertex: m, and kg m of M (x - y) + J^T lambda
    std::vector<double> gross_;          // by vertex: the same without signs
    std::vector<Set> sets_;
    std::vector<double> lambda_;  // by constraint, as all multipliers_
    std::vector<Multiplier> multipliers_;
    Unknowns from_;  // where linearise() was called
    std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace plait
