// The studies, one function each: a model, its reference, and the curves that are drawn. Points and
// chains here, rods and cloth in the other files of definitions.
#include "definitions.h"

#include "demos/study/references/rigid_chain.h"
#include "demos/tools/progress.h"
#include "demos/tools/words.h"

#include <plait/numbers/elementary.h>

namespace plait {
namespace {

// Where the unit spring is: cos t.
Trajectory cosines(const Run& run) {
    Trajectory trajectory;
    for (int f = 1; f <= run.frames(); ++f) {
        trajectory.push_back({Vec<double>{cosine(f / run.frameRate()), 0, 0}});
        frameSolved();
    }
    return trajectory;
}

Study unitSpring() {
    Study study{.name = "unit-spring",
                .title = "A unit spring for 20 s: x″ = −x",
                .model = {{"scene", "unit-spring"}, {"fps", "1/2"}, {"seconds", "20"}},
                .size = 1,
                .energyScale = 0.5,
                .errors = usualErrors(true, false),
                .measure = measureUsual};
    study.errors[2].label = "greatest drift of energy / energy";
    study.reference = {
        .words = "closed form, cos t",
        .confirmingWords = "BDF2 with 65,536 substeps in 2 s, in double",
        .solve = [](const Run& run, int) { return cosines(run); },
        .confirm =
            [=](const Run&) { return fine(study, with(secondOrder, "iterations", "1"), 65536); }};
    study.curves = {curve("first order", firstOrder, doubling(1, 1 << 16)),
                    curve("first order, float", firstOrderFloat, doubling(64, 1 << 19)),
                    curve("BDF2", secondOrder, doubling(1, 1 << 14)),
                    curve("BDF2, float", secondOrderFloat, doubling(1, 1 << 16)),
                    curve("explicit", by("explicit"), doubling(1, 1 << 14)),
                    curve("symplectic", by("symplectic"), doubling(1, 1 << 14)),
                    curve("implicit", by("implicit"), doubling(1, 1 << 14)),
                    curve("block", by("block"), doubling(1, 1 << 14)),
                    curve("newton, midpoint", by("newton", "midpoint"), doubling(1, 1 << 13))};
    study.omissions = {"nucleus: it knows no stiffness, only importance",
                       "linearised: it makes every constraint rigid"};
    return study;
}

Study pendulumStudy() {
    Study study{.name = "pendulum",
                .title = "Pendulum let go at 90 degrees, 10 s",
                .model = {{"scene", "pendulum"}, {"fps", "12"}, {"seconds", "10"}},
                .size = 1,
                .energyScale = 9.81,
                .gravity = down,
                .errors = usualErrors(true, true),
                .measure = measureUsual};
    study.reference = {.words = "Runge-Kutta 4 with multipliers, 24,000 steps/s",
                       .confirmingWords = "Runge-Kutta 4 of the angle, 6,000 steps/s",
                       .solve =
                           [](const Run& run, int refinement) {
                               return rigidChain(run.scene.world, down, 1 / run.frameRate(),
                                                 run.frames(), 1000 << refinement);
                           },
                       .confirm =
                           [](const Run& run) {
                               return pendulumByAngle(run.scene.world, 9.81, 1 / run.frameRate(),
                                                      run.frames(), 500);
                           }};
    const std::vector<int> steps{2, 5, 10, 20, 40, 80, 160, 320, 640, 1280, 2560, 5120, 10240};
    const std::vector<int> fewer(steps.begin(), steps.end() - 4);
    study.curves = {curve("first order", firstOrder, steps),
                    curve("first order, float", firstOrderFloat, steps),
                    curve("BDF2", secondOrder, steps),
                    curve("BDF2, float", secondOrderFloat, steps),
                    curve("linearised", by("linearised"), fewer),
                    curve("block, n x 4", by("block"), fewer, 4),
                    curve("newton, midpoint", by("newton", "midpoint"), fewer)};
    study.omissions = {"iterations: one projects a single link exactly",
                       "nucleus: with rigid links it is first order",
                       "explicit, symplectic, implicit: a rigid link has no force"};
    return study;
}

Study chainStudy() {
    Study study{
        .name = "chain",
        .title = "Chain of 20 rigid links let go from horizontal, 0.5 s",
        .model = {{"scene", "chain"}, {"fps", "60"}, {"seconds", "0.5"}, {"knob.tip", "whole"}},
        .size = 1,
        .energyScale = 9.81 / 2,
        .gravity = down,
        .errors = usualErrors(true, true),
        .measure = measureUsual};
    study.reference = {
        .words = "Runge-Kutta 4 with multipliers, 60,000 steps/s",
        .confirmingWords = "BDF2 with the direct solve, 1,920,000 substeps/s, in double",
        .solve =
            [](const Run& run, int refinement) {
                return rigidChain(run.scene.world, down, 1 / run.frameRate(), run.frames(),
                                  500 << refinement);
            },
        .confirm =
            [=](const Run&) { return fine(study, with(secondOrder, "iterations", "2"), 16000); }};
    const auto swept = [](const Settings& settings, const std::string& direction) {
        return with(with(settings, "knob.solve", "sweeps"), "direction", direction);
    };
    const std::vector<int> work{4, 16, 64, 256, 1024};
    study.curves = {
        sharedOut("1 x n, one way", swept(firstOrder, "one-way"), 1, work),
        sharedOut("4 x n/4, one way", swept(firstOrder, "one-way"), 4, work),
        sharedOut("16 x n/16, one way", swept(firstOrder, "one-way"), 16, work),
        sharedOut("n x 1, one way", swept(firstOrder, "one-way"), 0, work),
        sharedOut("BDF2, 1 x n, one way", swept(secondOrder, "one-way"), 1, work),
        sharedOut("BDF2, n x 1, one way", swept(secondOrder, "one-way"), 0, work),
        sharedOut("BDF2, n x 1, one way, float", swept(secondOrderFloat, "one-way"), 0, work),
        sharedOut("BDF2, n x 1, palindrome", swept(secondOrder, "palindrome"), 0, work),
        curve("direct, first order", firstOrder, doubling(1, 1024)),
        curve("direct, BDF2", secondOrder, doubling(1, 1024)),
        curve("direct, BDF2, float", secondOrderFloat, doubling(1, 1024)),
        curve("block, n x 4", by("block"), doubling(1, 256), 4),
        curve("newton, midpoint", by("newton", "midpoint"), doubling(1, 64))};
    study.omissions = {"nucleus: with rigid links it is first order",
                       "explicit, symplectic, implicit: a rigid link has no force"};
    return study;
}

}  // namespace

const std::vector<Study>& studies() {
    static const std::vector<Study> all{unitSpring(),      pendulumStudy(), chainStudy(),
                                        cantileverStudy(), slinkyStudy(),   cantileverStripStudy(),
                                        stripStudy(),      sheetStudy(32),  sheetStudy(64),
                                        sheetStep(128),    sheetStep(256),  sheetStrain(128),
                                        sheetStrain(256),  flagStudy(),     sphereStudy(),
                                        dressStudy(),      pileStudy()};
    return all;
}

const Study& studyNamed(const std::string& name) {
    std::vector<std::string> names;
    for (const Study& study : studies()) names.push_back(study.name);
    return studies()[static_cast<std::size_t>(parseChoice("study", name, names))];
}

}  // namespace plait
