// Studies of cloth.
#include "study/definitions.h"

namespace plait {

Study cantileverStudy() {
    Study study{.name = "cantilever",
                .title = "Strip of cloth clamped at one end, let go from horizontal, 0.5 s",
                .model = {{"scene", "cantilever"}, {"seconds", "0.5"}},
                .size = 0.3,
                .energyScale = 0.2 * 0.3 * 0.06 * 9.81 * 0.3,
                .gravity = down,
                .errors = usualErrors(true, false),
                .measure = measureUsual};
    study.reference = {
        .words = "Newton, midpoint, 57,600 steps/s",
        .confirmingWords = "Newton, BDF2, 57,600 steps/s",
        .solve =
            [=](const Run&, int refinement) {
                return fine(study, by("newton", "midpoint"), 1200 << refinement);
            },
        .confirm = [=](const Run&) { return fine(study, by("newton", "bdf2"), 2400); }};
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
                .errors = usualErrors(false, true),
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
    const std::vector<int> steps = doubling(5, 1280);
    study.curves = {curve("first order, n x 1", firstOrder, steps),
                    curve("first order, n x 2", firstOrder, steps, 2),
                    curve("first order, n x 2, float", firstOrderFloat, steps, 2),
                    curve("first order, n x 8", firstOrder, doubling(5, 320), 8),
                    curve("BDF2, n x 2", secondOrder, steps, 2),
                    curve("BDF2, n x 8", secondOrder, doubling(5, 320), 8)};
    study.omissions = {"energy: the wind does work", "newton: with air its order is 1",
                       "explicit, symplectic, implicit: a rigid link has no force"};
    return study;
}

Study sheetStudy(int n) {
    const std::string side = std::to_string(n);
    Study study{
        .name = "hanging-sheet-" + side,
        .title = "Sheet of " + side + " x " + side + " vertices on two pins, dented by 1 mm, 0.5 s",
        .model = {{"scene", "hanging-sheet"},
                  {"fps", "60"},
                  {"seconds", "0.5"},
                  {"knob.size", side},
                  {"knob.dent", "0.001"}},
        .size = 1,
        .energyScale = 0.2 * 9.81,
        .gravity = down,
        .errors = usualErrors(true, true),
        .measure = measureUsual};
    study.reference = {
        .words = "BDF2, 48,000 substeps/s of 4 sweeps, in double",
        .confirmingWords = "first order, 96,000 substeps/s of 2 sweeps, in double",
        .solve =
            [=](const Run&, int refinement) {
                return fine(study, with(secondOrder, "iterations", "4"), 400 << refinement);
            },
        .confirm =
            [=](const Run&) { return fine(study, with(firstOrder, "iterations", "2"), 1600); }};
    const std::vector<int> steps = doubling(5, 160);
    const Settings oneWay = with(firstOrderFloat, "direction", "one-way");
    study.curves = {curve("first order, n x 1", firstOrder, steps),
                    curve("first order, n x 1, float", firstOrderFloat, steps),
                    curve("first order, n x 1, one way, float", oneWay, steps),
                    curve("first order, n x 4", firstOrder, doubling(5, 80), 4),
                    curve("BDF2, n x 1", secondOrder, steps),
                    curve("BDF2, n x 4", secondOrder, steps, 4)};
    study.omissions = {"newton: a flat sheet of rigid links has singular equations",
                       "explicit, symplectic, implicit: a rigid link has no force"};
    return study;
}

// The work of peers: flat, 2 s, 60 frames a second; links are rigid, so that every strain is error.
Study sheetStrain(int n) {
    const std::string side = std::to_string(n);
    Study study{
        .name = "hanging-sheet-" + side,
        .title = "Strain of a sheet of " + side + " x " + side + " vertices on two pins, 2 s",
        .model = {{"scene", "hanging-sheet"}, {"fps", "60"}, {"seconds", "2"}, {"knob.size", side}},
        .gravity = down,
        .errors = strainErrors(),
        .measure = measureStrain};
    const Settings oneWay = with(firstOrderFloat, "direction", "one-way");
    study.curves = {curve("palindrome, n x 1", firstOrderFloat, {5, 10, 20, 50, 100}),
                    curve("one way, n x 1", oneWay, {5, 10, 20, 50, 100}),
                    sharedOut("one way, 1 x n", oneWay, 1, {10, 20, 50}),
                    curve("BDF2, palindrome, n x 4", secondOrderFloat, {5, 10, 20}, 4)};
    study.omissions = {"positions: flat, the sheet has no unique motion"};
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
