#include "slinky.h"

#include "../parts/hung_helix.h"

#include <plait/complex/shapes.h>
#include <plait/constraints/constants.h>
#include <plait/numbers/arctangent.h>
#include <plait/numbers/elementary.h>
#include <plait/solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace plait {
namespace {

constexpr double g = 9.81;  // m/s^2

double around(const Slinky& slinky) { return 2 * pi * slinky.radius; }

double levelPitch(const Slinky& slinky) { return arctangent2(slinky.wire.across, around(slinky)); }

// The part of its turns that the pre-tension does not hold together as it hangs.
double openOf(const Slinky& slinky) { return 1 - slinky.pretension / (slinky.mass() * g); }

// rad/m: a pre-tension is a twist that its wire had less of before its turns met.
double untwistOf(const Slinky& slinky) {
    return slinky.pretension * slinky.radius / slinky.wire.twisting();
}

// Of what is not on the next turn. A coil of straight links is stiffer (tests/core/rods): by 2 % at
// 24 a turn.
Helix hungBy(const Slinky& slinky, double force, const Helix& at) {
    const double twisting =
        slinky.wire.twisting() * (1 + 7 * pi * pi / (6.0 * slinky.links * slinky.links));
    const double level = levelPitch(slinky), c = cosine(level), bend = c * c / slinky.radius,
                 twist = sine(level) * c / slinky.radius - untwistOf(slinky),
                 pitch = arctangent2(twist, bend), cosineOfRest = cosine(pitch);
    const Helix helix = hungBy({pitch, cosineOfRest * cosineOfRest / bend},
                               {slinky.wire.bendingSide(), twisting}, force, at);
    return helix.pitch > level ? helix : Helix{level, slinky.radius};
}

// As it is wound.
Vec<double> naturalOf(const Slinky& slinky, const Vec<double>& edge) {
    const double l = length(edge), rise = edge.y / l, bend = 2 * pi / (slinky.links * l);
    return {0, -bend * std::sqrt(1 - rise * rise), bend * rise - untwistOf(slinky)};
}

}  // namespace

double Slinky::mass() const {
    const double turn = std::sqrt(around(*this) * around(*this) + wire.across * wire.across);
    return wire.density * wire.area() * turn * turns;
}

double Slinky::stiffness() const {
    return wire.twisting() / (2 * pi * turns * radius * radius * radius);
}

double Slinky::period() const { return 4 * std::sqrt(mass() / stiffness()); }

double Slinky::extension() const {
    const double free = 1 - 1.0 / turns, open = openOf(*this);
    return 0.968 * free * free * open * open * mass() * g / (2 * stiffness());
}

double Slinky::collapse() const {
    return std::sqrt(mass() / (3 * stiffness()) * std::pow(openOf(*this), 3));
}

std::vector<std::string> factsOf(const Slinky& slinky) {
    const auto line = [](const char* name, const char* format, double value) {
        char words[80];
        std::snprintf(words, sizeof words, format, value);
        return std::string(name) + words;
    };
    const double closed = slinky.turns * slinky.wire.across;
    return {line("mass                 ", "%.1f g", 1000 * slinky.mass()),
            line("stiffness            ", "%.3f N/m", slinky.stiffness()),
            line("slowest swing, hung  ", "%.2f s", slinky.period()),
            line("pre-tension          ", "%.2f N", slinky.pretension),
            line("length, closed       ", "%.1f mm", 1000 * closed),
            line("length, hung         ", "%.2f m", closed + slinky.extension()),
            line("its last turn hangs  ", "%.3f s once it is let go", slinky.collapse())};
}

Rod addSlinky(World& world, const Slinky& slinky, const Vec<double>& foot) {
    const int edges = slinky.turns * slinky.links;
    const Shape curve = helix({.links = edges,
                               .radius = slinky.radius,
                               .turns = static_cast<double>(slinky.turns),
                               .pitch = slinky.wire.across},
                              {.origin = foot});
    std::vector<Vec<double>> outward;
    for (int e = 0; e < edges; ++e) {
        const auto i = static_cast<std::size_t>(e);
        const Vec<double> middle = 0.5 * (curve.positions[i] + curve.positions[i + 1]) - foot;
        outward.push_back({middle.x, 0, middle.z});
    }
    const Vec<double> natural = naturalOf(slinky, curve.positions[1] - curve.positions[0]);
    return addRod(world, curve,
                  {.wire = slinky.wire, .natural = {natural}, .toward = outward, .strain = 0.002},
                  {.name = "wire"});
}

// A little thinner than it is, so that turns that rest on each other do not press.
Surface skinOf(const Slinky& slinky, const Rod& rod) {
    return {.vertices = rod.points,
            .thickness = 0.499 * slinky.wire.across,
            .directors = rod.directors,
            .halfWidth = 0.5 * slinky.wire.along};
}

std::vector<int> upperTurns(const Slinky& slinky, const Rod& rod, int turns) {
    std::vector<int> vertices;
    for (int i = 0; i <= turns * slinky.links; ++i) vertices.push_back(rod.points.last - 1 - i);
    for (int i = 0; i < turns * slinky.links; ++i) vertices.push_back(rod.directors.last - 1 - i);
    return vertices;
}

// From a helix that knows its own angle, 0.5 % off since the turn that holds it is level, to rest.
void hang(World& world, const Slinky& slinky, const Rod& rod) {
    int e = 0;
    while (!world.pinned[rod.points.first + e]) ++e;
    const double l = length(world.rest[1] - world.rest[0]),
                 weight = slinky.wire.density * slinky.wire.area() * l * g;
    std::vector<Helix> links{{levelPitch(slinky), slinky.radius}};
    for (int i = 0; i < e; ++i) links.push_back(hungBy(slinky, (i + 0.5) * weight, links.back()));

    std::vector<Vec<double>>& x = world.start;
    const Vec<double> held = x[rod.points.first + e];
    const Vec<double> axis = x[rod.points.last - 1] - Vec<double>{slinky.radius, 0, 0};
    // Of the polygon, whose last vertex is where the first one is, turn by turn.
    double angle = -2 * pi * (e % slinky.links) / slinky.links, y = held.y;
    for (int i = e - 1; i >= 0; --i) {
        const auto& [pitch, radius] = links[i + 1];
        y -= l * sine(pitch);
        const double half = l * cosine(pitch) / 2;
        angle += 2 * arctangent2(half, std::sqrt(radius * radius - half * half));
        x[rod.points.first + i] =
            Vec<double>{axis.x + radius * cosine(angle), y, axis.z + radius * sine(angle)};
    }
    for (int i = 0; i < e; ++i) {
        Vec<double>& director = x[rod.directors.first + i];
        const Vec<double>&from = x[rod.points.first + i], &to = x[rod.points.first + i + 1];
        const Vec<double> middle = 0.5 * (from + to), along = (1 / l) * (to - from);
        const double arm =
            length(world.rest[rod.directors.first + i] -
                   0.5 * (world.rest[rod.points.first + i] + world.rest[rod.points.first + i + 1]));
        Vec<double> out = Vec<double>{middle.x - axis.x, 0, middle.z - axis.z};
        out -= dot(out, along) * along;
        director = middle + (arm / length(out)) * out;
    }

    // Finer turns fly apart in longer substeps, 32 links of one with 12; those that are pressed on
    // each other take long to part.
    const int substeps = slinky.pretension > 0 ? 50 : std::max(12, slinky.links / 2);
    SolverOptions options{.sweeps = Sweeps::oneWay,
                          .schedule = {.substeps = substeps, .iterations = 1}};
    options.damping = 0.2;
    Solver<double> solver(world, options);
    for (int frame = 0; frame < 40; ++frame) solver.frame();
    world.start = solver.positions();
}

double turnsBeside(const Slinky& slinky, const Rod& rod, std::span<const Vec<double>> positions) {
    const auto middle = [&](int e) {
        return 0.5 * (positions[rod.points.first + e] + positions[rod.points.first + e + 1]);
    };
    const int edges = rod.directors.last - rod.directors.first;
    int beside = 0;
    for (int e = 0; e + slinky.links < edges; ++e) {
        const Vec<double> way = middle(e + slinky.links) - middle(e),
                          out = positions[rod.directors.first + e] - middle(e),
                          on = cross(out, positions[rod.points.first + e + 1] -
                                              positions[rod.points.first + e]);
        beside += dot(way, on) < 0.5 * slinky.wire.across * length(on) &&
                  std::fabs(dot(way, out)) > 0.5 * slinky.wire.along * length(out);
    }
    return double(beside) / slinky.links;
}

Metric ridingOff(const Slinky& slinky, const Rod& rod, const Band& band) {
    return {.name = "turns beside turns",
            .unit = "",
            .measure = [=](const Snapshot& at) { return turnsBeside(slinky, rod, at.positions); },
            .low = band.low,
            .high = band.high,
            .from = band.from};
}

Look lookOf(const Slinky& slinky, const Rod& rod) {
    return {.object = rod.points,
            .material = Material::brushed,
            .color = {0.46, 0.49, 0.52},
            .section = {.along = slinky.wire.along, .across = slinky.wire.across},
            .directors = rod.directors};
}

}  // namespace plait
