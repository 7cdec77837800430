// A ball into a net of curves that hangs in a goal by slack ties (S 1).
#include "../parts/bodies.h"
#include "../parts/measures.h"
#include "../parts/views.h"
#include "curves.h"

#include <plait/constraints/constants.h>
#include <plait/contacts/solids/collider.h>
#include <plait/contacts/surface.h>
#include <plait/forces/gravity.h>
#include <plait/numbers/elementary.h>
#include <plait/rods/chain_set.h>
#include <plait/stencils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace plait {
namespace {

constexpr double width = 3, height = 2, depth = 0.9;  // m, as in handball
constexpr double lowest = 0.03;                       // m, of the net above the ground
constexpr double cord = 0.012;                        // kg/m
constexpr double stiffness = 2e4;    // N, of a cord of polypropylene, 4 mm thick: force over strain
constexpr double thickness = 0.002;  // m, to either side of cords and ball
constexpr double radius = 0.11, mass = 0.43;  // m, kg: a ball for feet
constexpr double away = 8;                    // m, from where it is kicked to the mouth

// From post to post round the back, `columns` by `rows` cells of cords that cross in knots, in the
// middle of each side of a cell a joint. Upright cords and level ones are curves of their own.
struct Net {
    int columns, rows;
    Range vertices{};
    std::vector<std::vector<int>> upright{}, level{};

    int knot(int column, int row) const { return vertices.first + row * (columns + 1) + column; }
};

// The mouth is at z = 0, the back at z = -depth.
Vec<double> placeOf(const Net& net, double column, double row) {
    const double s = (width + 2 * depth) * column / net.columns;
    const double y = lowest + (height - lowest) * (1 - row / net.rows);
    if (s < depth) return {-width / 2, y, -s};
    if (s > depth + width) return {width / 2, y, s - 2 * depth - width};
    return {s - depth - width / 2, y, -depth};
}

Net addNet(World& world, double cell) {
    Net net{.columns = static_cast<int>(std::lround((width + 2 * depth) / cell)),
            .rows = static_cast<int>(std::lround(height / cell))};
    const int base = static_cast<int>(world.start.size());
    net.vertices = {base, base};
    Shape shape;
    Simplices cells;
    for (int row = 0; row <= net.rows; ++row)
        for (int column = 0; column <= net.columns; ++column)
            shape.positions.push_back(placeOf(net, column, row));
    const auto run = [&](int along, int number, bool down) {
        std::vector<int> curve;
        for (int i = 0; i <= along; ++i) {
            const int knot = down ? net.knot(number, i) : net.knot(i, number);
            if (i > 0) {
                const double middle = i - 0.5;
                shape.positions.push_back(down ? placeOf(net, number, middle)
                                               : placeOf(net, middle, number));
                curve.push_back(base + static_cast<int>(shape.positions.size()) - 1);
            }
            curve.push_back(knot);
        }
        for (std::size_t i = 1; i < curve.size(); ++i)
            cells.edges.push_back({curve[i - 1] - base, curve[i] - base});
        return curve;
    };
    for (int column = 0; column <= net.columns; ++column)
        net.upright.push_back(run(net.rows, column, true));
    for (int row = 0; row <= net.rows; ++row) net.level.push_back(run(net.columns, row, false));
    shape.complex = SimplicialComplex(static_cast<int>(shape.positions.size()), cells);
    net.vertices = world.add(shape, {.density = cord});
    return net;
}

void holdCords(World& world, const std::vector<std::vector<int>>& curves, const char* name) {
    Chains chains;
    Rows<Stretch> links;
    for (const std::vector<int>& curve : curves) {
        chains.addCurve(curve);
        for (std::size_t i = 1; i < curve.size(); ++i) {
            const double rest = length(world.rest[static_cast<std::size_t>(curve[i])] -
                                       world.rest[static_cast<std::size_t>(curve[i - 1])]);
            links.ids.insert(links.ids.end(), {curve[i - 1], curve[i]});
            links.rows.push_back({rest, rest / stiffness, rest / stiffness});
        }
    }
    chains.add(links);
    chains.constrain(world, {.name = name});
}

// Hooks of the frame, outside of the net, and ties that only pull.
void addTies(World& world, const Net& net, double slackLength) {
    std::vector<int> knots;
    Shape hooks;
    const auto tie = [&](int knot, const Vec<double>& off) {
        knots.push_back(knot);
        hooks.positions.push_back(world.rest[static_cast<std::size_t>(knot)] +
                                  0.5 * slackLength * off);
    };
    for (int column = 0; column <= net.columns; ++column) tie(net.knot(column, 0), {0, 1, 0});
    for (int row = 1; row <= net.rows; ++row) {
        tie(net.knot(0, row), {0, 0, 1});
        tie(net.knot(net.columns, row), {0, 0, 1});
    }
    hooks.complex = SimplicialComplex(static_cast<int>(knots.size()));
    const Range pins = world.add(hooks, {.density = 0.001});
    world.pin(pointStencils(pins));
    Rows<Stretch> ties;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        ties.ids.insert(ties.ids.end(), {pins.first + static_cast<int>(i), knots[i]});
        ties.rows.push_back({slackLength, slackLength / stiffness, slack});
    }
    world.constrain(ties, {.name = "ties", .order = 1});
}

// It is to meet the back at this place.
Piece addBall(World& world, double speed, double g, int subdivisions) {
    const Vec<double> from{-1.0, 0.35, away}, to{0.45, 1.25, -depth + radius};
    const double flight = (from.z - to.z) / speed;
    Vec<double> velocity = (1 / flight) * (to - from);
    velocity.y += g * flight / 2;
    const Shape shape = sphere({.subdivisions = subdivisions, .radius = radius}, {.origin = from});
    const Piece ball = addSolid(world, shape, mass);
    const Vec<double> spin{-14, 9, 4};  // rad/s
    for (int v = ball.vertices.first; v < ball.vertices.last; ++v)
        world.velocity[static_cast<std::size_t>(v)] =
            velocity + cross(spin, world.start[static_cast<std::size_t>(v)] - from);
    return ball;
}

// In % of the ball's at the start, along the shot.
Metric momentum(const std::string& name, const World& world, const std::vector<Range>& ranges,
                double whole, Band band) {
    return {.name = name,
            .unit = "%",
            .measure =
                [=, masses = world.mass](const Snapshot& at) {
                    double sum = 0;
                    for (const Range& range : ranges)
                        for (auto v = static_cast<std::size_t>(range.first);
                             v < static_cast<std::size_t>(range.last); ++v)
                            sum -= masses[v] * at.velocities[v].z;
                    return 100 * sum / whole;
                },
            .low = band.low,
            .high = band.high,
            .caption = true};
}

// Ivory, with a patch of vermilion round each corner of the icosahedron it is made from.
Look ballLook(const World& world, const Piece& ball) {
    Look look = lookOf(ball.surface(), Material::rubber, 0);
    const int first = ball.surface().first;
    for (int v = first; v < ball.surface().last; ++v) {
        double nearest = 1;
        for (std::size_t corner = 0; corner < 12; ++corner)
            nearest =
                std::min(nearest, length(world.start[static_cast<std::size_t>(v)] -
                                         world.start[static_cast<std::size_t>(first) + corner]));
        look.colors.push_back(nearest < 0.42 * radius ? std::array{0.578, 0.032, 0.014}
                                                      : std::array{0.880, 0.791, 0.658});
    }
    return look;
}

void addFrame(View& view, double off) {
    constexpr double bar = 0.035;
    const double x = width / 2 + bar, y = height + off + bar, back = -depth - bar;
    for (const double side : {-x, x}) {
        addBar(view, {side, 0, off}, {side, y, off}, bar, Material::steel);
        addBar(view, {side, 0, back}, {side, y, back}, 0.6 * bar, Material::steel);
        addBar(view, {side, y, off}, {side, y, back}, 0.6 * bar, Material::steel);
    }
    addBar(view, {-x - bar, y, off}, {x + bar, y, off}, bar, Material::steel);
    addBar(view, {-x, y, back}, {x, y, back}, 0.6 * bar, Material::steel);
}

View viewOf(const World& world, const Net& net, const Piece& ball, double slackLength) {
    View view;
    view.looks = {lookOf(net.vertices, Material::cotton, 0.004), ballLook(world, ball)};
    view.looks[0].material = Material::rubber;
    view.looks[0].color = {0.880, 0.791, 0.658};
    view.cameras = {{.eye = {2.6, 1.5, -4.6}, .target = {0.15, 0.95, -0.4}, .focalLength = 38}};
    view.groundSize = 3;
    view.glowCenter = {-0.5, 1.2, 4};
    addFrame(view, slackLength / 2);
    return view;
}

}  // namespace

Scene goal(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    const double speed = knobs.number("speed"), g = knobs.number("gravity"),
                 slackLength = knobs.number("slack");
    const Net net = addNet(world, knobs.byQuality(0.12, 0.12, 0.1));
    const Piece ball = addBall(world, speed, g, knobs.byQuality(3, 3, 4));
    addTies(world, net, slackLength);
    if (g > 0) world.act<Gravity>(GravityOptions{.acceleration = {0, -g, 0}});
    holdCords(world, net.upright, "upright cords");
    holdCords(world, net.level, "level cords");
    holdPieces(world, {.name = "ball", .order = 2});
    const Surface cords = roughSurface(net.vertices, thickness, 0.3);
    Surface skin = roughSurface(ball.surface(), thickness, 0.3);
    skin.self = Self::none;
    meet(world, {cords, skin}, {.order = 3});
    collide(world, {{.solid = Solid::plane(), .staticFriction = 0.5, .dynamicFriction = 0.5}},
            {cords, skin}, {.order = 4});
    scene.options.schedule = {.substeps = knobs.byQuality(24, 24, 32),
                              .frameRate = {120, 1},
                              .iterations = 6,
                              .collisionPasses = 6};
    scene.seconds = 2;
    const double whole = mass * speed;
    scene.metrics = {momentum("of both", world, {ball.vertices, net.vertices}, whole, {-100, 101}),
                     momentum("of the ball", world, {ball.vertices}, whole, {-100, 101}),
                     selfIntersections(world, {net.vertices.first, ball.vertices.last}, {0, 0}),
                     greatestStrain(world, net.vertices, {-5, 5}), contactFailures()};

    scene.view = viewOf(world, net, ball, slackLength);
    const double hit = (away + depth) / speed;
    scene.view.takes = {
        {.from = 0, .to = scene.seconds},
        {.from = hit - 0.12, .to = hit + 0.5, .slow = 5, .words = "5 times slower"}};
    return scene;
}

}  // namespace plait
