// A mesh that is drawn to a goal, by attachments alone, which are no more than a set of the user's.
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/worlds.h"

#include <plait/constraints/constants.h>

#include <string>

using namespace plait;
using namespace plait::test;

namespace {

constexpr int across = 8, count = across * across;
constexpr double g = 9.81;

struct Followed {
    std::vector<Vec<double>> off;  // m, from the goal, by vertex
    double strain;
    long work;
};

// A sheet in gravity whose goal goes aside; weight 0 leaves a vertex alone, others share
// `stiffness` (N/m). At the end the goal has stood long enough.
Followed follow(double stiffness, const std::vector<double>& weights) {
    World world;
    const Range sheet =
        world.add(grid({.columns = across, .rows = across}, {.up = {0, 0, -1}}), {.density = 0.2});
    world.constrain(linksOf(world), {.name = "links"});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    const auto goalAt = [rest = world.rest](int v, double t) {
        const double s = std::min(t, 1.0);
        return rest[static_cast<std::size_t>(v)] +
               Vec<double>{0.5 * s * s * (3 - 2 * s), 0, 0.2 * s};
    };
    Rows<Attach> goals = restRows<Attach>(pointStencils(sheet), world.rest);
    for (int v = 0; v < count; ++v) {
        const double weight = weights[static_cast<std::size_t>(v)];
        goals.rows[static_cast<std::size_t>(v)].compliance =
            weight > 0 ? 1 / (stiffness * weight) : slack;
    }
    goals.animate = [goalAt](double t, std::span<Attach::Row<double>> rows) {
        for (int v = 0; v < count; ++v) rows[static_cast<std::size_t>(v)].target = goalAt(v, t);
    };
    world.constrain(goals, {.name = "goal", .order = 1});
    Solver<double> solver(world, {.schedule = {.substeps = 10, .iterations = 20}, .damping = 0.3});
    advance(solver, 100);
    Followed found{{}, 0, solver.evaluations()};
    const Points x = solver.positions();
    for (int v = 0; v < count; ++v)
        found.off.push_back(x[static_cast<std::size_t>(v)] - goalAt(v, solver.time()));
    for (const double e : strainsOf(linksOf(world), x))
        found.strain = std::max(found.strain, std::fabs(e));
    return found;
}

Vec<double> mean(const std::vector<Vec<double>>& all, int from, int to) {
    Vec<double> sum{};
    for (int v = from; v < to; ++v) sum += all[static_cast<std::size_t>(v)];
    return 1.0 / (to - from) * sum;
}

}  // namespace

TEST_CASE("goals: how far a mesh stays behind its goal is its weight over the stiffness",
          "[attach][AT18][AR15]") {
    const std::vector<double> white(count, 1);
    const double load = 0.2 * g / count;  // N a vertex, in the mean
    long work = 0;
    for (const double stiffness : {1.0, 4.0, 16.0}) {
        const Followed sheet = follow(stiffness, white);
        const Vec<double> off = mean(sheet.off, 0, count);
        const std::string at = "stiffness " + std::to_string(stiffness) + " N/m: ";
        CHECK(report(at + "behind the goal, of load / stiffness",
                     length(off + Vec<double>{0, load / stiffness, 0}) / (load / stiffness), 0.01));
        CHECK(report(at + "strain", sheet.strain, 0.01));
        if (work > 0) CHECK(sheet.work == work);
        work = sheet.work;
    }
    // Black hangs on white, and costs the same.
    std::vector<double> painted = white;
    for (int v = 0; v < count / 2; ++v) painted[static_cast<std::size_t>(v)] = 0;
    const Followed half = follow(16, painted);
    CHECK(half.work == work);
    CHECK(report("strain, half of it painted black", half.strain, 0.01));
    const double followed = length(mean(half.off, count / 2, count)),
                 left = length(mean(half.off, 0, count / 2));
    note("white half behind its goal, m", followed);
    note("black half, m", left);
    CHECK(followed < 0.1);
    CHECK(left > 0.2);
}
