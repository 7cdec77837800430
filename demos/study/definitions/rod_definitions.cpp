// Studies of rods: what is held against closed forms, the mesh apart where it can be.
#include "definitions.h"
#include "demos/study/references/heavy_rod.h"
#include "peers.h"
#include "scenes/parts/hung_helix.h"
#include "scenes/slinky/slinky.h"

#include <plait/constraints/constants.h>
#include <plait/numbers/arctangent.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace plait {
namespace {

std::vector<double> worthless(const Study& study) {
    return std::vector<double>(study.errors.size(), std::numeric_limits<double>::infinity());
}

// Of the scene heavy-rod, whose first vertices are the rod's.
std::vector<double> measureDroop(const Study& study, const Run& run, const Recording& recording,
                                 const Reference&) {
    if (recording.ending != "complete") return worthless(study);
    const int links = static_cast<int>(run.knobs.number("links"));
    const std::vector<Vec<double>>&x = recording.positions.back(), &rest = run.scene.world.rest;
    double whole = 0, wholeRest = 0;
    for (int e = 0; e < links; ++e) {
        whole += length(x[e + 1] - x[e]);
        wholeRest += length(rest[e + 1] - rest[e]);
    }
    const RodTip truth = heavyRodTip(run.knobs.number("weight"), links);
    const double fastest = recording.metrics.back()[3] / 1000;
    return {std::fabs(-x[links].y / truth.drop - 1), std::fabs(whole / wholeRest - 1), fastest};
}

Settings solved(const char* how) { return {{"knob.solve", how}}; }

}  // namespace

Study cantileverStudy() {
    Study study{
        .name = "cantilever",
        .title = "Heavy rod of 64 links, clamped at one end, once it rests: w L³/B = 10",
        .model = {{"scene", "heavy-rod"}},
        .errors = {{"drop", "drop of the tip, off the exact chain of the same links / drop"},
                   {"stretch", "stretch of the whole rod / its length"},
                   {"speed", "fastest vertex after 8 s [m/s]"}},
        .measure = measureDroop};
    study.reference.words =
        "where the moments of all hinges of the same chain balance (heavy_rod.h, to 1e-13)";
    const std::vector<int> steps{1, 2, 5, 10, 20, 50, 100, 200, 400};
    study.curves = {curve("at once, points", solved("points"), steps),
                    curve("at once, frames", solved("frames"), steps),
                    curve("swept, n x 1", solved("sweeps"), steps),
                    curve("swept, n x 4", solved("sweeps"), steps, 4)};
    study.peers = peersOnRod();
    study.omissions = {
        "work: a row that is solved at once counts as one that is swept, and a factorisation not",
        "below 1e-7: what is left of its fall after 8 s, which no solver could lack",
        "frames: joints have 2 tan(psi / 2) for psi, and directors weigh beside the rod: 0.02 % of "
        "the mesh and none of the solver",
        "Jolt: 3b47ec39, its Cosserat rods, 10 to 200 substeps in 1/60 s, measured on one thread "
        "of an AMD EPYC with AVX-512 that was loaded, +-10 %: CPU time; its drop is off the exact "
        "chain whose first link is rigid, as it holds it"};
    return study;
}

namespace {

// m, by which its wire is longer that hangs by its last turn.
double sagOfWire(const Slinky& slinky) {
    const double around = 2 * pi * slinky.radius, turn = std::hypot(around, slinky.wire.across);
    return sagOf({arctangent2(slinky.wire.across, around), slinky.radius},
                 {slinky.wire.bendingSide(), slinky.wire.twisting()}, (slinky.turns - 1) * turn,
                 slinky.wire.density * slinky.wire.area() * -down.y);
}

// m, from the lowest turn to the middle of all, of the scene levitation: its coil comes first, from
// the lowest vertex on, points and then directors.
double middleOf(const Run& run, const Slinky& slinky, const std::vector<Vec<double>>& x) {
    double moment = 0, mass = 0, lowest = 0;
    for (int v = 0; v <= 2 * slinky.turns * slinky.links; ++v) {
        moment += run.scene.world.mass[v] * x[v].y;
        mass += run.scene.world.mass[v];
        if (v < slinky.links) lowest += x[v].y / slinky.links;
    }
    return moment / mass - lowest;
}

std::vector<double> measureFall(const Study& study, const Run& run, const Recording& recording,
                                const Reference&) {
    if (recording.ending != "complete") return worthless(study);
    const Slinky slinky{.links = static_cast<int>(run.knobs.number("links"))};
    const World& world = run.scene.world;
    const double hung = -world.start[0].y - slinky.turns * slinky.wire.across;
    const double fall = middleOf(run, slinky, world.start) - middleOf(run, slinky, world.rest);
    double hangs = 0, moves = 0;
    for (const std::vector<double>& frame : recording.metrics) {
        hangs = std::max(hangs, frame[0]);
        moves = std::max(moves, frame[1] / 100);
    }
    return {std::fabs(hangs / std::sqrt(2 * fall / -down.y) - 1),
            std::fabs(hung / sagOfWire(slinky) - 1), moves};
}

}  // namespace

Study slinkyStudy() {
    Study study{
        .name = "slinky",
        .title = "Slinky of 86 turns that is let go, until its last turn falls",
        // A frame or two after the last turn is told of it.
        .model = {{"scene", "levitation"}, {"seconds", "0.604"}},
        .errors = {{"collapse",
                    "time that the last turn hangs / that from its own shape, less 1: error of the "
                    "solver"},
                   {"extension", "hung, extension / that of its wire, less 1: error of the mesh"},
                   {"moves", "way of the last turn until 0.97 of that time / extension"}},
        .measure = measureFall};
    study.reference.words =
        "a stone that falls from the middle of it, hung, to where its middle lies, closed, since "
        "turns that meet stay together (Calkin); its wire, as a helix whose turns know their angle "
        "(Love)";
    const auto of = [](int links, const std::vector<int>& steps) {
        const std::string number = std::to_string(links);
        return curve(number + " links a turn", {{"knob.links", number}}, steps);
    };
    study.curves = {of(12, {5, 10, 20}), of(24, {5, 10, 20}), of(48, {20, 40})};
    study.omissions = {
        "both errors together: the mesh falls early and the solver late, so that they cancel with "
        "24 links a turn and 10 substeps",
        "24 links a turn in fewer substeps than 5 of 1/240 s, 48 in fewer than 20: turns that meet "
        "are held too late (24 in 2: half the time), and contacts take minutes"};
    return study;
}

}  // namespace plait
