// Rods under forces, moments and clamps at their ends, against closed forms.
#include "demos/study/references/heavy_rod.h"
#include "tests/catch.h"
#include "tests/core/rods/rod_worlds.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/forces/field.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <complex>
#include <functional>

using namespace plait;
using namespace plait::test;

namespace {

constexpr Wire nylon{.youngs = 2e9, .along = 4e-3}, steel{.along = 4e-3};

// Forces (N) on the ends of an edge, from where these are (m) and the time (s).
struct LoadOptions {
    int first;
    std::function<std::array<Vec<double>, 2>(const Vec<double>&, const Vec<double>&, double)> on;
};

template <class Real>
class CurveLoad : public Force<Real> {
public:
    CurveLoad(const World&, LoadOptions options) : options_(std::move(options)) {}
    std::string name() const override { return "load"; }
    void apply(State<Real>& state, double t, double h, Workers&) override {
        const int first = options_.first;
        const auto f = options_.on(state.position(first), state.position(first + 1), t);
        for (int i = 0; i < 2; ++i) {
            const Vec<double> p = h * f[i];
            push(state, static_cast<std::size_t>(first) + static_cast<std::size_t>(i),
                 {static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)});
        }
    }

private:
    LoadOptions options_;
};

Rod addClamped(World& world, int links, const Wire& wire, RodModel model = RodModel::straight) {
    const Rod rod =
        addRod(world, clampedLine(links), {.wire = wire, .model = model}, {.name = "rod"});
    clampStart(world, rod);
    return rod;
}

}  // namespace

// A weight on a rod that has none: alpha = P L^2 / B; drop and 1 - reach of the tip (Mattiasson
// 1981; validation A3).
TEST_CASE("loads: a rod with a weight at its end", "[rods][figures]") {
    constexpr int links = 64;
    constexpr double g = 10;
    constexpr struct {
        double alpha, drop, shortened;
    } table[] = {
        {0.2, .06636, .00265}, {1, .30172, .05643}, {3, .60325, .25442}, {10, .81061, .55500}};
    for (const RodModel model : {RodModel::straight, RodModel::framed})
        for (const auto& truth : table) {
            World world;
            const Rod rod = addClamped(world, links, steel, model);
            const int tip = rod.points.last - 1;
            const double load = truth.alpha * steel.bending();
            world.mass[tip] = load / g;
            world.act<Field>(FieldOptions{
                .acceleration = [](const Vec<double>&, double) { return Vec<double>{0, -g, 0}; },
                .objects = {{tip, tip + 1}}});
            Solver<float> solver(world, stepping(25, 6));
            for (int frame = 0; frame < 24 * 8; ++frame) solver.frame();
            const Vec<double> at = solver.positions()[tip];
            const double l = 1 / (links - 0.5);
            Vec<double> mesh{l / 2, 0, 0};
            for (const double a : hangingAngles(std::vector(links, l), steel.bending(),
                                                std::vector(links - 1, load)))
                mesh += l * Vec<double>{std::cos(a), -std::sin(a), 0};
            const std::string name = std::string(model == RodModel::framed ? "framed" : "points") +
                                     ", alpha " + std::to_string(truth.alpha);
            note(name + ", drop, error of the mesh", -mesh.y / truth.drop - 1);
            CHECK(report(name + ", tip off its chain", length(at - mesh), 5e-4));
            CHECK(report(name + ", drop off", std::fabs(-at.y / truth.drop - 1), 2e-3));
            CHECK(report(name + ", reach off", std::fabs(1 - truth.shortened - at.x), 1e-3));
            CHECK(report(name + ", speed, m/s", fastest(solver), 1e-5));
        }
}

// Hinge by hinge M l / B, so that the polygon is exact on any mesh. A moment about an axis that
// stays is no conservative load (Ziegler), and in space the arc flutters: a guide keeps it in its
// plane.
TEST_CASE("loads: a moment bends a rod to an arc of a circle", "[rods]") {
    constexpr int links = 33;
    constexpr double l = 1 / (links - 0.5);
    {
        constexpr double whole = 2 * pi;
        World world;
        const Rod rod = addClamped(world, links, nylon);
        // Light ends would be spun too far in a substep.
        for (const int v : {rod.points.last - 2, rod.points.last - 1}) world.mass[v] = 0.05;  // kg
        const double turn = whole / (links - 1), moment = nylon.bending() / l * turn;
        world.act<CurveLoad>(LoadOptions{
            rod.points.last - 2, [moment](const Vec<double>& a, const Vec<double>& b, double t) {
                const Vec<double> edge = b - a;
                const Vec<double> force = (moment * std::min(t / 8, 1.0) / dot(edge, edge)) *
                                          Vec<double>{-edge.y, edge.x, 0};
                return std::array{-force, force};
            }});
        world.act<Field>(FieldOptions{.acceleration = [](const Vec<double>& x, double) {
            return Vec<double>{0, 0, -1e4 * x.z};
        }});
        Solver<float> solver(world, stepping(50, 4));
        for (int frame = 0; frame < 24 * 20; ++frame) solver.frame();
        Vec<double> tip{-l / 2, 0, 0};
        for (int e = 0; e < links; ++e)
            tip += l * Vec<double>{std::cos(e * turn), std::sin(e * turn), 0};
        const std::string name = "arc of " + std::to_string(whole) + " rad";
        CHECK(report(name + ", tip off, m", length(solver.positions()[rod.points.last - 1] - tip),
                     1e-4));
        CHECK(report(name + ", speed, m/s", fastest(solver), 1e-5));
    }
}

// Pushed together by a tenth of its length, a rod between clamps is an elastica: of the modulus p
// for which 2 E(p) / K(p) - 1 = 0.9, its middle p L / K(p) aside.
TEST_CASE("loads: a rod between two clamps that near each other", "[rods][figures]") {
    double low = 0, high = 0.999;
    while (high - low > 1e-14) {
        const double p = (low + high) / 2;
        (2 * std::comp_ellint_2(p) / std::comp_ellint_1(p) > 1.9 ? low : high) = p;
    }
    const double aside = low / std::comp_ellint_1(low);
    for (const RodModel model : {RodModel::straight, RodModel::framed}) {
        double error[2];
        for (const bool fine : {false, true}) {
            const int links =
                fine ? 65 : 33;  // 1 m from the middle of the first to that of the last
            const double l = 1.0 / (links - 1);
            World world;
            const Rod rod = addRod(
                world, chain({.links = links, .from = {-l / 2, 0, 0}, .to = {1 + l / 2, 0, 0}}),
                {.wire = nylon, .model = model}, {.name = "rod"});
            clampStart(world, rod);
            std::vector<int> end{rod.points.last - 2, rod.points.last - 1};
            if (model == RodModel::framed) end.push_back(rod.directors.last - 1);
            world.pin(end, [](const Vec<double>& at, double t) {
                return at - Vec<double>{0.05 * std::min(t, 2.0), 0, 0};
            });
            world.act<Field>(FieldOptions{.acceleration = [](const Vec<double>&, double t) {
                return Vec<double>{0, t < 2.5 ? 5.0 : 0.0, 0};
            }});
            Solver<float> solver(world, stepping(25, 6, 2));
            for (int frame = 0; frame < 24 * 8; ++frame) solver.frame();
            const auto x = solver.positions();
            const int middle = rod.points.first + links / 2;
            const Vec<double> at = 0.5 * (x[middle] + x[middle + 1]);
            error[fine] = std::fabs(std::hypot(at.y, at.z) / aside - 1);
            CHECK(report("speed, m/s", fastest(solver), 1e-5));
        }
        note("middle off, 33 links", error[0]);
        CHECK(report("middle off, 65 links", error[1], 2e-3));
        CHECK(report("of that with 33 links, a quarter", std::fabs(4 * error[1] / error[0] - 1),
                     0.1));
    }
}

namespace {

// The first mode of a clamped line of point masses: its frequency (rad/s), and the shape of what
// moves, by vertex.
struct Mode {
    double frequency;
    Eigen::VectorXd shape;
};

Mode firstMode(const World& world, int links) {
    const int n = links - 1;
    const double l = 1 / (links - 0.5);
    Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(n, n), stiff, mass = Eigen::MatrixXd::Zero(n, n);
    for (int j = 0; j < n; ++j) {
        turn(j, j) = 1 / l;
        if (j > 0) turn(j, j - 1) = -2 / l;
        if (j > 1) turn(j, j - 2) = 1 / l;
        mass(j, j) = world.mass[2 + j];
    }
    stiff = nylon.bending() / l * turn.transpose() * turn;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiff, mass);
    return {std::sqrt(modes.eigenvalues()(0)), modes.eigenvectors().col(0)};
}

}  // namespace

// 3.5160150 sqrt(B / w L^4). After 100 s against the same oscillator in the same steps: with
// u = 1 / z, BDF2 is (3 - 4 u + u^2) / 2 h = i omega, first order (1 - u) / h = i omega.
TEST_CASE("loads: a cantilever swings for 100 s", "[rods][figures]") {
    constexpr int links = 24, substeps = 40;
    for (const bool second : {true, false}) {
        World world;
        addClamped(world, links, nylon);
        const Mode mode = firstMode(world, links);
        const double size = 1e-3 / mode.shape(links - 2);
        for (int j = 0; j < links - 1; ++j) world.start[2 + j].y = size * mode.shape(j);
        // Slow enough: a second of the film is a part of a second of the rod.
        const double slow = 2 * pi / mode.frequency;
        SolverOptions options = stepping(substeps);
        options.timeScale = slow;
        if (second) options.integrator = Integrator::bdf2;
        Solver<double> solver(world, options);
        constexpr int seconds = 100;
        for (int frame = 0; frame < 24 * seconds; ++frame) solver.frame();
        const auto x = solver.positions(), v = solver.velocities();
        std::complex<double> now = 0;
        double whole = 0;
        for (int j = 0; j < links - 1; ++j) {
            const double part = world.mass[2 + j] * mode.shape(j);
            now += part * std::complex(x[2 + j].y, -v[2 + j].y / mode.frequency);
            whole += part * size * mode.shape(j);
        }
        const double step = 2 * pi / (24 * substeps);
        const std::complex<double> i(0, 1),
            u = second ? 2.0 - std::sqrt(1.0 + 2 * step * i) : 1.0 - step * i,
            expected = std::pow(1.0 / u, 24 * substeps * seconds);
        const double continuum =
            3.5160150 * std::sqrt(nylon.bending() / (nylon.density * nylon.area()));
        now /= whole;
        note("frequency, error of the mesh", mode.frequency / continuum - 1);
        note("amplitude left", std::abs(now));
        note("phase, rad", std::arg(now));
        if (second) {
            CHECK(report("amplitude lost", 1 - std::abs(now), 2e-4));
            CHECK(report("phase, rad", std::fabs(std::arg(now)), 1e-2));
        }
        CHECK(report("amplitude off its law", std::fabs(std::abs(now) / std::abs(expected) - 1),
                     1e-3));
        CHECK(report("phase off its law, rad", std::fabs(std::arg(now / expected)), 1e-3));
    }
}
