// Pieces: vertices that move as one, with the mass of a solid.
#include "piece_worlds.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/forces/field.h>
#include <plait/measure/surfaces/solid.h>

#include <algorithm>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

double largest(const Symmetric<double>& a) {
    return std::max({std::fabs(a.xx), std::fabs(a.xy), std::fabs(a.xz), std::fabs(a.yy),
                     std::fabs(a.yz), std::fabs(a.zz)});
}

// Of the point masses about their centre.
SolidMoments momentsOf(const World& world, Range range) {
    SolidMoments sum{};
    for (int v = range.first; v < range.last; ++v) {
        sum.volume += world.mass[v];
        sum.centre += world.mass[v] * world.rest[v];
    }
    sum.centre = (1 / sum.volume) * sum.centre;
    for (int v = range.first; v < range.last; ++v)
        sum.second.addOuter(world.mass[v], world.rest[v] - sum.centre);
    return sum;
}

// I = (1, 2, 3), flat: four point masses.
World top() {
    World world;
    const double b = std::sqrt(2.0);
    Shape points{SimplicialComplex(4), {{2, 0, 0}, {-2, 0, 0}, {0, b, 0}, {0, -b, 0}}};
    std::vector<Vec<double>> velocity;
    for (const Vec<double>& x : points.positions) velocity.push_back(cross({0.01, 1, 0.01}, x));
    world.pieces.push_back(world.add(points, {.density = 0.25, .start = {}, .velocity = velocity}));
    holdPieces(world, {.name = "top", .importance = 1});
    return world;
}

template <class Real>
struct Spinning {
    Solver<Real> solver;
    World world;

    explicit Spinning(int rate)
        : solver(top(), {.integrator = Integrator::bdf2,
                         .schedule = {.substeps = 1, .frameRate = {rate, 1}, .iterations = 1}}),
          world(top()) {}

    // rad/s, about its own second axis.
    double rate() const {
        const auto x = solver.positions(), v = solver.velocities();
        const Vec<double> l = angularMomentum(world.mass, x, v, {0, 0, 0});
        const Vec<double> axis = x[2] - x[3];
        return dot(l, axis) / length(axis) / 2;
    }
    double momentum() const {
        return length(
            angularMomentum(world.mass, solver.positions(), solver.velocities(), {0, 0, 0}));
    }
};

}  // namespace

TEST_CASE("pieces: mass, centre and inertia are the solid's", "[pieces]") {
    for (const Shape& shape :
         {box({1, 2, 3}), box({0.05, 0.04, 0.004}), prism(3, 0.03, 0.004), prism(6, 0.5, 2)}) {
        World world;
        const Piece piece = addPiece(world, shape, {.density = 2500});
        std::vector<std::array<int, 3>> triangles;
        for (int t = 0; t < shape.complex.count(2); ++t)
            triangles.push_back(shape.complex.triangle(t));
        const SolidMoments solid = solidMoments(shape.positions, triangles);
        SolidMoments sum = momentsOf(world, piece.vertices);
        REQUIRE(report("mass of a piece, off", std::fabs(sum.volume / (2500 * solid.volume) - 1),
                       1e-12));
        REQUIRE(report("its centre, m", length(sum.centre - solid.centre), 1e-14));
        const double most = largest(solid.second);
        sum.second.add(-2500, solid.second);
        REQUIRE(report("its moments, off", std::fabs(largest(sum.second) / (2500 * most)), 1e-12));
        double corners = 0;
        for (int v = 0; v < piece.corners; ++v) corners += world.mass[v];
        note("part of the mass at its corners", corners / sum.volume);
        REQUIRE(corners > 0.15 * sum.volume);
    }
    // The closed form of a box.
    const Shape shape = box({1, 2, 3});
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < shape.complex.count(2); ++t) triangles.push_back(shape.complex.triangle(t));
    const SolidMoments solid = solidMoments(shape.positions, triangles);
    REQUIRE(report("volume of a box, off", std::fabs(solid.volume / 6 - 1), 1e-14));
    REQUIRE(report("its inertia, off", std::fabs(solid.inertia().xx / (6 * (4 + 9) / 12.0) - 1),
                   1e-14));
}

// ω2 of a top I = (1, 2, 3) that starts at (0.01, 1, 0.01), by elliptic functions.
TEST_CASE("pieces: a torque-free top turns over when it should", "[pieces]") {
    constexpr double crossings[] = {10.91691, 30.46978, 50.02265};
    for (const auto& [rate, late, lost] :
         {std::tuple{240, 20e-3, 3e-5}, std::tuple{960, 0.5e-3, 2e-6}}) {
        Spinning<double> top(rate);
        const double momentum = top.momentum();
        double before = top.rate(), worst = 0, off = 0;
        int crossed = 0;
        for (int step = 1; crossed < 3 && step < 51 * rate; ++step) {
            top.solver.frame();
            const double now = top.rate();
            if ((now > 0) != (before > 0)) {
                const double at = (step - now / (now - before)) / rate;
                worst = std::max(worst, std::fabs(at - crossings[crossed++]));
            }
            before = now;
            off = std::max(off, std::fabs(top.momentum() / momentum - 1));
        }
        const std::string where = ", " + std::to_string(rate) + " steps a second";
        REQUIRE(crossed == 3);
        REQUIRE(report("a top turns over late, s" + where, worst, late));
        REQUIRE(report("its angular momentum, off" + where, off, lost));
    }
}

TEST_CASE("pieces: distances within stay, in float", "[pieces][DC15]") {
    Spinning<float> top(240);
    double worst = 0;
    for (int frame = 0; frame < 2400; ++frame) {
        top.solver.frame();
        const auto x = top.solver.positions();
        for (int a = 0; a < 4; ++a)
            for (int b = 0; b < a; ++b)
                worst = std::max(worst, std::fabs(length(x[a] - x[b]) / length(top.world.rest[a] -
                                                                               top.world.rest[b]) -
                                                  1));
    }
    REQUIRE(report("distances in a top, off", worst, 1e-6));
}

// A piece about its axis, turned faster and faster by a field or not at all: how far its angular
// velocity is off after a second.
TEST_CASE("pieces: spin is of first order, of second by BDF2", "[pieces][IN18][IN19]") {
    constexpr double omega = 2, alpha = 1.5;  // rad/s, rad/s^2
    const auto off = [](Integrator integrator, double gain, int rate) {
        World world;
        const Piece bar = addPiece(world, box({1, 0.2, 0.1}), {.density = 1000});
        for (int v = bar.vertices.first; v < bar.vertices.last; ++v)
            world.velocity[v] = cross({0, 0, omega}, world.rest[v]);
        holdPieces(world, {.name = "bar", .importance = 1});
        if (gain > 0)
            world.act<Field>(FieldOptions{.acceleration = [gain](const Vec<double>& x, double) {
                return cross({0, 0, gain}, x);
            }});
        Solver<double> solver(
            world, {.integrator = integrator,
                    .schedule = {.substeps = 1, .frameRate = {rate, 1}, .iterations = 1}});
        for (int step = 0; step < rate; ++step) solver.frame();
        double inertia = 0;
        for (std::size_t v = 0; v < world.mass.size(); ++v)
            inertia += world.mass[v] *
                       (world.rest[v].x * world.rest[v].x + world.rest[v].y * world.rest[v].y);
        const Vec<double> l =
            angularMomentum(world.mass, solver.positions(), solver.velocities(), {0, 0, 0});
        return std::fabs(l.z / inertia - omega - gain);
    };
    const auto order = [&](const std::string& what, Integrator integrator, double gain) {
        const double coarse = off(integrator, gain, 120), fine = off(integrator, gain, 240);
        note(what + ", 120 steps, off, rad/s", coarse);
        note("240 steps", fine);
        return std::log2(coarse / fine);
    };
    CHECK(order("steady spin, first order", Integrator::first, 0) == Approx(1).margin(0.1));
    CHECK(order("ever faster, first order", Integrator::first, alpha) == Approx(1).margin(0.1));
    CHECK(order("steady spin, BDF2", Integrator::bdf2, 0) > 1.9);
    CHECK(order("ever faster, BDF2", Integrator::bdf2, alpha) > 1.9);
}

// A plate of height L about its upper edge, I = m L^2 / 3.
TEST_CASE("pieces: a plate hung by an edge swings in time", "[pieces]") {
    constexpr double l = 0.5, g = 9.81;
    World world;
    const Piece plate = addPiece(world, box({0.3, l, 1e-3}), {.density = 1000});
    world.pin(
        world.select(plate.surface(), [](const Vec<double>& x) { return x.y > 0 && x.z > 0; }));
    for (int v = plate.vertices.first; v < plate.vertices.last; ++v) {
        const Vec<double> r = world.rest[v] - Vec<double>{0, l / 2, 0};
        constexpr double angle = 0.02;
        world.start[v] = Vec<double>{0, l / 2, 0} +
                         Vec<double>{r.x, std::cos(angle) * r.y - std::sin(angle) * r.z,
                                     std::sin(angle) * r.y + std::cos(angle) * r.z};
    }
    holdPieces(world, {.name = "plate", .importance = 1});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    Solver<double> solver(world,
                          {.integrator = Integrator::bdf2,
                           .schedule = {.substeps = 1, .frameRate = {960, 1}, .iterations = 1}});
    const auto aside = [&] { return solver.positions()[plate.vertices.first].z; };
    double before = aside(), first = 0, last = 0;
    int crossed = 0;
    for (int step = 1; crossed < 9; ++step) {
        REQUIRE(step < 20000);
        solver.frame();
        const double now = aside();
        if ((now > 0) != (before > 0)) {
            last = (step - now / (now - before)) / 960;
            if (crossed++ == 0) first = last;
        }
        before = now;
    }
    const double period = 2 * pi * std::sqrt(2 * l / (3 * g));
    REQUIRE(
        report("period of a hung plate, off", std::fabs((last - first) / 4 / period - 1), 5e-3));
}

TEST_CASE("pieces: what is no solid is refused", "[pieces]") {
    World world;
    Shape open = box({1, 1, 1});
    open.complex =
        SimplicialComplex(8, {.edges = {}, .triangles = {{0, 2, 1}, {1, 2, 3}}, .tetrahedra = {}});
    REQUIRE_THROWS_WITH(addPiece(world, open, {}, "shard"), Catch::Contains("shard"));
    Shape turned = box({1, 1, 1});
    for (Vec<double>& x : turned.positions) x.x = -x.x;
    REQUIRE_THROWS_WITH(addPiece(world, turned, {}, "shard"), Catch::Contains("inside out"));
    Shape flat = box({1, 1, 1});
    for (Vec<double>& x : flat.positions) x.z = 0;
    REQUIRE_THROWS_WITH(addPiece(world, flat, {}, "shard"), Catch::Contains("flat"));
    REQUIRE_THROWS_WITH(addPiece(world, box({1, 1, 1}), {.density = 0}, "shard"),
                        Catch::Contains("density"));
    REQUIRE(world.rest.empty());
}
