// The kinds that only rods have: gradients, momentum, energy; and the system that rows make.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/rods/band.h>
#include <plait/rods/bend_vector.h>
#include <plait/rods/frame_rows.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

using namespace plait;
using namespace plait::test;

namespace {

// The values of any kind and their gradients, all in a row.
template <class Kind>
struct Evaluated {
    std::vector<double> c;
    std::vector<Stencil<Vec<double>, Kind::arity>> gradient;
};

template <class Kind>
Evaluated<Kind> evaluated(const Stencil<Vec<double>, Kind::arity>& x,
                          const Stencil<Vec<double>, Kind::arity>& before) {
    const typename Kind::template Row<double> row{};
    if constexpr (requires { Kind::values; }) {
        typename Kind::template Gradients<double> gradient;
        const auto c = Kind::evaluate(row, x, before, gradient);
        return {{c.begin(), c.end()}, {gradient.begin(), gradient.end()}};
    } else {
        Stencil<Vec<double>, Kind::arity> gradient;
        const double c = Kind::evaluate(row, x, gradient);
        return {{c}, {gradient}};
    }
}

template <class Kind>
void holdToCalculus(const std::string& name) {
    Random random(7);
    double slope = 0, force = 0, moment = 0;
    for (int trial = 0; trial < 300; ++trial) {
        Stencil<Vec<double>, Kind::arity> x;
        for (auto& p : x) p = random.point(1);
        const auto at = evaluated<Kind>(x, x);
        if (std::ranges::any_of(at.c, [](double c) { return std::fabs(c) > 3; })) continue;
        for (std::size_t k = 0; k < at.c.size(); ++k) {
            Vec<double> sum{}, turn{};
            double size = 1;
            for (int a = 0; a < Kind::arity; ++a) {
                const Vec<double> g = at.gradient[k][a];
                size = std::max(size, length(g));
                sum += g;
                turn += cross(x[a], g);
                for (double Vec<double>::* const axis :
                     {&Vec<double>::x, &Vec<double>::y, &Vec<double>::z}) {
                    constexpr double step = 1e-6;
                    auto up = x, down = x;
                    up[a].*axis += step;
                    down[a].*axis -= step;
                    const double measured =
                        (evaluated<Kind>(up, x).c[k] - evaluated<Kind>(down, x).c[k]) / (2 * step);
                    slope = std::max(slope, std::fabs(measured - g.*axis) / size);
                }
            }
            force = std::max(force, length(sum) / size);
            moment = std::max(moment, length(turn) / size);
        }
    }
    CHECK(report(name + ", gradient against differences", slope, 1e-7));
    CHECK(report(name + ", sum of gradients", force, 1e-12));
    // A turning rod takes the axes of BendVector and of FrameTurn along.
    if constexpr (!requires { Kind::values; })
        CHECK(report(name + ", their moment", moment, 1e-12));
}

}  // namespace

TEST_CASE("rods: rows have the gradient of their value", "[rods][kinds]") {
    holdToCalculus<BendVector>("bending as a vector");
    holdToCalculus<FrameTurn>("turn of a frame");
    holdToCalculus<DirectorAcross>("director across");
    holdToCalculus<DirectorLength>("director's length");
}

TEST_CASE("rods: bending as a vector is as large as the angle, whichever way", "[rods][kinds]") {
    Random random(11);
    double worst = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const double psi = trial < 20 ? 0 : random.uniform(1e-9, 3);
        const Vec<double> n = random.point(1), t = (1 / length(n)) * n;
        const Vec<double> any = cross(t, random.point(1)), u = (1 / length(any)) * any;
        const Stencil<Vec<double>, 3> x{
            {{}, t, t + random.uniform(0.1, 2) * (std::cos(psi) * t + std::sin(psi) * u)}};
        const auto c = evaluated<BendVector>(x, x).c;
        worst = std::max(worst, std::fabs(std::hypot(c[0], c[1]) - psi));
    }
    CHECK(report("length of the vector against the angle, rad", worst, 1e-12));
}

TEST_CASE("rods: frames alike do not turn, and a twisted one by the angle", "[rods][kinds]") {
    for (const double angle : {0.0, 0.4, -1.2}) {
        const Stencil<Vec<double>, 5> x{{{0, 0, 0},
                                         {1, 0, 0},
                                         {2, 0, 0},
                                         {0.5, 0.3, 0},
                                         {1.5, 0.3 * std::cos(angle), 0.3 * std::sin(angle)}}};
        const auto c = evaluated<FrameTurn>(x, x).c;
        CHECK(std::fabs(c[0]) < 1e-14);
        CHECK(std::fabs(c[1]) < 1e-14);
        CHECK(std::fabs(c[2] - 2 * std::tan(angle / 2)) < 1e-14);
    }
}

TEST_CASE("rods: a banded system with a border against a dense one", "[rods]") {
    Random random(3);
    double worst = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const int n = 1 + random.below(30), border = random.below(std::min(n, 4)),
                  width = random.below(6);
        const BandShape shape{n, width, border};
        std::vector<double> memory(Band<double, -1, 1>::room(shape));
        const Band<double, -1, 1> system(shape, {memory.data()});
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
        for (int i = 0; i < n; ++i)
            for (int j = i; j < n; ++j) {
                if (j < n - border && j - i > width) continue;
                const double entry = i == j ? 20 : random.uniform(-1, 1);
                const bool beside = i < n - border && j >= n - border;
                (beside ? system.across(i) : system.within(i)).put(j, entry);
                dense(i, j) = dense(j, i) = entry;
            }
        Eigen::VectorXd b(n);
        for (int i = 0; i < n; ++i) system.side(i).put(0, b(i) = random.uniform(-1, 1));
        for (int i = 0; i < n - border; ++i) system.eliminate(i, 0);
        system.finish([](int) { return 0.0; });
        const Eigen::VectorXd exact = dense.ldlt().solve(b);
        for (int i = 0; i < n; ++i)
            worst = std::max(worst, std::fabs(system.side(i)[0] - exact(i)));
    }
    CHECK(report("solution", worst, 1e-14));
}
