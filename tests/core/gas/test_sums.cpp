// A sum is one orthogonal projection: it ends where its law says, in one value, and what is closed
// pushes and turns nothing that is not there.
#include "gas_worlds.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <algorithm>
#include <array>

using namespace plait;
using namespace plait::test;

namespace {

// Vertices of any masses, off their rest, and a sum over them.
template <class Real>
struct Sample {
    std::vector<Particle<Real>> particles;
    std::vector<Padded<Real>> out, before;

    Sample(Random& random, const std::vector<Vec<double>>& positions, double off) {
        for (const Vec<double>& x : positions) {
            const Vec<double> d = random.point(off);
            particles.push_back({{Real(x.x), Real(x.y), Real(x.z)},
                                 Real(random.uniform(0.5, 2)),
                                 {Real(d.x), Real(d.y), Real(d.z)},
                                 0});
            out.push_back({random.below(2) ? Vec<Real>{Real(d.y), Real(d.z), 0} : Vec<Real>{}, 0});
            before.push_back({{}, 0});
        }
    }
    Sweep<Real> sweep(double h = 1) {
        return {&particles[0].x.x, &out[0].v.x, Real(1 / (h * h)), 1, 1, &before[0].v.x};
    }
    std::vector<Vec<double>> positions() const {
        std::vector<Vec<double>> all;
        for (const auto& p : particles)
            all.push_back({double(p.x.x) + double(p.d.x), double(p.x.y) + double(p.d.y),
                           double(p.x.z) + double(p.d.z)});
        return all;
    }
};

// Of m d over all vertices, and of x cross m d about the middle; parts of the sums of their sizes.
template <class Real>
std::array<double, 2> momentumOf(const Sample<Real>& before, const Sample<Real>& after) {
    const auto from = before.positions(), to = after.positions();
    Vec<double> linear{}, angular{};
    double linearSize = 0, angularSize = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double m = 1 / double(before.particles[i].w);
        const Vec<double> x = from[i] - from[0], p = m * (to[i] - from[i]);
        linear += p;
        angular += cross(x, p);
        linearSize += length(p);
        angularSize += length(x) * length(p);
    }
    return {length(linear) / linearSize, length(angular) / angularSize};
}

std::shared_ptr<const Sums<Volume>> volumeSum(const Enclosure& enclosure, const SumLaw& law) {
    Rows<Volume> rows;
    for (const auto& t : enclosure.triangles) {
        rows.ids.insert(rows.ids.end(), t.begin(), t.end());
        rows.rows.push_back({});
    }
    auto sums = std::make_shared<Sums<Volume>>();
    sums->add(rows, law);
    return sums;
}

// A closed ball, and a tube whose ends are caps, 3 m from the origin.
std::vector<std::pair<Shape, Enclosure>> closedSurfaces() {
    std::vector<std::pair<Shape, Enclosure>> all;
    const Frame off{.origin = {3, -1, 2}};
    for (const Shape& shape : {sphere({.subdivisions = 3, .radius = 0.5}, off),
                               tube({.segments = 24, .rings = 9, .radius = 0.3}, off)}) {
        World world;
        const Range range = world.add(shape);
        all.emplace_back(shape, enclose(world, {range}, {.cap = true}));
    }
    return all;
}

template <class Real>
void checkMomentum(double bound) {
    Random random(4);
    for (const auto& [shape, enclosure] : closedSurfaces()) {
        const Sample<Real> start(random, shape.positions, 0.03);
        const double rest = 1.3 * volume(enclosure, start.positions());
        SumSet<Volume, Real> set(volumeSum(enclosure, {.rest = rest}));
        Workers workers(1);
        Sample<Real> once = start;
        set.project(once.sweep(), Direction::forward, workers);
        const auto [linear, angular] = momentumOf(start, once);
        Sample<Real> many = start;
        for (int i = 0; i < 100; ++i) {
            if (i == 50) set.damp(many.sweep(), workers);
            set.project(many.sweep(), Direction::forward, workers);
        }
        REQUIRE(volume(enclosure, many.positions()) / rest == Approx(1).epsilon(1e-6));
        const std::string name = std::string(enclosure.caps().empty() ? "ball" : "capped tube") +
                                 (sizeof(Real) == 4 ? ", float" : ", double");
        REQUIRE(report("net force of the pressure, " + name, linear, bound));
        REQUIRE(report("net torque of the pressure, " + name, angular, bound));
        REQUIRE(
            report("momentum through 100 projections, " + name, momentumOf(start, many)[0], bound));
    }
}

}  // namespace

TEST_CASE("gas: the pressure in a closed surface has no net force and no torque", "[gas]") {
    checkMomentum<double>(1e-12);
    checkMomentum<float>(1e-6);
}

TEST_CASE("gas: a sum reaches its value", "[gas]") {
    Random random(6);
    double worst = 0;
    for (const auto& [shape, enclosure] : closedSurfaces()) {
        Sample<double> sample(random, shape.positions, 0.03);
        const double rest = 0.8 * volume(enclosure, sample.positions());
        SumSet<Volume, double> set(volumeSum(enclosure, {.rest = rest}));
        Workers workers(1);
        for (int i = 0; i < 8; ++i) set.project(sample.sweep(), Direction::forward, workers);
        worst = std::max(worst, std::fabs(volume(enclosure, sample.positions()) / rest - 1));
    }
    REQUIRE(report("volume after eight projections", worst, 1e-14));
}

TEST_CASE("gas: a sum loses nothing far from the origin", "[gas]") {
    Random random(11);
    auto [shape, enclosure] = closedSurfaces()[0];
    for (Vec<double>& x : shape.positions) x += Vec<double>{4096, -4096, 4096};
    Sample<double> sample(random, shape.positions, 0.03);
    const double rest = 0.8 * volume(enclosure, sample.positions());
    SumSet<Volume, double> set(volumeSum(enclosure, {.rest = rest}));
    Workers workers(1);
    for (int i = 0; i < 8; ++i) set.project(sample.sweep(), Direction::forward, workers);
    // Positions are rounded to 5e-13 m as they are read.
    REQUIRE(report("volume after eight projections, 7 km away",
                   std::fabs(volume(enclosure, sample.positions()) / rest - 1), 1e-11));
}

// Of the constrained minimum of m d^2 / 2: d = W g lambda with g at the end, whatever the way
// there.
TEST_CASE("gas: a law with compliance ends where load and stiffness balance", "[gas]") {
    Random random(7);
    const auto [shape, enclosure] = closedSurfaces()[0];
    Sample<double> sample(random, shape.positions, 0);
    const double from = volume(enclosure, sample.positions());
    const double h = 0.8;
    const SumLaw law{.rest = 1.1 * from, .load = 3, .softness = 2, .stiffness = 50};
    SumSet<Volume, double> set(volumeSum(enclosure, law));
    Workers workers(1);
    set.begin({h, 1}, workers);
    for (int i = 0; i < 40; ++i) set.project(sample.sweep(h), Direction::forward, workers);
    const double force = set.multiplier(0) / (h * h);
    const double c = volume(enclosure, sample.positions()) - law.rest;
    REQUIRE(report("softness (f - load) + stiffness C",
                   std::fabs(law.softness * (force - law.load) + law.stiffness * c), 1e-10));
    REQUIRE(std::fabs(c + law.rest - from) > 0.01 * from);
    REQUIRE(std::fabs(force - law.load) > 0.1);
}

TEST_CASE("gas: damping takes its part of the rate of a volume", "[gas]") {
    Random random(8);
    const auto [shape, enclosure] = closedSurfaces()[1];
    Sample<double> sample(random, shape.positions, 0.01);
    SumSet<Volume, double> set(volumeSum(enclosure, {}));
    Workers workers(1);
    const auto rate = [&] {  // by differences, V is a cubic
        const auto shifted = [&](double s) {
            auto x = sample.positions();
            for (std::size_t i = 0; i < x.size(); ++i) x[i] += s * sample.out[i].v;
            return volume(enclosure, x);
        };
        return (shifted(1e-3) - shifted(-1e-3)) / 2e-3;
    };
    const double before = rate();
    Sweep<double> sweep = sample.sweep();
    sweep.strength = 0.25;
    set.damp(sweep, workers);
    REQUIRE(report("rate left by a damping of a quarter", std::fabs(rate() / before - 0.75), 1e-6));
    REQUIRE(std::fabs(before) > 1e-5);
}

TEST_CASE("gas: what has collapsed to a point or a plane stays finite", "[gas]") {
    const Shape ball = sphere({.subdivisions = 2, .radius = 1});
    World world;
    const Enclosure enclosure = enclose(world, {world.add(ball)});
    Random random(9);
    for (const double size : {0.0, 1e-12, 1e-3})
        for (const double flat : {0.0, 1e-9, 1.0}) {
            auto positions = ball.positions;
            for (Vec<double>& x : positions) x = {size * x.x, size * flat * x.y, size * x.z};
            Sample<float> sample(random, positions, 0);
            SumSet<Volume, float> set(volumeSum(enclosure, {.rest = 1}));
            Workers workers(1);
            for (int i = 0; i < 40; ++i) set.project(sample.sweep(), Direction::forward, workers);
            for (const Vec<double>& x : sample.positions()) REQUIRE(length(x) < 1e3);
        }
}

// The other sort of kind: a ring of links whose lengths together are told, as a belt's are.
TEST_CASE("gas: a sum of lengths is one tension", "[gas]") {
    Random random(10);
    std::vector<Vec<double>> positions;
    Rows<Stretch> links;
    constexpr int n = 300;
    for (int i = 0; i < n; ++i) {
        positions.push_back(random.point(1));
        links.ids.insert(links.ids.end(), {i, (i + 1) % n});
        links.rows.push_back({});
    }
    const auto around = [&](const std::vector<Vec<double>>& x) {
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += length(x[(i + 1) % n] - x[i]);
        return sum;
    };
    const double rest = 0.9 * around(positions);
    auto sums = std::make_shared<Sums<Stretch>>();
    sums->add(links, {.rest = rest});
    Sample<double> sample(random, positions, 0);
    const Sample<double> start = sample;
    SumSet<Stretch, double> set(sums);
    Workers workers(1);
    set.project(sample.sweep(), Direction::forward, workers);
    // One tension in all of them: each vertex moves by w (u1 - u0) alike.
    double worst = 0;
    for (int i = 0; i < n; ++i) {
        const auto unit = [&](int a, int b) {
            const Vec<double> u = positions[(b + n) % n] - positions[(a + n) % n];
            return 1 / length(u) * u;
        };
        const Vec<double> pull = unit(i, i + 1) - unit(i - 1, i);
        const Vec<double> move = sample.positions()[i] - positions[i];
        worst = std::max(worst, length(move + set.multiplier(0) * start.particles[i].w * pull));
    }
    REQUIRE(report("moves that are not those of one tension, m", worst, 1e-14));
    REQUIRE(report("momentum of a sum of lengths", momentumOf(start, sample)[0], 1e-12));
    for (int i = 0; i < 20; ++i) set.project(sample.sweep(), Direction::forward, workers);
    REQUIRE(report("length of a belt", std::fabs(around(sample.positions()) / rest - 1), 1e-12));
}

TEST_CASE("gas: sums that share vertices take turns", "[gas]") {
    // Two halves of a box and a wall between them: each half keeps its volume.
    const Shape box = block({.columns = 2, .rows = 1, .layers = 1, .width = 2});
    Rows<Volume> left, right;
    World world;
    const Range range = world.add(box);
    for (int t = 0; t < world.complex.count(3); ++t) {
        const auto [a, b, c, d] = world.complex.tetrahedron(t);
        const double middle =
            (world.rest[a].x + world.rest[b].x + world.rest[c].x + world.rest[d].x) / 4;
        Rows<Volume>& half = middle < 1 ? left : right;
        for (const auto& face :
             {std::array{b, c, d}, std::array{a, d, c}, std::array{a, b, d}, std::array{a, c, b}}) {
            half.ids.insert(half.ids.end(), face.begin(), face.end());
            half.rows.push_back({});
        }
    }
    Sums<Volume> sums;
    sums.add(left, {.rest = 0.7});
    sums.add(right, {.rest = 1.2});
    constrainSums(world, sums, named("halves"));
    Solver<double> solver(world, {.schedule = {.substeps = 4, .iterations = 30}});
    solver.frame();
    const auto x = solver.positions();
    const auto inside = [&](const Rows<Volume>& half) {
        double six = 0;
        for (std::size_t i = 0; i < half.ids.size(); i += 3)
            six += dot(x[half.ids[i]], cross(x[half.ids[i + 1]], x[half.ids[i + 2]]));
        return six / 6;
    };
    REQUIRE(report("volume of two chambers",
                   std::max(std::fabs(inside(left) - 0.7), std::fabs(inside(right) - 1.2)), 1e-10));
    REQUIRE(range.size() == 12);
}
