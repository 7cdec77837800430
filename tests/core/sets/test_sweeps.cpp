// The direction of sweeps (design section 5): what one substep does to small motions of a sheet of
// rigid links, from the real kernels, and what becomes of a hanging sheet. A palindrome is forward
// and then exactly backward; the figures expected are those of an independent linear computation.
#include "tests/catch.h"
#include "tests/hand_state.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/sheet.h"

#include <plait/methods/sweeps/xpbd.h>
#include <plait/sets/constraint_set.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <complex>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

using Matrix = Eigen::MatrixXd;
using Complex = std::complex<double>;

std::vector<int> freeVertices(const World& world) {
    std::vector<int> freed;
    for (int v = 0; v < static_cast<int>(world.start.size()); ++v)
        if (!world.pinned[static_cast<std::size_t>(v)]) freed.push_back(v);
    return freed;
}

double& component(Vec<double>& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

// Derivative of where the free vertices are by where they were, at rest: differences of fourth
// order. `moved` sweeps with all vertices displaced by what it is given, and leaves there how far
// off they are then.
template <class Moved>
Matrix derivative(const World& world, Moved moved) {
    constexpr double step = 1e-5;
    const std::vector<int> freed = freeVertices(world);
    const int size = 3 * static_cast<int>(freed.size());
    const auto column = [&](int j, double distance) {
        Points d(world.start.size());
        component(d[static_cast<std::size_t>(freed[j / 3])], j % 3) = distance;
        moved(d);
        Eigen::VectorXd after(size);
        for (int i = 0; i < size; ++i)
            after[i] = component(d[static_cast<std::size_t>(freed[i / 3])], i % 3);
        return after;
    };
    Matrix matrix(size, size);
    for (int j = 0; j < size; ++j)
        matrix.col(j) = (8 * (column(j, step) - column(j, -step)) -
                         (column(j, 2 * step) - column(j, -2 * step))) /
                        (12 * step);
    return matrix;
}

// Of these sweeps of one set.
Matrix sweepMatrix(const World& world, int n, std::initializer_list<Direction> directions) {
    ConstraintSet<Stretch, double> set(sheetLinks(world, n, n), n * n, bestKernels());
    Workers workers(1);
    const State<double> atRest = stateOf<double>(world);
    return derivative(world, [&](Points& d) {
        State<double> state = atRest;
        for (std::size_t v = 0; v < d.size(); ++v) state.particles[v].d = d[v];
        Sweep<double> sweep = xpbdSweep<double>(1);
        sweep.particles = &state.particles[0].x.x;
        set.begin({1, 1}, workers);
        for (const Direction direction : directions) set.project(sweep, direction, workers);
        for (std::size_t v = 0; v < d.size(); ++v) d[v] = state.particles[v].d;
    });
}

// Of one substep of the solver from rest, where links across, down and diagonal are sets of their
// own.
Matrix solverMatrix(int n, std::array<int, 3> importances) {
    World world = bentSheet(n, 0.2);
    const Rows<Stretch> links = sheetLinks(world, n, n);
    world.sets.clear();
    for (int direction = 0; direction < 3; ++direction) {
        Rows<Stretch> set;
        for (int i = 0; i < links.size(); ++i)
            if (links.colors[static_cast<std::size_t>(i)] / 2 == direction) {
                const auto k = static_cast<std::size_t>(i);
                set.ids.insert(set.ids.end(), {links.ids[2 * k], links.ids[2 * k + 1]});
                set.rows.push_back(links.rows[k]);
                set.colors.push_back(links.colors[k] % 2);
            }
        world.constrain(set, {.name = "links",
                              .order = direction,
                              .importance = importances[static_cast<std::size_t>(direction)]});
    }
    const SolverOptions options{.schedule = {.substeps = 1}};
    return derivative(world, [&](Points& d) {
        World moved = world;
        for (std::size_t v = 0; v < d.size(); ++v) moved.start[v] += d[v];
        Solver<double> solver(moved, options);
        solver.frame();
        for (std::size_t v = 0; v < d.size(); ++v) d[v] = solver.positions()[v] - world.start[v];
    });
}

// The largest |z| by which a substep multiplies a motion that a sweep multiplies by G. With u = 1/z
// let D be the difference operator of the velocity rule, 1 - u or (3 - u)(1 - u) / 2, and c = 1 or
// 2/3 the part of the substep that the rule implies: e = G (e - c^2 D^2 e), so c D = +-sqrt(1 -
// 1/G). For G in (0, 1] that is imaginary, where both backward differences are stable (A-stable): a
// palindrome makes the substep stable, however far from converged it is.
double growth(Complex G, Integrator integrator) {
    if (std::abs(G) < 1e-9) return 0;
    double most = 0;
    for (const double sign : {1.0, -1.0}) {
        const Complex cD = sign * std::sqrt(1.0 - 1.0 / G);
        if (integrator == Integrator::first) {
            most = std::max(most, 1 / std::abs(1.0 - cD));
        } else {
            const Complex root = std::sqrt(1.0 + 3.0 * cD);
            most = std::max({most, 1 / std::abs(2.0 + root), 1 / std::abs(2.0 - root)});
        }
    }
    return most;
}

struct Spectrum {
    double largestImaginary = 0, lowest = 1, highest = 0;
    double gap = 1;              // to the nearest eigenvalue below 1
    double first = 0, bdf2 = 0;  // growth a substep, by integrator
};

// Of so many sweeps a substep. Eigenvalue 1 belongs to motions that change no length, on which a
// sweep does nothing.
Spectrum spectrum(const Matrix& sweep, int sweeps = 1) {
    Spectrum s;
    const Eigen::VectorXcd eigenvalues = Eigen::EigenSolver<Matrix>(sweep, false).eigenvalues();
    for (const Complex eigenvalue : eigenvalues) {
        const Complex G = std::pow(eigenvalue, sweeps);
        s.largestImaginary = std::max(s.largestImaginary, std::fabs(G.imag()));
        s.lowest = std::min(s.lowest, G.real());
        s.highest = std::max(s.highest, G.real());
        if (std::abs(G - 1.0) < 1e-9) continue;
        s.gap = std::min(s.gap, std::abs(G - 1.0));
        s.first = std::max(s.first, growth(G, Integrator::first));
        s.bdf2 = std::max(s.bdf2, growth(G, Integrator::bdf2));
    }
    return s;
}

// (x, x1) -> (G (2 x - x1), x).
Matrix substepMatrix(const Matrix& sweep) {
    const auto n = sweep.rows();
    Matrix m = Matrix::Zero(2 * n, 2 * n);
    m.topLeftCorner(n, n) = 2 * sweep;
    m.topRightCorner(n, n) = -sweep;
    m.bottomLeftCorner(n, n).setIdentity();
    return m;
}

constexpr auto forward = Direction::forward, backward = Direction::backward;

struct Sheet {
    int n;
    double bend;
    double palindrome, oneWay;  // largest |z| of a substep of first order
    double alternating;         // growth a substep
};
constexpr Sheet sheets[] = {
    {6, 0.0, 0.993272, 0.993818, 1.253096}, {6, 0.2, 0.999310, 0.999040, 1.259983},
    {8, 0.0, 0.996797, 0.996988, 1.253103}, {8, 0.2, 0.999813, 1.000332, 1.260527},
    {10, 0.0, 0.998175, 0.998263, 0},       {10, 0.2, 0.999949, 1.007297, 0}};
constexpr double digits = 6e-7;  // to which they are given

std::string name(const Sheet& s) {
    return (s.bend > 0 ? "curved " : "flat ") + std::to_string(s.n) + " x " + std::to_string(s.n);
}

}  // namespace

TEST_CASE("a palindrome has real eigenvalues in [0, 1], and substeps with it are stable",
          "[sweeps][figures]") {
    for (const Sheet& sheet : sheets) {
        World world = bentSheet(sheet.n, sheet.bend);
        const Spectrum s = spectrum(sweepMatrix(world, sheet.n, {forward, backward}));
        REQUIRE(s.gap > 1e-5);
        REQUIRE(
            report("palindrome, " + name(sheet) + ", largest |Im g|", s.largestImaginary, 1e-9));
        REQUIRE(s.lowest > -1e-9);
        REQUIRE(s.highest < 1 + 1e-9);
        note("    largest |z|, first order", s.first);
        note("    largest |z| - 1, BDF2", s.bdf2 - 1);
        REQUIRE(std::fabs(s.first - sheet.palindrome) < digits);
        REQUIRE(s.first < 1);
        REQUIRE(s.bdf2 < 1);
    }
}

TEST_CASE("a palindrome is self-adjoint in the masses", "[sweeps]") {
    Random random(7);
    World world = bentSheet(6, 0.2);
    for (double& mass : world.mass) mass = random.uniform(0.1, 10);
    Eigen::VectorXd mass(3 * 34);
    int i = 0;
    for (std::size_t v = 0; v < world.mass.size(); ++v)
        if (!world.pinned[v])
            for (int k = 0; k < 3; ++k) mass[i++] = world.mass[v];
    const auto skew = [&](std::initializer_list<Direction> directions) {
        const Matrix form = mass.asDiagonal() * sweepMatrix(world, 6, directions);
        return (form - form.transpose()).cwiseAbs().maxCoeff();
    };
    REQUIRE(
        report("palindrome, masses of 0.1 to 10: M G - (M G)^T", skew({forward, backward}), 1e-9));
    REQUIRE(skew({forward}) > 1);
}

TEST_CASE("one-way sweeps are unstable on a curved sheet", "[sweeps][figures]") {
    for (const Sheet& sheet : sheets) {
        const World world = bentSheet(sheet.n, sheet.bend);
        const Spectrum s = spectrum(sweepMatrix(world, sheet.n, {forward}));
        REQUIRE(s.gap > 1e-5);
        note("one-way, " + name(sheet) + ", largest |z|, first order", s.first);
        note("    largest |z| - 1, BDF2", s.bdf2 - 1);
        REQUIRE(std::fabs(s.first - sheet.oneWay) < digits);
        REQUIRE(s.bdf2 > s.first);
        REQUIRE((s.bdf2 > 1) == (sheet.n > 6 || sheet.bend > 0));
    }
    // More sweeps a substep do not help at this size.
    const Matrix sweep = sweepMatrix(bentSheet(10, 0.2), 10, {forward});
    for (const int sweeps : {2, 4})
        note(
            "one-way, curved 10 x 10, " + std::to_string(sweeps) + " sweeps, largest |z| - 1, BDF2",
            spectrum(sweep, sweeps).bdf2 - 1);
}

TEST_CASE("directions that alternate from substep to substep explode", "[sweeps][figures]") {
    for (const Sheet& sheet : sheets) {
        if (sheet.alternating == 0) continue;
        const World world = bentSheet(sheet.n, sheet.bend);
        const Matrix two = substepMatrix(sweepMatrix(world, sheet.n, {backward})) *
                           substepMatrix(sweepMatrix(world, sheet.n, {forward}));
        const double growth =
            std::sqrt(Eigen::EigenSolver<Matrix>(two, false).eigenvalues().cwiseAbs().maxCoeff());
        note("alternating, " + name(sheet) + ", growth a substep", growth);
        REQUIRE(std::fabs(growth - sheet.alternating) < digits);
    }
}

// Unequal columns are no palindrome together: three different ones, each self-adjoint, have complex
// eigenvalues in all.
TEST_CASE("the solver's columns are palindromes", "[sweeps]") {
    const int n = 6;
    const Matrix palindrome = sweepMatrix(bentSheet(n, 0.2), n, {forward, backward});
    REQUIRE(report("two equal columns of three sets against two palindromes",
                   (solverMatrix(n, {2, 2, 2}) - palindrome * palindrome).cwiseAbs().maxCoeff(),
                   1e-9));
    for (const auto& importances : {std::array{1, 2, 3}, {3, 2, 1}, {6, 1, 3}}) {
        const Spectrum s = spectrum(solverMatrix(n, importances));
        const std::string name = "columns of " + std::to_string(importances[0]) + ", " +
                                 std::to_string(importances[1]) + ", " +
                                 std::to_string(importances[2]);
        note(name + ", largest |Im g|", s.largestImaginary);
        note("    largest |z|, first order", s.first);
        note("    largest |z| - 1, BDF2", s.bdf2 - 1);
    }
}
