// Rods that touch themselves: what twists up, and a knot that is pulled tight, never pass through.
#include "tests/catch.h"
#include "tests/core/contacts/contact_worlds.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/rods/rod.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double diameter = 8e-3, spacing = 1.25 * diameter;  // m; of even links
constexpr Wire rubber{.youngs = 5e6, .poisson = 0.45, .density = 1200, .along = diameter};

// The least distance of two segments a b and c d (Ericson, Real-Time Collision Detection, 5.1.9).
double apart(const Vec<double>& a, const Vec<double>& b, const Vec<double>& c,
             const Vec<double>& d) {
    const Vec<double> u = b - a, v = d - c, r = a - c;
    const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), ur = dot(u, r), vr = dot(v, r);
    const double across = uu * vv - uv * uv;
    double s = across > 1e-12 * uu * vv ? std::clamp((uv * vr - ur * vv) / across, 0.0, 1.0) : 0;
    double t = (uv * s + vr) / vv;
    if (t < 0 || t > 1) {
        t = std::clamp(t, 0.0, 1.0);
        s = std::clamp((uv * t - ur) / uu, 0.0, 1.0);
    }
    return length(r + s * u - t * v);
}

struct Closeness {
    double least = infinity;  // m, between two links that share no point
    double part = infinity;   // of what they are to keep: the diameter, or what was between them
    int touching = 0;         // pairs that touch, far along the curve
};

Closeness closenessOf(const Points& x, const Points& rest, Range points) {
    constexpr double far = 10 * diameter;  // m along the curve, which no loop is as tight as
    std::vector<double> at{0}, long_;
    for (int v = points.first; v + 1 < points.last; ++v) {
        long_.push_back(length(rest[v + 1] - rest[v]));
        at.push_back(at.back() + long_.back());
    }
    Closeness found;
    for (int i = 0; i + 1 < points.size(); ++i)
        for (int j = i + 2; j + 1 < points.size(); ++j) {
            const int a = points.first + i, b = points.first + j;
            const double reach = 1.1 * (diameter + long_[i] + long_[j]);
            if (length(x[a] - x[b]) > reach) continue;
            const double now = apart(x[a], x[a + 1], x[b], x[b + 1]);
            const double kept =
                std::min(diameter, apart(rest[a], rest[a + 1], rest[b], rest[b + 1]));
            found.least = std::min(found.least, now);
            found.part = std::min(found.part, now / kept);
            found.touching += at[j] - at[i] > far && now < 1.02 * diameter;
        }
    return found;
}

struct Course {
    double part = infinity;  // as in Closeness, the least of all
    double reach = 0;        // the most that two links go towards each other in a substep, over the
                             // least that is between two as it begins: below 1 none pass each other
    double strain = 0;       // the most
    int touching = 0;        // in the end
    long failures = 0;
};

// Looks at the end of every substep, of which there are so many in 1/24 s.
Course run(const World& world, const Rod& rod, double seconds, int substeps) {
    SolverOptions options{
        .sweeps = Sweeps::oneWay,
        .schedule = {
            .substeps = 1, .frameRate = {24 * substeps, 1}, .iterations = 2, .collisionPasses = 4}};
    options.damping = 1 - std::exp(-4.0 / 24);
    Solver<float> solver(world, options);
    Course course;
    Points before = solver.positions();
    double least = closenessOf(before, world.rest, rod.points).least;
    const long steps = std::lround(24 * substeps * seconds);
    for (long step = 0; step < steps; ++step) {
        solver.frame();
        course.failures += solver.failures();
        const Points x = solver.positions();
        double way = 0;
        for (int v = rod.points.first; v < rod.points.last; ++v)
            way = std::max(way, length(x[v] - before[v]));
        for (int v = rod.points.first; v + 1 < rod.points.last; ++v) {
            const double rest = length(world.rest[v + 1] - world.rest[v]);
            course.strain = std::max(course.strain, std::fabs(length(x[v + 1] - x[v]) / rest - 1));
        }
        course.reach = std::max(course.reach, 2 * way / least);
        const Closeness now = closenessOf(x, world.rest, rod.points);
        least = now.least;
        course.part = std::min(course.part, now.part);
        course.touching = now.touching;
        before = x;
    }
    note("pairs of links that touch, far along the rod", course.touching);
    note("least distance over what is to be kept", course.part);
    return course;
}

void checkNothingPassed(const Course& course) {
    CHECK(course.failures == 0);
    CHECK(report("way of two in a substep over what is between them", course.reach, 1));
    CHECK(report("strain", course.strain, 5e-3));
}

// From 0 at first to 1 after `seconds`, without a jerk.
double ease(double t, double seconds) {
    const double s = std::clamp(t / seconds, 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

Shape line(const std::vector<double>& lengths) {
    Points x{{}};
    for (const double l : lengths) x.push_back(x.back() + Vec<double>{l, 0, 0});
    return {chain({.links = static_cast<int>(lengths.size())}).complex, x};
}

// Lengths from one to ten, at random, of `sum` in all (m).
std::vector<double> uneven(double sum) {
    constexpr double shortest = 0.2 * diameter;
    Random random(29);
    std::vector<double> lengths;
    for (double left = sum; left > 0; left -= lengths.back())
        lengths.push_back(shortest * random.uniform(1, 10));
    return lengths;
}

struct Twisting {
    std::vector<double> links = std::vector<double>(100, spacing);
    double turns = 4;    // of one end against the other
    double chord = 0.6;  // of the ends in the end, over the length
    int substeps = 40;
};

// Both ends are clamped; they are turned against each other while they approach.
Course twist(const Twisting& how) {
    constexpr double seconds = 4;
    World world;
    const Rod rod =
        addRod(world, line(how.links), {.wire = rubber, .toward = {{0, 1, 0}}, .strain = 0.002},
               {.name = "rod"});
    const double whole = world.rest[rod.points.last - 1].x;
    // What is quite straight would be pressed.
    for (int v = rod.points.first; v < rod.points.last; ++v)
        world.velocity[v].z = 0.2 * std::sin(pi * world.rest[v].x / whole);
    for (const int side : {-1, 1}) {
        const int end = side < 0 ? rod.points.first : rod.points.last - 2;
        const int director = side < 0 ? rod.directors.first : rod.directors.last - 1;
        const double turns = how.turns, way = side * 0.5 * (1 - how.chord) * whole;
        world.pin({end, end + 1, director}, [=](const Vec<double>& x, double t) {
            const double part = ease(t, seconds), angle = side * pi * turns * part;
            return Vec<double>{x.x - way * part, x.y * std::cos(angle), x.y * std::sin(angle)};
        });
    }
    meet(world, {{.vertices = rod.points, .thickness = diameter / 2}});
    return run(world, rod, seconds + 2, how.substeps);
}

}  // namespace

TEST_CASE("knots: a rod that is twisted lays itself into a plectoneme", "[rods][contacts]") {
    const Course course = twist({});
    CHECK(course.touching >= 8);
    checkNothingPassed(course);
}

TEST_CASE("knots: a plectoneme of six turns", "[rods][contacts][long]") {
    const Course course = twist({.turns = 6, .chord = 0.5, .substeps = 160});
    CHECK(course.touching >= 16);
    checkNothingPassed(course);
    CHECK(report("nearer than the diameter, of it", 1 - course.part, 0.05));
}

TEST_CASE("knots: a plectoneme of links of 1 : 10", "[rods][contacts][long]") {
    const Course course = twist({.links = uneven(1), .turns = 6, .chord = 0.5, .substeps = 160});
    CHECK(course.touching >= 8);
    checkNothingPassed(course);
}

namespace {

// A loose overhand knot: a trefoil that is cut open where it is widest, with straight ends (m).
Shape overhand(double size, double ends) {
    const auto at = [size](double t) {
        return size * Vec<double>{std::sin(t) + 2 * std::sin(2 * t),
                                  std::cos(t) - 2 * std::cos(2 * t), -2.5 * std::sin(3 * t)};
    };
    // There it runs level, so that the ends stay clear of each other.
    constexpr double from = pi / 2, to = 2 * pi + pi / 6;
    constexpr int samples = 4000;
    const auto way = [&](double t) {
        const Vec<double> d = at(t + 1e-4) - at(t - 1e-4);
        return (1 / length(d)) * d;
    };
    Points fine;
    for (int i = samples; i > 0; --i) fine.push_back(at(from) - (ends * i / samples) * way(from));
    for (int i = 0; i <= samples; ++i) fine.push_back(at(from + (to - from) * i / samples));
    for (int i = 1; i <= samples; ++i) fine.push_back(at(to) + (ends * i / samples) * way(to));
    Points x{fine.front()};
    for (const Vec<double>& p : fine) {
        const Vec<double> d = p - x.back();
        if (length(d) >= spacing) x.push_back(x.back() + (spacing / length(d)) * d);
    }
    return {chain({.links = static_cast<int>(x.size()) - 1}).complex, x};
}

// The ends are pulled apart until the rod is longer than its chord by only this (m).
Course tie(double left, int substeps) {
    constexpr double seconds = 4;
    World world;
    const Rod rod =
        addRod(world, overhand(2.5 * diameter, 0.3),
               {.wire = rubber, .natural = {{0, 0, 0}}, .strain = 0.002}, {.name = "rod"});
    const int first = rod.points.first, last = rod.points.last - 1;
    const Vec<double> chord = world.start[last] - world.start[first];
    const Vec<double> along = (1 / length(chord)) * chord;
    const double pull = 0.5 * ((last - first) * spacing - left - length(chord));
    for (const int side : {-1, 1})
        world.pin({side < 0 ? first : last}, [=](const Vec<double>& x, double t) {
            return x + (side * pull * ease(t, seconds)) * along;
        });
    meet(world, {{.vertices = rod.points, .thickness = diameter / 2}});
    return run(world, rod, seconds + 2, substeps);
}

}  // namespace

// What comes undone touches itself nowhere.
TEST_CASE("knots: an overhand knot that is pulled stays tied", "[rods][figures][contacts]") {
    const Course course = tie(26 * diameter, 40);
    CHECK(course.touching >= 5);
    checkNothingPassed(course);
}

TEST_CASE("knots: an overhand knot is pulled tight", "[rods][contacts][long]") {
    const Course course = tie(18 * diameter, 160);
    CHECK(course.touching >= 5);
    checkNothingPassed(course);
    CHECK(report("nearer than the diameter, of it", 1 - course.part, 0.05));
}

namespace {

// Where a rod clamped at one end hangs in the end.
Points hung(const std::vector<double>& lengths, bool meets) {
    World world;
    const Rod rod =
        addRod(world, line(lengths), {.wire = rubber, .toward = {{0, 1, 0}}}, {.name = "rod"});
    world.pin({rod.points.first, rod.points.first + 1, rod.directors.first});
    world.act<Gravity>(GravityOptions{});
    if (meets) meet(world, {{.vertices = rod.points, .thickness = diameter / 2}});
    SolverOptions options = meeting(80);
    options.sweeps = Sweeps::oneWay;
    options.damping = 1 - std::exp(-8.0 / 24);
    Solver<float> solver(world, options);
    advance(solver, 24 * 2);
    return solver.positions();
}

}  // namespace

// Of two that were nearer than the thickness what was between them is kept, and no more: a rod
// bends as if it did not meet itself.
TEST_CASE("knots: links shorter than the rod is thick do not hold their neighbours",
          "[rods][figures][contacts]") {
    for (const auto& lengths : {std::vector<double>(100, 0.375 * diameter), uneven(0.3)}) {
        const Points free = hung(lengths, false), held = hung(lengths, true);
        double most = 0;
        for (std::size_t v = 0; v <= lengths.size(); ++v)
            most = std::max(most, length(free[v] - held[v]));
        note("it hangs by, m", -free[lengths.size()].y);
        CHECK(report("otherwise than without contacts, m", most, 1e-4));
    }
}

// A spring whose turns overlap by a tenth of the wire.
TEST_CASE("knots: turns that begin in each other stay as they lie", "[rods][contacts]") {
    World world;
    const Rod rod = addRod(
        world, helix({.links = 96, .radius = 5 * diameter, .turns = 4, .pitch = 0.9 * diameter}),
        {.wire = rubber}, {.name = "spring"});
    meet(world, {{.vertices = rod.points, .thickness = diameter / 2}});
    Solver<float> solver(world, meeting(80));
    advance(solver, 24);
    REQUIRE(countsOf(solver, world).contacts > 50);
    CHECK(report("speed, m/s", topSpeed(solver), 1e-5));
}
