// Sheets that are no grids at rest between two pins: how far each stretches at fixed work, by
// palindromes and by the method global, and how both behave where the work is too little.
#include "falling_sheets.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <map>

using namespace plait;
using namespace plait::test;

namespace {

struct Case {
    std::string name;
    Shape shape;
    std::vector<int> pins;
    double swing;  // m, the lowest point of the first 40 frames, converged
    Motion motion = {};
    double bending = 0;  // N m
};

Motion shaking(double frequency) {
    return [=](const Vec<double>& x, double t) {
        return x + Vec<double>{0.2 * std::sin(2 * pi * frequency * t), 0, 0};
    };
}

Shape strip() { return grid({.columns = 3, .rows = 101, .width = 0.02}, lying); }

// A disc of 1 m on two pins of its rim, 120 degrees apart.
Case discOf(int rings) {
    const int rim = 1 + 3 * rings * (rings - 1);
    return {"disc", disc({.rings = rings, .radius = 0.5}, lying), {rim, rim + 2 * rings}, -0.738};
}

// Of n x n vertices, or as many. Swings are those of 32 x 32 by 800 palindromes a frame, and shaken
// at 3 Hz, by 64 steps of 2 iterations of global.
std::vector<Case> casesOf(int n) {
    const std::vector<int> corners{0, n - 1};
    const Shape slender = grid({.columns = 2 * n, .rows = (2 * n + 9) / 10}, lying);
    return {{"disordered", disordered(n), corners, -0.991},
            {"elements of 1:10", slender, {0, 2 * n - 1}, -0.989},
            {"strip of 1:50", strip(), {0, 1, 2}, -0.991},
            discOf(n / 2),
            {"shaken at 1 Hz", square(n), corners, -0.996, shaking(1)},
            {"shaken at 3 Hz", square(n), corners, -1.000, shaking(3)},
            {"like silk", square(n), corners, -0.986, {}, 1e-6},
            {"like wool", square(n), corners, -0.987, {}, 3e-5},
            {"like leather", square(n), corners, -0.991, {}, 1e-3}};
}

Course fall(const Case& of, Work work) {
    work.motion = of.motion;
    work.bending = of.bending;
    return fall(of.name, of.shape, of.pins, work);
}

Work globally(int substeps, int iterations) {
    return {.substeps = substeps,
            .iterations = iterations,
            .sheet = {.strands = false, .tethers = false},
            .method = Method::global};
}

// By palindromes a sheet that is shaken at 3 Hz does not swing as converged, not even by 800 of
// them.
void holdAll(int n, const Work& work) {
    for (const Case& of : casesOf(n)) {
        const Course course = fall(of, work);
        const bool swings =
            n == 32 && (work.method == Method::global || of.name != "shaken at 3 Hz");
        CHECK(course.worst < 0.02);
        CHECK(course.before < (of.motion ? 0.1 : 0.02));  // that begins with a jerk
        if (!of.motion) CHECK(course.energy < 1e-3);
        if (swings) CHECK(std::fabs(course.swing / of.swing - 1) < 0.02);
    }
}

}  // namespace

TEST_CASE("sheet cases: 12 palindromes a frame hold all of 32 x 32 to 2 %",
          "[inextensible][figures]") {
    holdAll(32, {});
}

TEST_CASE("sheet cases: 12 palindromes a frame hold all of 64 x 64", "[inextensible][long]") {
    holdAll(64, {});
}

// Pins shaken at 3 Hz pull with 7 g.
TEST_CASE("sheet cases: without mending they stretch, and no more", "[inextensible][long]") {
    double most = 0;
    for (const Case& of : casesOf(32)) {
        const Course course = fall(of, {.sheet = {.mending = 0}});
        most = std::max(most, course.worst);
        const double bound = of.name == "shaken at 3 Hz" ? 1 : 0.5;
        CHECK(course.worst < bound);
        CHECK(course.before < bound);
    }
    CHECK(most > 0.1);
}

TEST_CASE("sheet cases: 2 steps a frame of 2 iterations of global hold all of 32 x 32 to 2 %",
          "[inextensible][figures]") {
    holdAll(32, globally(2, 2));
}

TEST_CASE("sheet cases: the same of 64 x 64", "[inextensible][long]") {
    holdAll(64, globally(2, 2));
}

// A pin that lets go: a sheet without it that starts as the last one was. From two pins to one, and
// then to none.
TEST_CASE("sheet cases: pins let go one by one", "[inextensible]") {
    for (const Work& work : {Work{}, globally(2, 2)}) {
        const Shape shape = square(32);
        Points at = shape.positions, velocity(at.size());
        double worst = 0, energy = 0;
        for (const std::vector<int>& pins : {std::vector{0, 31}, {0}, {}}) {
            const World world =
                hung(shape, pins, work, {.density = 0.2, .start = at, .velocity = velocity});
            Solver<float> solver(world, optionsOf(work));
            for (int frame = 0; frame < 40; ++frame) {
                solver.frame();
                at = solver.positions();
                velocity = solver.velocities();
                for (const double e : strainsOf(linksOf(world), at)) worst = std::max(worst, e);
                const double now = kineticEnergy(world.mass, velocity) +
                                   gravitationalEnergy(world.mass, at, {0, -9.81, 0});
                CHECK(now < energy + 1e-3);
                energy = std::min(energy, now);
            }
        }
        CHECK(report("pins let go: largest strain of all frames", worst, 0.02));
    }
}

namespace {

// By how much (m) a sheet of 1 m, hung by its first vertices and damped, is longer after 4 s.
template <class Real>
double sag(Shape shape, int pins, const Work& work) {
    std::vector<int> top;
    for (int i = 0; i < pins; ++i) top.push_back(i);
    for (Vec<double>& x : shape.positions) x = {x.x, -x.z, 0};
    SolverOptions options = optionsOf(work);
    options.damping = 0.3;
    Solver<Real> solver(hung(shape, top, work), options);
    advance(solver, 240);
    double lowest = 0;
    for (const Vec<double>& x : solver.positions()) lowest = std::min(lowest, x.y);
    return -lowest - 1;
}

// Soft enough to be a tenth longer, and then as long as Newton has it.
void checkSoft(const std::string& name, const Shape& shape, int pins, double compliance) {
    const Work work{.sheet = {.compliance = compliance}};
    const double much =
        sag<double>(shape, pins, {.substeps = 4, .sheet = work.sheet, .method = Method::newton});
    const double swept = sag<float>(shape, pins, work);
    const double solved =
        sag<float>(shape, pins,
                   {.substeps = 2, .iterations = 2, .sheet = work.sheet, .method = Method::global});
    note(name + ", longer by, m", much);
    CHECK(std::fabs(much - 0.1) < 0.01);
    CHECK(report("    12 palindromes a frame", std::fabs(swept / much - 1), 0.005));
    CHECK(report("    global", std::fabs(solved / much - 1), 0.005));
}

}  // namespace

TEST_CASE("sheet cases: soft cloth is longer by a tenth, and no more", "[inextensible][figures]") {
    checkSoft("strip of 1:50", strip(), 3, 0.15);
    checkSoft("16 x 16", square(16), 16, 0.117);
}

TEST_CASE("sheet cases: the same of 32 x 32 and disordered", "[inextensible][long]") {
    checkSoft("32 x 32", square(32), 32, 0.11);
    checkSoft("disordered", disordered(32), 32, 0.122);
}

namespace {

constexpr int few[] = {1, 2, 4, 8, 16, 32, 64};

// Every setting of up to `most` palindromes or iterations a frame. More of either stretches less,
// but for what is chance in a crumpled sheet, and for what mending leaves alone.
void degradeSoftly(const char* name, const Shape& shape, const std::vector<int>& pins, Work work,
                   int most) {
    std::map<std::pair<int, int>, double> strain;  // of the first second
    const double chance = work.method == Method::global ? 0.003 : work.sheet.mending;
    for (const int substeps : few)
        for (const int iterations : few) {
            if (substeps * iterations > most || iterations > 16) continue;
            work.substeps = substeps;
            work.iterations = iterations;
            const Course course = fall<float>(name, shape, pins, work);
            CHECK(course.energy < 1e-3);
            CHECK(course.before < 0.5);
            strain[{substeps, iterations}] = course.before;
            for (const auto& less :
                 {std::pair{substeps / 2, iterations}, {substeps, iterations / 2}})
                if (strain.count(less)) CHECK(course.before < 1.3 * strain[less] + chance);
        }
}

}  // namespace

TEST_CASE("sheet cases: too little work stretches sheets softly", "[inextensible][figures][AR4]") {
    const Work work{.frames = 60};
    degradeSoftly("grid", square(24), {0, 23}, work, 16);
    degradeSoftly("disordered", disordered(24), {0, 23}, work, 16);
}

TEST_CASE("sheet cases: no substeps and palindromes make them explode", "[inextensible][long]") {
    degradeSoftly("grid", square(24), {0, 23}, {}, 1024);
    degradeSoftly("disordered", disordered(24), {0, 23}, {}, 1024);
    degradeSoftly("disordered, global", disordered(24), {0, 23}, globally(1, 1), 16);
}
