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
};

// Extension at rest in units of g h^2, h the substep.
double extension(const Case& c) {
    World world = plumbLine({.links = c.links});
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
    for (int frame = 0; frame < 5000 && topSpeed(solver) > 1e-10; ++frame) solver.frame();
    REQUIRE(topSpeed(solver) <= 1e-10);
    const double h = solver.substepLength();
    return (-solver.positions().back().y - c.links) / (9.81 * h * h);
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
