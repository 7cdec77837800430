// Studies of strips and flags.
#include "definitions.h"
#include "demos/study/references/soft_motion.h"

namespace plait {

Study cantileverStripStudy() {
    Study study{.name = "cantilever-strip",
                .title = "Strip of cloth clamped at one end, let go from horizontal, 0.5 s",
                .model = {{"scene", "cantilever"}, {"seconds", "0.5"}},
                .size = 0.3,
                .energyScale = 0.2 * 0.3 * 0.06 * 9.81 * 0.3,
                .gravity = down,
                .errors = usualErrors(true, false),
                .measure = measureUsual};
    study.reference = {
        .words = "Runge-Kutta 4, 76,800 steps/s",
        .confirmingWords = "Newton, midpoint, 28,800 steps/s",
        .solve =
            [=](const Run& run, int refinement) {
                return softMotion(run.scene.world, down, 1 / run.frameRate(), run.frames(),
                                  1600 << refinement);
            },
        .confirm = [=](const Run&) { return fine(study, by("newton", "midpoint"), 1200); }};
    const std::vector<int> steps = doubling(5, 320);
    study.curves = {curve("first order, n x 1", firstOrder, steps),
                    curve("first order, n x 4", firstOrder, steps, 4),
                    curve("BDF2, n x 1", secondOrder, steps),
                    curve("BDF2, n x 4", secondOrder, steps, 4),
                    curve("BDF2, n x 16", secondOrder, doubling(5, 160), 16),
                    curve("BDF2, n x 4, float", secondOrderFloat, steps, 4),
                    curve("explicit", by("explicit"), doubling(5, 1280)),
                    curve("symplectic", by("symplectic"), doubling(5, 1280)),
                    curve("implicit", by("implicit"), steps),
                    curve("block, n x 4", by("block"), doubling(5, 80), 4),
                    curve("newton, midpoint", by("newton", "midpoint"), doubling(5, 80))};
    study.omissions = {"nucleus: it knows no stiffness, only importance",
                       "linearised: it makes every constraint rigid"};
    return study;
}

Study stripStudy() {
    Study study{.name = "strip-in-wind",
                .title = "Strip in wind from hanging straight down, 1 s",
                .model = {{"scene", "strip-in-wind"}, {"seconds", "1"}},
                .size = 1,
                .gravity = down,
                .errors = usualErrors(false, false),
                .measure = measureUsual};
    study.reference = {
        .words = "BDF2, 768,000 substeps/s of 4 sweeps, in double",
        .confirmingWords = "first order, 768,000 substeps/s of 4 sweeps, in double",
        .solve =
            [=](const Run&, int refinement) {
                return fine(study, with(secondOrder, "iterations", "4"), 16000 << refinement);
            },
        .confirm =
            [=](const Run&) { return fine(study, with(firstOrder, "iterations", "4"), 32000); }};
    const std::vector<int> steps = doubling(5, 160);
    study.curves = {curve("first order, n x 1", firstOrder, steps),
                    curve("first order, n x 4", firstOrder, doubling(5, 80), 4),
                    curve("BDF2, n x 1", secondOrder, steps),
                    curve("BDF2, n x 1, float", secondOrderFloat, steps),
                    curve("BDF2, n x 2", secondOrder, steps, 2),
                    curve("BDF2, n x 8", secondOrder, doubling(5, 80), 8),
                    curve("explicit", by("explicit"), doubling(5, 320)),
                    curve("symplectic", by("symplectic"), doubling(5, 320)),
                    curve("implicit", by("implicit"), steps),
                    curve("block, n x 4", by("block"), doubling(5, 80), 4),
                    curve("newton, BDF2", by("newton", "bdf2"), doubling(5, 40))};
    study.omissions = {"energy: the wind does work", "newton, midpoint: with air its order is 1",
                       "nucleus: it knows no stiffness, only importance",
                       "linearised: it makes every constraint rigid"};
    return study;
}

Study flagStudy() {
    Study study{.name = "flag",
                .title = "Flag at draft, 4 s: statistics only",
                .model = {{"scene", "flag"}, {"quality", "draft"}, {"seconds", "4"}},
                .gravity = down,
                .errors = strainErrors(),
                .measure = measureStrain};
    study.curves = {curve("first order, n x 1, float", firstOrderFloat, doubling(5, 160)),
                    curve("first order, n x 1", firstOrder, doubling(5, 160)),
                    curve("first order, n x 4, float", firstOrderFloat, doubling(5, 40), 4),
                    curve("BDF2, n x 4, float", secondOrderFloat, doubling(5, 40), 4)};
    study.omissions = {"positions: its motion is chaotic (validation C4)"};
    return study;
}

}  // namespace plait
