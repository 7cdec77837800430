// How a world is taken through time.
#pragma once

#include "kernels/kernels.h"
#include "schedule.h"

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace plait {

// One file each in methods/, which says what it is and where it fails.
enum class Method {
    xpbd,
    nucleus,
    explicitEuler,
    symplectic,
    implicit,
    linearised,
    block,
    global,
    newton
};

// The velocity rule: v = (x - x1) / h, or BDF2, v = (3 x - 4 x1 + x2) / 2 h with its own predictor
// (Vellum's second order, V; validation A1). BDF2 wants a converged solve. Midpoint is newton's.
enum class Integrator { first, bdf2, midpoint };

// What a column does with its sets: forward and then exactly backward; forward only; or forward in
// one substep and backward in the next. The last two are baselines that are seen to fail.
enum class Sweeps { palindrome, oneWay, alternating };

struct SolverOptions {
    Method method = Method::xpbd;
    Integrator integrator = Integrator::first;
    Sweeps sweeps = Sweeps::palindrome;
    ScheduleOptions schedule = {.substeps = 10, .iterations = 1};
    // 1 or more: parts of a frame, at whose ends what moves (pins, rows, colliders) is asked where
    // it is; in between it goes straight. More for fast turns (M 2.4) [IN28]. As many as there are
    // substeps are of use.
    int baseSteps = 1;
    // 0: off. Below 1: columns are mixed for eigenvalues of a palindrome up to this (chebyshev.h).
    // For xpbd, palindromes, rigid sets, and at least 3 `iterations` of all of them.
    double chebyshev = 0;
    // Jacobi iterations after the columns (V: 10), contacts once more after; of methods that sweep.
    int smoothing = 0;
    double damping = 0;    // part of the velocity that is lost in 1/24 s, 0 to 1 [IN23]
    double timeScale = 1;  // seconds that pass in a second of film, above 0 [IN25]
    // m/s^2. Above it a vertex that a one-sided constraint pushed falls back to first order under
    // BDF2 [IN20, IN21].
    double maxAcceleration = std::numeric_limits<double>::infinity();
    bool limitAcceleration = false;  // any larger change of velocity is cut to it [IN22]
    int threads = 1;
    KernelChoice kernels = bestKernels();
    // Called over and over within a frame, on the thread that asked for it, far more often than
    // once a second. What it throws ends the frame.
    std::function<void()> interrupt{};
};

// A number is not finite, and `culprit`, a set or a force, was the first to make one; or `culprit`
// is a method that found no solution.
struct Diverged : std::runtime_error {
    Diverged(std::string name, long at,
             const std::string& what = "made a number that is not finite")
        : std::runtime_error(name + " " + what + ", in substep " + std::to_string(at)),
          culprit(std::move(name)),
          substep(at) {}
    std::string culprit;
    long substep;
};

// One evaluation of a set.
struct LogMark {
    long substep;
    int column;
    int set;
};

}  // namespace plait
