// Where float ends: small substeps far from the origin (design 4). A vertex is X + d, so that what
// rounding takes is not lost; the plain loop below has X alone.
#include "tests/catch.h"
#include "tests/hand_state.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/numbers/elementary.h>
#include <plait/solver.h>

using namespace plait;
using namespace plait::test;

namespace {

constexpr int links = 20, rate = 24000;  // substeps a second
constexpr double linkLength = 0.05, g = 9.81, damping = 0.9;
// 1 % of extension under the chain's own weight, 1 kg at each joint.
constexpr double soft = 0.01 * links * linkLength / (g * links * (links + 1) / 2);
constexpr Vec<double> down{2.0 / 3, -2.0 / 3, 1.0 / 3};  // no axis is spared

// It starts straight, at half the extension that it will have, and bounces.
World hangingChain(double distance, double compliance) {
    const Vec<double> top{distance, distance, distance};
    World world = plumbLine({.links = links, .length = linkLength, .top = top, .down = down});
    double depth = 0;
    for (int i = 1; i <= links; ++i) {
        depth += linkLength + 0.5 * compliance * g * (links - i + 1);
        world.start[static_cast<std::size_t>(i)] = top + depth * down;
        world.velocity[static_cast<std::size_t>(i)] = (0.2 * i / links) * down;
    }
    world.constrain(linksOf(world, compliance), {.name = "stretch"});
    return world;
}

// Gathers what a chain at rest does, look by look.
class Watch {
public:
    explicit Watch(double distance) : top_{distance, distance, distance} {}

    void look(const Points& x, const Points& v) {
        for (const Vec<double>& u : v) squares_ += dot(u, u) / links;
        lengths_ += length(x.back() - top_);
        ++looks_;
    }
    // m/s, root mean square over vertices and time.
    double noise() const { return std::sqrt(squares_ / looks_); }
    double extension() const { return lengths_ / looks_ - links * linkLength; }

private:
    Vec<double> top_;
    double squares_ = 0, lengths_ = 0;
    int looks_ = 0;
};

constexpr double settling = 1, watching = 1;  // s: damped, then free

template <class Real>
Watch watch(double distance, double compliance) {
    World world = hangingChain(distance, compliance);
    SolverOptions options{.schedule = {.substeps = 100, .frameRate = {240, 1}, .iterations = 1},
                          .damping = damping};
    Solver<Real> damped(world, options);
    advance(damped, static_cast<int>(settling * 240));
    world.start = damped.positions();
    world.velocity = damped.velocities();
    options.damping = 0;
    Solver<Real> free(world, options);
    Watch result(distance);
    for (int i = 0; i < watching * 240; ++i) {
        free.frame();
        result.look(free.positions(), free.velocities());
    }
    return result;
}

Points wide(const std::vector<Vec<float>>& all) {
    Points points;
    for (const Vec<float>& a : all) points.push_back(widened(a));
    return points;
}

// The same chain by the textbook: one float position a vertex.
Watch watchPlain(double distance, double compliance) {
    const float h = 1.0f / rate, soften = static_cast<float>(compliance) / (h * h);
    const World world = hangingChain(distance, compliance);
    std::vector<Vec<float>> x;
    for (const Vec<double>& p : world.start) x.push_back(narrowed<float>(p));
    std::vector<Vec<float>> v(x.size()), before(x.size());
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = narrowed<float>(world.velocity[i]);
    std::vector<float> lambda(links);
    const Vec<float> gravity = narrowed<float>(g * down);
    const auto project = [&](int i) {
        const Vec<float> d = x[i + 1] - x[i];
        const float l = length(d), w = i > 0 ? 2 : 1;
        const float change = -(l - float(linkLength) + soften * lambda[i]) / (w + soften);
        lambda[i] += change;
        x[i + 1] += (change / l) * d;
        if (i > 0) x[i] -= (change / l) * d;
    };
    Watch result(distance);
    for (int step = 0; step < (settling + watching) * rate; ++step) {
        const bool free = step >= settling * rate;
        const float kept = free ? 1 : static_cast<float>(power(1 - damping, 24.0 / rate));
        before = x;
        for (int i = 1; i <= links; ++i) x[i] += h * (v[i] += h * gravity);
        std::fill(lambda.begin(), lambda.end(), 0.0f);
        for (int i = 0; i < links; ++i) project(i);
        for (int i = links - 1; i >= 0; --i) project(i);
        for (int i = 1; i <= links; ++i) v[i] = (kept / h) * (x[i] - before[i]);
        if (free && step % 100 == 0) result.look(wide(x), wide(v));
    }
    return result;
}

std::string at(double distance, const char* what) {
    return std::to_string(static_cast<int>(distance)) + " m from the origin: " + what;
}

double extensionError(const Watch& watch) {
    return std::fabs(watch.extension() / (0.01 * links * linkLength) - 1);
}

}  // namespace

TEST_CASE("a float chain far out is at rest at 24,000 substeps a second", "[statics][floor]") {
    for (const double distance : {0.0, 10.0, 100.0}) {
        const Watch stretchy = watch<float>(distance, soft), rigid = watch<float>(distance, 0);
        REQUIRE(report(at(distance, "noise of a soft chain, m/s"), stretchy.noise(), 1e-4));
        REQUIRE(report(at(distance, "its extension, relative"), extensionError(stretchy), 5e-3));
        REQUIRE(report(at(distance, "noise of a rigid chain, m/s"), rigid.noise(), 1e-4));
        // One palindrome in two colours (test_stretch_law.cpp).
        const double law = g * (links * links / 2 - 1) / (double(rate) * rate);
        note(at(distance, "its extension over the stretch law's"), rigid.extension() / law);
    }
    const Watch full = watch<double>(10, soft);
    note("the same in double: noise, m/s", full.noise());
    note("its extension, relative", extensionError(full));
}

TEST_CASE("plain float positions are not", "[statics][floor]") {
    for (const double distance : {0.0, 10.0, 100.0}) {
        const Watch stretchy = watchPlain(distance, soft);
        note(at(distance, "noise of plain floats, m/s"), stretchy.noise());
        note(at(distance, "their extension, relative"), extensionError(stretchy));
        note(at(distance, "noise, rigid, m/s"), watchPlain(distance, 0).noise());
        if (distance < 10) continue;
        REQUIRE(stretchy.noise() > 1e-3);
        REQUIRE(extensionError(stretchy) > 0.05);
    }
}

// A compiler that folds double(float(x)) into x loses it: see the flags in CMakeLists.txt.
TEST_CASE("a float start keeps what one float leaves", "[statics][floor]") {
    World world = plumbLine({.links = 4, .length = 0.1, .top = {0.1, 10.2, 100.3}, .down = down});
    const Solver<float> solver(world, {});
    double worst = 0;
    for (std::size_t i = 0; i < world.start.size(); ++i)
        worst = std::max(worst, length(solver.positions()[i] - world.start[i]));
    REQUIRE(report("start in float, m", worst, 1e-12));
}
