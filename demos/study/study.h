// A study: one model, many methods and settings, one converged reference of the same model. Work
// against error, as validation C has it.
#pragma once

#include "demos/runs/settings.h"
#include "demos/study/references/trajectory.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plait {

// What a run left behind, frame by frame from the first after the start.
struct Recording {
    std::string ending = "complete";  // or what diverged, or why there was nothing to run
    Trajectory positions;
    std::vector<double> energy;  // J: motion, gravity and what soft constraints store
    // Of hard constraints: |C|, over the length at rest where two vertices are joined.
    std::vector<double> violation, violationMean, violationRms;
    std::vector<std::vector<double>> metrics;  // those of the scene
    double startEnergy = 0;                    // J
    long evaluations = 0;                      // constraints swept
    double seconds = 0, cpu = 0;  // of the solve alone: by the clock, and of its thread
    std::string hash;             // of the last state
};

// The converged motion of the same semi-discrete model.
struct Reference {
    Trajectory trajectory;
    int frames = 0;             // for which it is known to have converged
    double selfDifference = 0;  // m, rms over these frames when its step is halved
    double confirmation = 0;    // m, rms to the other integrator
};

// How a reference is found: `solve` halves its step with each `refinement`, 0 and 1; `confirm` is
// another integrator. No `confirm`: the reference solves the very equations of its steps, and is
// exact, or what is compared are statistics, which converge though no trajectory does. No `solve`:
// there is no trajectory, and errors are statistics, or off what `words` tell of. Frames count from
// the first on for as long as both differences of each stay below the part `trust` of the size of
// the scene; where they do not, the comparison ends early.
struct ReferenceRule {
    std::string words, confirmingWords;
    std::function<Trajectory(const Run&, int refinement)> solve;
    std::function<Trajectory(const Run&)> confirm;
    double trust = 1e-4;
};

struct ErrorKind {
    std::string key;    // column of points.csv
    std::string label;  // of its axis, with its unit
};

struct StudyCurve {
    std::string name;
    std::vector<Settings> tasks;  // each on top of the model
    std::string flaw = {};        // why no default may be like it, however small its error
};

// What another engine made of the same work, where it was measured.
struct PeerPoint {
    double cost;                 // ms of one thread for 1/24 s
    double evaluations;          // constraints swept a second; 0 where there is no such count
    std::vector<double> errors;  // by error kind; infinite where it blew up, NaN where not known
};
struct Peer {
    std::string name;
    std::vector<PeerPoint> points;
};

struct Study {
    std::string name, title;
    Settings model;          // scene, quality, frame rate, seconds and knobs that all share
    double size = 1;         // m, of the scene: errors are divided by it
    double energyScale = 0;  // J, 0 where energy is not conserved
    Vec<double> gravity{};   // m/s^2
    std::vector<ErrorKind> errors;
    // By error kind; infinite where the run is worthless.
    std::function<std::vector<double>(const Study&, const Run&, const Recording&, const Reference&)>
        measure;
    ReferenceRule reference = {};
    std::vector<StudyCurve> curves = {};
    std::vector<std::string> omissions = {};  // what is left out, and why
    std::vector<Peer> peers = {};
    // The run, on top of the model, at whose end all others begin; empty: they begin as the scene.
    Settings prelude = {};
};

// Every study there is. Throws UsageError with the nearest name.
const std::vector<Study>& studies();
const Study& studyNamed(const std::string& name);

// The run of a study with these settings on top of its model.
Run studyRun(const Study& study, const Settings& settings);
// All settings of that run: found once, since a scene may take a second to be built, but of one
// that reads files each time.
Settings studySettings(const Study& study, const Settings& settings);

// Position (rms over the frames of the reference, and at the last of them), energy where it is
// conserved, and violation of hard constraints: what most studies measure.
std::vector<ErrorKind> usualErrors(bool conserved, bool hard);
std::vector<double> measureUsual(const Study& study, const Run& run, const Recording& recording,
                                 const Reference& reference);

// Greatest extension of a link: of any frame, as a mean over the second half, and at the end with
// the mean violation there. What has no reference: strain is 0 where links are rigid.
std::vector<ErrorKind> strainErrors();
std::vector<double> measureStrain(const Study& study, const Run& run, const Recording& recording,
                                  const Reference& reference);

}  // namespace plait
