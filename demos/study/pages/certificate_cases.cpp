#include "certificate.h"

#include <plait/forces/gravity.h>
#include <plait/solver.h>
#include <plait/stencils.h>

#include <algorithm>
#include <limits>

namespace plait {
namespace {

constexpr double g = 9.81;

// Runs until nothing moves; false after 30 s.
bool comesToRest(Solver<double>& solver) {
    const auto topSpeed = [&] {
        double most = 0;
        for (const Vec<double>& v : solver.velocities()) most = std::max(most, length(v));
        return most;
    };
    for (int frame = 0; frame < 24 * 30; ++frame) {
        solver.frame();
        if (frame > 24 && topSpeed() < 1e-5) return true;
    }
    return false;
}

template <class Measure>
double atRest(const World& world, const CertificateSolve& solve, Method method, Measure measure) {
    Solver<double> solver(world,
                          {.method = method,
                           .schedule = {.substeps = solve.substeps, .iterations = solve.iterations},
                           .damping = 0.3});
    if (!comesToRest(solver)) return std::numeric_limits<double>::quiet_NaN();
    return measure(solver.positions());
}

double lowest(const std::vector<Vec<double>>& x) { return -x.back().y; }

// 1 kg on a soft pin of 100 N/m.
double softPin(const CertificateSolve& solve) {
    World world;
    const Range point = world.add({SimplicialComplex(1), {{0, 0, 0}}});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    world.constrain(restRows<Attach>(pointStencils(point), world.start, 0.01), {.name = "pin"});
    return atRest(world, solve, Method::xpbd, lowest);
}

// A rope of 1 m, 1 kg and EA = 100 N that hangs from its end: how much longer it is.
double rope(const CertificateSolve& solve, Method method) {
    const int links = 4 * solve.refinement;
    World world;
    const Range all = world.add(chain({.links = links, .to = {0, -1, 0}}));
    world.pin({0});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    world.constrain(
        restRows<Stretch>(edgeStencils(world.complex, all), world.rest, 1 / (100.0 * links)),
        {.name = "stretch"});
    return atRest(world, solve, method, [](const auto& x) { return lowest(x) - 1; });
}

// A sheet of 1 m x 1 m and 1 kg, an edge pinned, each of its own edges a spring of 1,000 N/m: how
// much longer it hangs.
double net(const CertificateSolve& solve) {
    const int side = 2 * solve.refinement + 1;
    World world;
    const Range all = world.add(grid({.columns = side, .rows = side}, {.up = {0, -1, 0}}));
    world.pin(pointStencils({0, side}));
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, all), world.rest, 1e-3),
                    {.name = "stretch"});
    return atRest(world, solve, Method::xpbd, [](const auto& x) { return lowest(x) - 1; });
}

// Edges along the sides of the cells.
std::vector<int> sides(const World& world, Range range) {
    std::vector<int> ids;
    const std::vector<int> all = edgeStencils(world.complex, range);
    for (std::size_t i = 0; i < all.size(); i += 2) {
        const Vec<double> d = world.rest[all[i + 1]] - world.rest[all[i]];
        if (d.x * d.y == 0) ids.insert(ids.end(), {all[i], all[i + 1]});
    }
    return ids;
}

// Shear is measured from the first edge of a stencil: let that be a side along x.
std::vector<int> triangles(const World& world, Range range) {
    std::vector<int> ids = triangleStencils(world.complex, range);
    for (std::size_t i = 0; i < ids.size(); i += 3)
        while (world.rest[ids[i]].y != world.rest[ids[i + 1]].y)
            std::rotate(ids.begin() + i, ids.begin() + i + 1, ids.begin() + i + 3);
    return ids;
}

std::vector<int> corners(const World& world, Range range) {
    return cornerStencils(world.complex, range);
}

constexpr double shearModulus = 100;  // N/m, by thickness

// A patch of 1 m x 1 m and 1 kg/m^2 with rigid cell sides stands on its pinned edge and is pulled
// sideways by g: how far its upper edge goes.
template <class Kind>
double patch(const CertificateSolve& solve, double triangleFactor, auto stencils) {
    const int side = solve.refinement + 1;
    World world;
    const Range all = world.add(grid({.columns = side, .rows = side}));
    world.pin(pointStencils({0, side}));
    world.act<Gravity>(GravityOptions{.acceleration = {g / 10, 0, 0}});
    world.constrain(restRows<Stretch>(sides(world, all), world.rest), {.name = "sides"});
    const double triangle = 0.5 / (solve.refinement * solve.refinement);
    world.constrain(restRows<Kind>(stencils(world, all), world.rest,
                                   triangleFactor / (shearModulus * triangle)),
                    {.name = "shear"});
    return atRest(world, solve, Method::xpbd, [](const auto& x) { return x.back().x - 1; });
}

constexpr double gamma = 2;  // w L^3 / B

// Of what bends under its own weight, 1 m beyond the clamp: drop over reach. The clamp is the
// middle of a first, pinned piece.
double droop(const std::vector<Vec<double>>& x) { return -x.back().y / x.back().x; }

double rod(const CertificateSolve& solve) {
    const int links = 8 * solve.refinement;
    const double l = 1 / (links - 0.5);
    World world;
    const Range all = world.add(chain({.links = links, .from = {-l / 2, 0, 0}, .to = {1, 0, 0}}));
    world.pin({0, 1});
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, all), world.rest),
                    {.name = "stretch", .order = 1});
    world.constrain(curveBendRows(world.complex, all, world.rest, g / gamma), {.name = "bend"});
    return atRest(world, solve, Method::xpbd, droop);
}

double strip(const CertificateSolve& solve) {
    const int cells = 8 * solve.refinement, across = solve.refinement;
    const double l = 1 / (cells - 0.5);
    World world;
    const Range all = world.add(
        grid({.columns = cells + 1, .rows = across + 1, .width = 1 + l / 2, .height = 0.125},
             {.origin = {-l / 2, 0, 0}, .up = {0, 0, -1}}),
        {.density = 1});
    world.pin(world.select(all, [&](const Vec<double>& x) { return x.x < 0.75 * l; }));
    world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, all), world.rest),
                    {.name = "stretch", .order = 1});
    world.constrain(bendRows(world.complex, all, world.rest, g / gamma), {.name = "bend"});
    return atRest(world, solve, Method::xpbd, droop);
}

}  // namespace

const std::vector<CertificateCase>& certificateCases() {
    constexpr double elastica = 0.246673;  // H / W at Gamma = 2 (validation A3)
    // The shear at a height y is that of the weight above: w (L - y) / G.
    constexpr double sheared = g / 10 / (2 * shearModulus);
    // Sweeps carry a load one link an evaluation, and what bends is a lever.
    constexpr CertificateSolve bending{.substeps = 200};
    static const std::vector<CertificateCase> all{
        {"attach", "a mass on a soft pin: m g / k", g / 100, false, softPin},
        {"stretch", "a rope that hangs: W L / 2 EA", g / 200, true,
         [](const CertificateSolve& s) { return rope(s, Method::xpbd); }},
        {"shear", "a patch under its weight: w L^2 / 2 G", sheared, true,
         [](const CertificateSolve& s) { return patch<Shear>(s, 1, triangles); }},
        // The right angle turns by the shear, the two others by half of it.
        {"angle, of corners", "a patch under its weight: w L^2 / 2 G", sheared, true,
         [](const CertificateSolve& s) { return patch<Angle>(s, 1.5, corners); }},
        {"angle, of a rod", "heavy elastica, Gamma = 2: H / W", elastica, true, rod, bending},
        {"bend", "strip as heavy elastica, Gamma = 2: H / W", elastica, true, strip, bending},
        // Springs along the load only: k of them side by side, and as many in a row.
        {"stretch, one compliance for every edge of a sheet", "W / 2 k, of the sides alone",
         g / 2000, true, net},
        {"stretch, by nucleus", "a rope that hangs: W L / 2 EA", g / 200, true,
         [](const CertificateSolve& s) { return rope(s, Method::nucleus); }}};
    return all;
}

}  // namespace plait
