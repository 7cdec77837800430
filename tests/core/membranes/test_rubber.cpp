// What rubber says of being stretched, against tables of others, and elements against their own
// energies.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/membranes/elements.h>

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

// p R0 / t0 of a sphere of this rubber: the work of the pressure is that of the stretch.
double pressure(const Ogden& law, double stretch) {
    const PrincipalEnergy e = law.at(stretch, stretch);
    return (e.a + e.b) / (stretch * stretch);
}

// Where the pressure is greatest (sign 1) or least (-1) between two stretches.
double extreme(const Ogden& law, double low, double high, double sign) {
    for (int i = 0; i < 200; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (sign * pressure(law, a) < sign * pressure(law, b) ? low : high) =
            sign * pressure(law, a) < sign * pressure(law, b) ? a : b;
    }
    return 0.5 * (low + high);
}

}  // namespace

TEST_CASE("rubber: a sphere's pressure is greatest and least where theory has it",
          "[gas][membranes][FX6]") {
    const Ogden treloar = treloarRubber(), neo = neoHookean(1);
    const auto near = [](double value, double expected, double digits) {
        CHECK(std::fabs(value - expected) < digits);
    };
    near(extreme(treloar, 1.1, 2, 1), 1.3741, 1e-4);
    near(pressure(treloar, 1.3741) / 1e6, 0.54941, 1e-5);
    near(extreme(treloar, 3, 6, -1), 4.3203, 1e-4);
    near(pressure(treloar, 4.3203) / 1e6, 0.23555, 1e-5);
    near(pressure(treloar, 2) / 1e6, 0.41081, 1e-5);
    near(pressure(treloar, 6) / 1e6, 0.26625, 1e-5);
    near(extreme(neo, 1.1, 2, 1), std::pow(7, 1.0 / 6), 1e-6);
    near(pressure(neo, std::pow(7, 1.0 / 6)) / 2, 0.6197315, 1e-7);
    near(pressure(neo, 3) / 2, 0.332876, 1e-6);
    const Ogden mooney = mooneyRivlin(1, 0.1);
    near(extreme(mooney, 1.1, 2, 1), 1.4761, 1e-4);
    near(pressure(mooney, 1.4761) / 2, 0.74531, 1e-5);
    near(extreme(mooney, 2, 5, -1), 3.1426, 1e-4);
}

TEST_CASE("rubber: derivatives are those of its energy, relaxed or not", "[gas][membranes]") {
    const Ogden law = treloarRubber();
    for (const auto& [a, b] : {std::pair{1.3, 1.1}, {2.5, 0.9}, {1.4, 0.7}, {0.9, 0.8}}) {
        for (const bool relaxed : {false, true}) {
            const auto at = [&](double x, double y) {
                return relaxed ? law.relaxedAt(x, y) : law.at(x, y);
            };
            const double d = 1e-5;
            const PrincipalEnergy e = at(a, b);
            const auto close = [](double value, double expected) {
                CHECK(std::fabs(value - expected) < 1e-4 * (1e5 + std::fabs(expected)));
            };
            close(e.a, (at(a + d, b).value - at(a - d, b).value) / (2 * d));
            close(e.b, (at(a, b + d).value - at(a, b - d).value) / (2 * d));
            close(e.aa, (at(a + d, b).a - at(a - d, b).a) / (2 * d));
            close(e.bb, (at(a, b + d).b - at(a, b - d).b) / (2 * d));
            close(e.ab, (at(a, b + d).a - at(a, b - d).a) / (2 * d));
        }
    }
    CHECK(law.relaxedAt(0.9, 0.5).value == 0);
}

// Nine numbers of a triangle's corners, as x, and what its energy is.
TEST_CASE("rubber: forces and second derivatives of a triangle are those of its energy",
          "[gas][membranes]") {
    const Ogden law = treloarRubber();
    Random random(3);
    const auto vector = [&] { return random.point(1); };
    double worstForce = 0, worstBlock = 0;
    for (int n = 0; n < 50; ++n) {
        const Vec<double> a{0, 0, 0}, b = Vec<double>{1, 0, 0} + 0.3 * vector(),
                                      c = Vec<double>{0.4, 0.9, 0} + 0.3 * vector();
        const Patch patch(a, b, c, 1e-3);
        // Taut in every direction, so that nothing is cut.
        const double size = random.uniform(1.5, 2.5);
        Vec<double> x[3] = {vector(), {}, {}};
        const Vec<double> lean = 0.1 * vector();
        x[1] = x[0] + size * (b - a) + lean;
        x[2] = x[0] + 1.2 * size * (c - a) - lean;
        const auto at = [&](const Vec<double>* y, std::array<Vec<double>, 3>& forces,
                            std::array<Block, 6>& blocks) {
            return patch.forces(law, false, y[1] - y[0], y[2] - y[0], forces, blocks);
        };
        std::array<Vec<double>, 3> forces, less, more;
        std::array<Block, 6> blocks, unused;
        at(x, forces, blocks);
        const double scale = length(forces[0]) + length(forces[1]), d = 1e-6;
        // Of corners 0, 1 and 2 among each other.
        static constexpr int of[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) {
                const Vec<double> axis{double(k == 0), double(k == 1), double(k == 2)};
                Vec<double> y[3] = {x[0], x[1], x[2]};
                y[i] = x[i] + d * axis;
                const double up = at(y, more, unused);
                y[i] = x[i] - d * axis;
                const double down = at(y, less, unused);
                worstForce = std::max(
                    worstForce, std::fabs(dot(forces[i], axis) + (up - down) / (2 * d)) / scale);
                for (int j = 0; j < 3; ++j) {
                    const Vec<double> slope = (1 / (2 * d)) * (less[j] - more[j]);
                    const Block& block = blocks[of[j][i]];
                    const Block own = j > i ? block.transposed() : block;
                    worstBlock = std::max(worstBlock, length(slope - own.column[k]) / scale);
                }
            }
    }
    CHECK(report("triangle: force off its energy's slope", worstForce, 1e-7));
    CHECK(report("triangle: second derivative off the slope of forces", worstBlock, 1e-6));
}

TEST_CASE("rubber: no second derivative is negative, however pressed", "[gas][membranes]") {
    const Ogden law = treloarRubber();
    Random random(5);
    const Patch patch({0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}, 1e-3);
    const auto vector = [&](double s) { return random.point(s); };
    double least = 0, largest = 0;
    for (int n = 0; n < 2000; ++n) {
        std::array<Vec<double>, 3> forces;
        std::array<Block, 6> b;
        const double size = n % 4 == 0 ? 0 : 1.5;  // a triangle without area as well
        patch.forces(law, n % 2 == 0, vector(size), vector(1.5), forces, b);
        for (int k = 0; k < 20; ++k) {
            const Vec<double> d[3] = {vector(1), vector(1), vector(1)};
            const auto form = [&](const Block& block, const Vec<double>& u, const Vec<double>& v) {
                return dot(u,
                           v.x * block.column[0] + v.y * block.column[1] + v.z * block.column[2]);
            };
            const double value = form(b[0], d[0], d[0]) + form(b[1], d[1], d[1]) +
                                 form(b[2], d[2], d[2]) + 2 * form(b[3], d[0], d[1]) +
                                 2 * form(b[4], d[0], d[2]) + 2 * form(b[5], d[1], d[2]);
            CHECK(std::isfinite(value));
            least = std::min(least, value);
            largest = std::max(largest, value);
        }
    }
    CHECK(report("triangle: least of the second derivative over the largest", -least / largest,
                 1e-12));
}
