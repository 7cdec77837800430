// How far a rigid chain stretches when each substep has few sweeps: the law of validation A1, which
// says in one line why substeps beat iterations.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/solver.h>

#include <numeric>

using namespace plait;
using namespace plait::test;

namespace {

enum class Order { topDown, bottomUp, lowerFirst, upperFirst };  // the last two: of two colours

std::vector<int> colors(Order order, int links) {
    std::vector<int> c(static_cast<std::size_t>(links));
    std::iota(c.begin(), c.end(), 0);
    if (order == Order::bottomUp) std::reverse(c.begin(), c.end());
    if (order == Order::upperFirst || order == Order::lowerFirst)
        for (int& color : c) color = (color + (order == Order::lowerFirst ? 1 : 0)) % 2;
    return c;
}

struct Case {
    Order order = Order::topDown;
    int links = 10;
    int substeps = 1;  // in 1/60 s
    int sweeps = 1;    // in a substep
    Sweeps direction = Sweeps::oneWay;
    double length = 1, gravity = 9.81;
};

// Extension at rest in m.
double hung(const Case& c) {
    const double parts = c.gravity / 9.81;  // plumbLine's gravity is as long as `down`
    World world = plumbLine({.links = c.links, .length = c.length / parts, .down = {0, -parts, 0}});
    Rows<Stretch> links = linksOf(world);
    links.colors = colors(c.order, c.links);
    world.constrain(links, {.name = "stretch"});
    SolverOptions options;
    options.sweeps = c.direction;
    options.damping = 6.0 / c.links;  // about critical
    options.schedule = {
        .substeps = c.substeps, .frameRate = {.frames = 60}, .iterations = c.sweeps};
    Solver<double> solver(world, options);
    advance(solver, 20 * c.links);
    const double still = 1e-10 * std::max(1.0, parts);
    for (int frame = 0; frame < 5000 && topSpeed(solver) > still; ++frame) solver.frame();
    REQUIRE(topSpeed(solver) <= still);
    return -solver.positions().back().y - c.links * c.length;
}

// In units of g h^2, h the substep.
double extension(const Case& c) {
    const double h = 1.0 / (60 * c.substeps);
    return hung(c) / (c.gravity * h * h);
}

double relativeError(double measured, double expected) {
    return std::fabs(measured / expected - 1);
}

}  // namespace

TEST_CASE("the one-sweep stretch law holds in sequence and in two colours [A1]",
          "[statics][law][SC13]") {
    for (const int n : {10, 20, 50}) {
        const double all = n * n;
        const struct {
            Order order;
            const char* name;
            double law;
        } cases[] = {{Order::topDown, "top to bottom", (all - n) / 2},
                     {Order::bottomUp, "bottom to top", (all + n) / 2 - 1},
                     {Order::lowerFirst, "two colours, the top link's last", all / 2},
                     {Order::upperFirst, "two colours, the top link's first", all / 2 - 1}};
        for (const auto& c : cases)
            REQUIRE(report("stretch law, N = " + std::to_string(n) + ", " + c.name,
                           relativeError(extension({.order = c.order, .links = n}), c.law), 1e-8));
    }
}

TEST_CASE("sweeps divide the stretch, substeps divide it squared [A1]", "[statics][law][SC13]") {
    for (const auto& [n, sweeps] : {std::pair{10, 2}, {20, 2}, {20, 4}, {50, 5}, {50, 10}})
        for (const Order order : {Order::topDown, Order::lowerFirst}) {
            const double one = extension({.order = order, .links = n});
            const double many = extension({.order = order, .links = n, .sweeps = sweeps});
            REQUIRE(report("stretch divided by the sweeps, N = " + std::to_string(n) + ", sweeps " +
                               std::to_string(sweeps),
                           relativeError(one / many, sweeps), 0.02));
        }
    note("one sweep over 8, N = 10, top to bottom (8.7 in A1)",
         extension({.links = 10}) / extension({.links = 10, .sweeps = 8}));
    for (const Order order : {Order::topDown, Order::bottomUp, Order::lowerFirst})
        for (const int substeps : {2, 10}) {
            const double one = extension({.order = order, .links = 20});
            const double many = extension({.order = order, .links = 20, .substeps = substeps});
            REQUIRE(report("stretch in h^2, N = 20, substeps " + std::to_string(substeps),
                           relativeError(many, one), 1e-6));
        }
}

// Laws found here, in units of g h^2: the turn in the middle repeats a colour and gains nothing.
TEST_CASE("what palindromes leave of the stretch law [A1]", "[statics][law]") {
    for (const int n : {10, 20, 50}) {
        const double all = n * n;
        const auto error = [&](Order order, double law) {
            return relativeError(extension({order, n, 1, 1, Sweeps::palindrome}), law);
        };
        const std::string name = "palindromic stretch, N = " + std::to_string(n);
        REQUIRE(report(name + ", in sequence", error(Order::topDown, (all + n - 2) / 4), 1e-8));
        REQUIRE(report(name + ", from below", error(Order::bottomUp, (all + n - 2) / 4), 1e-8));
        REQUIRE(report(name + ", two colours", error(Order::lowerFirst, all / 2 - 1), 1e-8));
        REQUIRE(report(name + ", two colours", error(Order::upperFirst, all / 2 - 1), 1e-8));
    }
    for (const int sweeps : {2, 4})
        note("one palindrome over " + std::to_string(sweeps) + ", N = 20, two colours",
             extension({Order::lowerFirst, 20, 1, 1, Sweeps::palindrome}) /
                 extension({Order::lowerFirst, 20, 1, sweeps, Sweeps::palindrome}));
}

// M 5.1: a centimetre for a metre is 100 times the gravity, and that, it says, wants 100 times the
// iterations. So it does; or ten times the substeps.
TEST_CASE("gravity times 100: as many sweeps more, or the root of it in substeps",
          "[statics][law][UN2]") {
    const double one = hung({.links = 50});
    const double swept = hung({.links = 50, .sweeps = 100, .gravity = 981});
    const double stepped = hung({.links = 50, .substeps = 10, .gravity = 981});
    REQUIRE(report("stretch at 100 g with 100 sweeps", relativeError(swept, one), 0.05));
    REQUIRE(report("stretch at 100 g with 10 substeps", relativeError(stepped, one), 1e-6));
    REQUIRE(report("stretch at 100 g with neither, of 100",
                   relativeError(hung({.links = 50, .gravity = 981}), 100 * one), 1e-6));
}

// M 6: strain of the same mesh is as one over its size.
TEST_CASE("large is easier than small: substeps by the root of the size", "[statics][law][UN3]") {
    const auto strain = [](double length, int substeps) {
        return hung({.links = 20, .substeps = substeps, .length = length}) / (20 * length);
    };
    const double large = strain(1, 1);
    REQUIRE(report("strain at a hundredth of the size", relativeError(strain(0.01, 1), 100 * large),
                   1e-5));
    REQUIRE(report("strain there with ten substeps", relativeError(strain(0.01, 10), large), 1e-5));
}
