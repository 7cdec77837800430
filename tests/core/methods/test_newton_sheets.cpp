// Newton's method on sheets, contacts, rods and air: what is left of its equations, and what has no
// closed form but must be as theory says.
#include "newton_options.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/air/air.h>

#include <cmath>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

// A sheet that is curved, of soft links, shear and bending, with corners pinned.
World softSheet(int n) {
    World world;
    Shape shape = grid({.columns = n, .rows = n});
    for (Point& p : shape.positions) p.z = 0.1 * std::sin(3 * p.x + 2 * p.y);
    const Range sheet = world.add(shape, {.density = 0.2});
    world.pin({0, n - 1});
    world.act<Gravity>(GravityOptions{});
    world.constrain(linksOf(world, 1e-4), {.name = "stretch"});
    world.constrain(restRows<Shear>(triangleStencils(world.complex, sheet), world.rest, 1e-2),
                    {.name = "shear"});
    world.constrain(bendRows(world.complex, sheet, world.rest, 1e-2), {.name = "bend"});
    return world;
}

struct Moment {
    Points x, v;
};
template <class Real>
Moment momentOf(const Solver<Real>& solver) {
    return {solver.positions(), solver.velocities()};
}

// The largest force on a vertex that is left of M a + sum of C grad C / alpha - M g = 0, in units
// of the largest that acts, for the acceleration `a` that the integrator means.
double unbalanced(const World& world, const Solver<double>& solver, const Points& a) {
    Points left(a.size());
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) left[i] = world.mass[i] * (a[i] - Point{0, -g, 0});
    for (int s = 0; s < static_cast<int>(world.sets.size()); ++s) {
        Terms<double> terms;
        REQUIRE(solver.set(s).terms(solver.state(), false, terms));
        for (int n = 0; n < terms.size(); ++n)
            for (int k = terms.arity * n; k < terms.arity * (n + 1); ++k) {
                const Point f = (terms.value[n] / terms.compliance(n)) * terms.gradient[k];
                left[terms.ids[k]] += f;
                most = std::max(most, length(f));
            }
    }
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!world.pinned[i]) worst = std::max(worst, length(left[i]));
    return worst / most;
}

// A square sheet of rigid links, bulging down by `bulge` m, hung by two corners.
World rigidSheet(int n, double bulge) {
    World world;
    Shape shape = grid({.columns = n, .rows = n}, {.across = {1, 0, 0}, .up = {0, 0, 1}});
    for (Point& p : shape.positions) p.y = -bulge * std::sin(M_PI * p.x) * std::cos(M_PI * p.z);
    world.add(shape, {.density = 0.2});
    world.pin({0, n - 1});
    world.act<Gravity>(GravityOptions{});
    world.constrain(linksOf(world), {.name = "stretch"});
    return world;
}

}  // namespace

TEST_CASE("newton: nothing is left of the equations of a soft sheet", "[newton]") {
    const World world = softSheet(8);
    const double h = 1.0 / 240;
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2}) {
        Solver<double> solver(world, newton(240, integrator));
        Moment earlier{}, last{}, now = momentOf(solver);
        double worst = 0;
        for (int k = 0; k < 20; ++k) {
            solver.frame();
            earlier = std::exchange(last, std::exchange(now, momentOf(solver)));
            Points a;
            for (std::size_t i = 0; i < now.v.size(); ++i) {
                const Point dv = now.v[i] - last.v[i];
                const bool second = integrator == Integrator::bdf2 && k > 0;
                a.push_back(second ? (0.5 / h) * (3.0 * dv - (last.v[i] - earlier.v[i]))
                                   : (1 / h) * dv);
            }
            worst = std::max(worst, unbalanced(world, solver, a));
        }
        // Velocities are differences of positions, so their accelerations have lost digits.
        CHECK(report("soft sheet, " + nameOf(integrator) + ": force left, of the largest", worst,
                     1e-9));
    }
}

TEST_CASE("newton: a sheet of rigid links", "[newton][figures]") {
    for (const Integrator integrator : all) {
        Solver<double> solver(rigidSheet(10, 0.01), newton(2400, integrator));
        advance(solver, 60);
        const Rows<Stretch> links = linksOf(rigidSheet(10, 0.01));
        double worst = 0;
        for (const double strain : strainsOf(links, solver.positions()))
            worst = std::max(worst, std::fabs(strain));
        CHECK(report("sheet of 10 x 10, " + nameOf(integrator) + ": strain", worst, 3e-14));
        note("sheet of 10 x 10, " + nameOf(integrator) + ": work per link and substep, in sweeps",
             double(solver.evaluations()) / (60.0 * double(links.size())));
    }
}

TEST_CASE("newton: what has no solution is said, and the frame is taken back",
          "[newton][figures]") {
    // Flat, the equations of rigid links are singular.
    Solver<double> solver(rigidSheet(10, 0), newton(240, Integrator::first));
    const std::uint64_t before = solver.hash();
    CHECK_THROWS_AS(solver.frame(), Diverged);
    CHECK(solver.hash() == before);
    CHECK(solver.evaluations() == 0);
}

TEST_CASE("newton: one-sided constraints", "[newton]") {
    for (const Integrator integrator : {Integrator::first, Integrator::bdf2}) {
        // A bead thrown along the floor from above it, and a link that buckles.
        World world = loosePoints({{0, 0.1, 0}, {5, 0.5, 0}, {5, 0.1, 0}});
        world.pin({1});
        world.velocity[0] = {1, 0, 0};
        world.act<Gravity>(GravityOptions{});
        auto floor = restRows<PlaneContact>({0}, world.rest);
        floor.rows[0] = {{0, 0, 0}, {0, 1, 0}, 0.01};
        world.constrain(floor, {.name = "floor", .order = 1});
        Rows<Stretch> cord = restRows<Stretch>({1, 2}, world.rest);
        cord.rows[0].compression = slack;
        cord.rows[0].rest = 1;
        world.constrain(cord, {.name = "cord"});
        Solver<double> solver(world, newton(240, integrator));
        advance(solver, 24);
        const double drop = 0.5 * g * 0.01;
        CHECK(std::fabs(solver.positions()[2].y - (0.1 - drop)) < 3e-3);  // falls freely
        advance(solver, 480);
        const Points x = solver.positions();
        CHECK(report("bead on a floor, " + nameOf(integrator) + ": height, m",
                     std::fabs(x[0].y - 0.01), 1e-12));
        CHECK(report("bead on a floor, " + nameOf(integrator) + ": way, m",
                     std::fabs(x[0].x - 504.0 / 240), 1e-11));
        // BDF2 bounces on it.
        const double longer = length(x[2] - x[1]) - 1;
        CHECK(report("cord, " + nameOf(integrator) + ": too long, m",
                     integrator == Integrator::first ? std::fabs(longer) : longer, 1e-12));
    }
}

TEST_CASE("newton: a cantilever at rest is the elastica", "[newton]") {
    // Validation A3: drop over reach of a heavy elastica.
    for (const auto& [gamma, exact] : {std::pair{1.0, 0.124562}, {5.0, 0.585721}}) {
        const int links = 16;
        const double l = 1 / (links - 0.5);
        World world;
        const Range rod =
            world.add(chain({.links = links, .from = {-l / 2, 0, 0}, .to = {1, 0, 0}}));
        world.pin({0, 1});
        // Bent a little, since the angle of a straight curve has a kink.
        for (int i = 2; i <= links; ++i) {
            const double turn = 0.03 * (i - 1);
            world.start[i] = world.start[i - 1] + l * Point{std::cos(turn), -std::sin(turn), 0};
        }
        world.act<Gravity>(GravityOptions{});
        world.constrain(linksOf(world), {.name = "stretch"});
        world.constrain(curveBendRows(world.complex, rod, world.rest, g / gamma), {.name = "bend"});
        Solver<double> solver(world, newton(24, Integrator::first));
        advance(solver, 400);
        const Point tip = solver.positions().back();
        CHECK(report("cantilever, speed left, m/s", topSpeed(solver), 1e-5));
        CHECK(report("cantilever of 16 links, H/W", std::fabs(-tip.y / tip.x / exact - 1), 0.01));
    }
}

// Linear drag is implicit in velocity, so BDF2 has it at its own order; midpoint does not.
TEST_CASE("newton: forces of air have an order of their own", "[newton]") {
    for (const auto& [integrator, order] :
         {std::pair{Integrator::first, 1}, {Integrator::bdf2, 2}, {Integrator::midpoint, 1}}) {
        double before = 0;
        for (const int steps : {120, 240}) {
            World world;
            world.add(grid({.columns = 2, .rows = 2}, {.across = {1, 0, 0}, .up = {0, 0, 1}}),
                      {.density = 0.2});
            world.act<Gravity>(GravityOptions{});
            actAir(world, {.form = AirForm::legacy, .drag = 1, .tangentialDrag = 0});
            world.constrain(linksOf(world), {.name = "stretch"});
            Solver<double> solver(world, newton(steps, integrator));
            advance(solver, steps);
            // Validation A4: tau = sigma / c, y = -g tau (t - tau (1 - exp(-t / tau))).
            const double exact = -g * 0.2 * (1 - 0.2 * (1 - std::exp(-5.0)));
            const double error = std::fabs(solver.positions()[0].y - exact);
            if (before > 0) {
                note("plate in air, " + nameOf(integrator) + ": order", std::log2(before / error));
                CHECK(std::fabs(std::log2(before / error) - order) < 0.1);
            }
            before = error;
        }
    }
}

TEST_CASE("newton: a run goes on from where it was, bit for bit", "[newton]") {
    for (const Integrator integrator : all) {
        SolverOptions options = newton(240, integrator);
        options.schedule.substeps = 4;
        Solver<double> whole(softSheet(6), options), again(softSheet(6), options);
        advance(whole, 3);
        again.frame();
        const State<double> middle = again.state();
        const long work = again.evaluations();
        Solver<double> resumed(softSheet(6), options);
        resumed.restore(middle, work);
        advance(resumed, 2);
        CHECK(resumed.hash() == whole.hash());
        CHECK(resumed.evaluations() == whole.evaluations());
    }
}
