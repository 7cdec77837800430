// Pieces that begin within each other part. How much energy that brings is told, not held: they
// part with up to `recovery`, and keep that speed (contacts/pieces/README.md).
#include "piece_pile.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/energy.h>
#include <plait/measure/surfaces/intersections.h>
#include <plait/numbers/splitmix.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double side = 0.1, pitch = 0.085, thick = 1e-3;  // m

// Boxes, turned a little, in a cube of so many each way: each within its neighbours.
Pile crowd(int each, double speed) {
    Pile pile;
    Splitmix chance(1);
    const auto random = [&] { return Vec<double>{chance.both(), chance.both(), chance.both()}; };
    for (int i = 0; i < each * each * each; ++i)
        pile.add(box({side, side, side}),
                 {.density = 1000,
                  .turn = turnBy(0.1 * random()),
                  .shift = pitch * Vec<double>{double(i % each), double(i / each % each),
                                               double(i / each / each)},
                  .velocity = speed * random(),
                  .spin = speed / side * random()},
                 thick, 0.3);
    pile.meet({0, 0, 0});
    return pile;
}

void checkParting(int each, int frames) {
    const Pile pile = crowd(each, 0.2);
    std::vector<std::array<int, 3>> triangles;
    for (int t = 0; t < pile.world.complex.count(2); ++t)
        triangles.push_back(pile.world.complex.triangle(t));
    Solver<float> solver(pile.world, options(10, 4, 2));
    const auto motion = [&] { return kineticEnergy(pile.world.mass, solver.velocities()); };
    const auto momentumNow = [&] { return momentum(pile.world.mass, solver.velocities()); };
    const Vec<double> before = momentumNow();
    const double began = motion();
    double mass = 0;
    for (const double m : pile.world.mass) mass += m;
    const double size = squareRoot(2 * began * mass);  // kg m/s, if all went the same way
    const long crossed = countIntersections(solver.positions(), triangles);
    double most = began;
    for (int frame = 0; frame < frames; ++frame) {
        solver.frame();
        most = std::max(most, motion());
    }
    const std::string what = std::to_string(each * each * each) + " that overlap: ";
    note(what + "edges through faces before", static_cast<double>(crossed));
    CHECK(report(what + "edges through faces after",
                 static_cast<double>(countIntersections(solver.positions(), triangles)), 0));
    CHECK(report(what + "momentum, off", length(momentumNow() - before) / size, 1e-5));
    note(what + "energy, times as much at most (asked: 1)", most / began);
    CHECK(crossed > 2 * std::ssize(pile.world.pieces));
}

}  // namespace

TEST_CASE("piece overlap: a few dozen part", "[pieces][D21]") { checkParting(4, 24); }

TEST_CASE("piece overlap: a few hundred part", "[pieces][long][D21]") { checkParting(7, 24); }
