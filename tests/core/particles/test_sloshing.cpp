// Water that swings in a tank, against linear waves.
#include "pools.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double g = 9.81, width = 1;  // m/s^2, m

// Stilled under a gravity that leans by `lean` (a tangent), which then is upright: where the centre
// is along the tank, over time.
struct Swing {
    std::vector<double> centre;  // m, from the middle, frame by frame
    double depth, frame;         // m, s
};
Swing swing(int across, int deep, int perSecond, double lean, double seconds) {
    const double spacing = width / across;
    auto poolOf = [&](std::vector<Vec<double>> positions, double leaning) {
        Pool pool(std::move(positions), spacing, openTank(width, deep * spacing));
        pool.world.act<Gravity>(GravityOptions{.acceleration = {g * leaning, 0, 0}});
        pool.fall(g);
        return pool;
    };
    SolverOptions options = test::perSecond(perSecond);
    options.damping = 0.1;
    const Pool leaning = poolOf(blockOf(across, across / 2, deep, spacing, 0.1), lean);
    Solver<float> still(leaning.world, options);
    for (int frame = 0; frame < 125; ++frame) still.frame();
    const Pool pool = poolOf(still.positions(), 0);
    options.damping = 0;
    Solver<float> solver(pool.world, options);
    Swing found{{}, 0, 0.02};
    for (int frame = 0; frame < seconds * 50; ++frame) {
        double x = 0, y = 0;
        for (const Vec<double>& p : solver.positions()) {
            x += p.x;
            y += p.y;
        }
        const auto n = static_cast<double>(solver.state().count());
        found.centre.push_back(x / n - width / 2);
        found.depth = 2 * y / n;
        solver.frame();
    }
    return found;
}

struct Period {
    double seconds, kept;  // kept: of the amplitude, from a swing to one side to the next to it
};
Period periodOf(const Swing& swing) {
    std::vector<double> crossings, peaks{0};
    for (std::size_t i = 1; i < swing.centre.size(); ++i) {
        const double a = swing.centre[i - 1], b = swing.centre[i];
        peaks.back() = std::max(peaks.back(), std::fabs(b));
        if ((a < 0) == (b < 0)) continue;
        crossings.push_back((static_cast<double>(i) - 1 + a / (a - b)) * swing.frame);
        peaks.push_back(0);
    }
    REQUIRE(crossings.size() >= 3);
    const double swings = static_cast<double>(crossings.size() - 1) / 2;
    return {(crossings.back() - crossings.front()) / swings, divide(peaks[3], peaks[1])};
}

}  // namespace

// The packing is stiff in shear: small swings are a little too quick.
TEST_CASE("liquid: water swings at the frequency of linear waves", "[liquid][figures]") {
    const Swing swung = swing(24, 5, 1000, 0.2, 3);
    const Period period = periodOf(swung);
    const double k = pi / width, omega = std::sqrt(g * k * std::tanh(k * swung.depth));
    note("period, s", period.seconds);
    note("its own, of linear waves", 2 * pi / omega);
    note("kept of the amplitude after a period", period.kept);
    REQUIRE(report("period", std::fabs(period.seconds * omega / (2 * pi) - 1), 0.04));
}
