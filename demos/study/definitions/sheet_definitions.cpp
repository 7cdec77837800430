// Studies of the sheet on two pins.
#include "definitions.h"
#include "demos/study/references/soft_motion.h"
#include "peers.h"

namespace plait {
namespace {

constexpr const char* gainsEnergy = "it gains energy on a curved sheet, in every substep";

}  // namespace

// Links give a little. Of rigid ones the motion is chaotic: on 32 x 32 vertices a dent deeper by a
// millionth, 1 nm, is 0.1 mm apart after 0.13 s and 3 mm after 0.23 s, so that there is nothing to
// converge to. Finer meshes fold finer where they are pressed, since nothing resists bending, and
// are chaotic sooner: 64 x 64 get links three times as soft, and are compared until they are.
Study sheetStudy(int n) {
    const std::string side = std::to_string(n);
    Study study{
        .name = "hanging-sheet-" + side,
        .title = "Sheet of " + side + " x " + side + " vertices on two pins, dented by 1 mm, 0.5 s",
        .model = {{"scene", "hanging-sheet"},
                  {"fps", "60"},
                  {"seconds", "0.5"},
                  {"knob.size", side},
                  {"knob.dent", "0.001"},
                  {"knob.solve", "sweeps"},
                  {"knob.compliance", n > 32 ? "0.001" : "0.0003"}},
        .size = 1,
        .energyScale = 0.2 * 9.81,
        .gravity = down,
        .errors = usualErrors(true, false),
        .measure = measureUsual};
    const int steps = 300 * n / 32;
    study.reference = {
        .words = "Runge-Kutta 4, " + std::to_string(120 * steps) + " steps/s",
        .confirmingWords = "BDF2, 96,000 substeps/s of 2 sweeps, in double",
        .solve =
            [=](const Run& run, int refinement) {
                return softMotion(run.scene.world, down, 1 / run.frameRate(), run.frames(),
                                  steps << refinement);
            },
        .confirm =
            [=](const Run&) { return fine(study, with(secondOrder, "iterations", "2"), 1600); },
        .trust = n > 32 ? 1e-6 : 1e-4};
    const Settings oneWay = with(firstOrderFloat, "direction", "one-way");
    // What takes minutes for little: four times the vertices.
    const int last = n > 32 ? 320 : 640, slowest = n > 32 ? 10 : 80;
    study.curves = {curve("first order, n x 1", firstOrder, doubling(5, last)),
                    curve("first order, n x 1, one way, float", oneWay, doubling(5, 640)),
                    curve("first order, n x 4", firstOrder, doubling(5, 80), 4),
                    curve("BDF2, n x 1", secondOrder, doubling(5, 320)),
                    curve("BDF2, n x 1, float", secondOrderFloat, doubling(5, 320)),
                    curve("BDF2, n x 4", secondOrder, doubling(5, last / 4), 4),
                    curve("explicit", by("explicit"), doubling(20, last)),
                    curve("symplectic", by("symplectic"), doubling(20, last)),
                    curve("implicit", by("implicit"), doubling(5, slowest)),
                    curve("block, n x 4", by("block"), doubling(5, slowest), 4),
                    curve("global, n x 1", by("global"), doubling(5, 80)),
                    curve("global, BDF2, n x 1", by("global", "bdf2"), doubling(5, 80)),
                    curve("newton, BDF2", by("newton", "bdf2"), doubling(5, n > 32 ? 5 : 10))};
    study.curves[1].flaw = gainsEnergy;
    study.omissions = {"rigid links: their motion is chaotic from 0.1 s on",
                       "nucleus: it knows no stiffness, only importance",
                       "linearised: it makes every constraint rigid"};
    return study;
}

// The work of peers: flat, 2 s, 60 frames a second; links are rigid, so that every strain is error.
Study sheetStrain(int n) {
    const std::string side = std::to_string(n);
    Study study{
        .name = "hanging-sheet-" + side,
        .title = "Sheet of " + side + " x " + side + " on two pins, 2 s; peers on another machine",
        .model = {{"scene", "hanging-sheet"}, {"fps", "60"}, {"seconds", "2"}, {"knob.size", side}},
        .gravity = down,
        .errors = strainErrors(),
        .measure = measureStrain};
    const auto solved = [](const Settings& settings, const char* how) {
        return with(settings, "knob.solve", how);
    };
    const auto mended = [](const Settings& settings, const char* percent) {
        return with(settings, "knob.mending", percent);
    };
    const Settings strands = solved(firstOrderFloat, "strands"),
                   coarse = mended(solved(firstOrderFloat, "aggregates"), "0"),
                   plain = solved(firstOrderFloat, "sweeps"),
                   second = solved(secondOrderFloat, "sweeps");
    const auto globally = [](const char* integrator) {
        return Settings{{"method", "global"},
                        {"precision", "float"},
                        {"integrator", integrator},
                        {"knob.solve", "sweeps"}};
    };
    std::vector<int> steps{5, 10, 20, 50};
    if (n <= 128) steps.push_back(100);
    study.curves = {curve("strands, tethers, mended, n x 1", strands, {4, 8, 16, 32}),
                    curve("the same to 0.1 %, n x 2", mended(strands, "0.09"), {8, 16, 32}, 2),
                    curve("not mended, n x 2", mended(strands, "0"), {6, 12, 24, 48}, 2),
                    curve("aggregates and tethers, n x 1", coarse, steps),
                    curve("global, n x 1", globally("first"), {1, 2, 5}),
                    curve("global, BDF2, n x 2", globally("bdf2"), {1, 2, 5}, 2),
                    curve("sweeps, n x 1", plain, steps),
                    curve("sweeps, n x 1, one way", with(plain, "direction", "one-way"), steps),
                    curve("sweeps, BDF2, n x 1", second, steps),
                    curve("sweeps, BDF2, n x 4", second, {5, 10, 20}, 4)};
    study.curves[7].flaw = gainsEnergy;
    study.peers = peersOnSheet(n);
    study.omissions = {
        "positions: flat, the sheet has no unique motion",
        "peers: measured on an Intel Xeon with AVX-512 at about 2.9 GHz, one thread, at their own "
        "settings (Bullet 3.24, Jolt 3b47ec39, PositionBasedDynamics d0894bd, Blender 3.4.1); "
        "their time is not comparable to a few per cent"};
    return study;
}

// One implicit step of a sheet that falls and folds: how near methods come to what solves its
// equations. No integrator's error is in it. Twice the vertices along a side get half the step, so
// that links stay as stiff beside what they move, alpha m / h^2: in 2.5 ms of 256 x 256 what is
// pressed buckles, and Newton's iteration was nowhere near a solution after 70 factorisations.
Study sheetStep(int n) {
    const std::string side = std::to_string(n), step = n > 128 ? "1.25" : "2.5";  // ms
    Study study{
        .name = "hanging-sheet-" + side + "-step",
        .title = "Sheet of " + side + " x " + side + " vertices: one step of " + step + " ms",
        .model = {{"scene", "hanging-sheet"},
                  {"fps", n > 128 ? "800" : "400"},
                  {"seconds", n > 128 ? "0.00125" : "0.0025"},
                  {"substeps", "1"},
                  {"integrator", "first"},
                  {"knob.size", side},
                  {"knob.dent", "0.001"},
                  {"knob.solve", "sweeps"},
                  {"knob.compliance", "0.0003"}},
        .size = 1,
        .gravity = down,
        .errors = {{"position", "rms position error after the step / size"}},
        .measure = [](const Study& of, const Run& run, const Recording& recording,
                      const Reference& reference) {
            std::vector<double> errors = measureUsual(of, run, recording, reference);
            errors.resize(1);
            return errors;
        }};
    study.prelude = {{"fps", "60"}, {"seconds", "0.2"}, {"substeps", "400"}, {"iterations", "1"}};
    study.reference.words = "Newton, until forces balance to 1e-10 of the largest";
    study.reference.solve = [=](const Run&, int) { return fine(study, by("newton"), 1); };
    const auto sweeps = [](const std::string& name, const Settings& settings, int last) {
        return sharedOut(name, settings, 1, doubling(1, last));
    };
    constexpr int last = 4096;
    study.curves = {sweeps("palindrome", firstOrder, last),
                    sweeps("palindrome, float", firstOrderFloat, last),
                    sweeps("one way", with(firstOrder, "direction", "one-way"), 2 * last),
                    sweeps("block", by("block"), last / 8),
                    sweeps("implicit, one Newton step", by("implicit"), 1)};
    study.curves[2].flaw = gainsEnergy;
    study.omissions = {"newton: it is the reference",
                       "explicit, symplectic: they solve no equations",
                       "nucleus: it knows no stiffness, only importance",
                       "linearised: it makes every constraint rigid",
                       "the start: after 0.2 s in 400 substeps of 1/60 s"};
    return study;
}

}  // namespace plait
