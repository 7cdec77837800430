#include "solve.h"

#include "demos/study/references/runge_kutta.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/progress.h"
#include "demos/tools/thread_time.h"
#include "median.h"

#include <plait/constraints/constants.h>
#include <plait/measure/energy.h>
#include <plait/solver.h>

#include <sched.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>

namespace plait {
namespace {

// What the constraints say of a state.
struct Strain {
    double stored = 0;  // J
    double greatest = 0, mean = 0, rms = 0;
};

template <class Real>
Strain strainOf(const Solver<Real>& solver, const World& world) {
    Strain strain;
    double squares = 0, sum = 0;
    long hard = 0;
    Terms<Real> terms;
    for (std::size_t s = 0; s < world.sets.size(); ++s) {
        if (!solver.set(static_cast<int>(s)).terms(solver.state(), false, terms)) continue;
        for (int i = 0; i < terms.size(); ++i) {
            const auto row = static_cast<std::size_t>(i);
            const double alpha = double(terms.compliance(i));
            double c = double(terms.value[row]);
            if (alpha >= slack) continue;
            if (alpha > 0) {
                strain.stored += c * c / (2 * alpha);
                continue;
            }
            if (terms.arity == 2)
                c /= length(world.rest[static_cast<std::size_t>(terms.ids[2 * row])] -
                            world.rest[static_cast<std::size_t>(terms.ids[2 * row + 1])]);
            squares += c * c;
            sum += std::fabs(c);
            strain.greatest = std::max(strain.greatest, std::fabs(c));
            ++hard;
        }
    }
    if (hard > 0) strain.mean = sum / static_cast<double>(hard);
    if (hard > 0) strain.rms = std::sqrt(squares / static_cast<double>(hard));
    return strain;
}

// s of a frame: by the clock, and of the thread alone, which others on its core do not lengthen.
struct Spent {
    double seconds, cpu;
};

template <class Real>
class Trial {
public:
    Trial(const Study& study, const Run& run) : study_(study), run_(run), solver_(make(run)) {}

    Recording record(long mostWork) {
        Recording recording;
        recording.startEnergy = energy(strainOf(solver_, run_.scene.world).stored);
        try {
            for (int f = 1; f <= run_.frames(); ++f) {
                const Spent cost = advance();
                recording.seconds += cost.seconds;
                recording.cpu += cost.cpu;
                note(recording, f);
                frameSolved();
                if (solver_.evaluations() <= mostWork) continue;
                recording.ending = "more work than was allowed";
                break;
            }
            recording.hash = std::to_string(solver_.hash());
        } catch (const Diverged& diverged) {
            recording.ending = diverged.what();
        }
        recording.evaluations = solver_.evaluations();
        return recording;
    }

    // Both times of the recording become medians.
    void repeat(Recording& recording) {
        std::vector<double> times, cpuTimes;
        for (double total = 0; total < 0.05; total += times.back()) {
            solver_.rewind();
            times.push_back(0), cpuTimes.push_back(0);
            for (int f = 1; f <= run_.frames(); ++f) {
                const Spent cost = advance();
                times.back() += cost.seconds;
                cpuTimes.back() += cost.cpu;
            }
        }
        recording.seconds = median(times);
        recording.cpu = median(cpuTimes);
    }

private:
    static Solver<Real> make(const Run& run) {
        SolverOptions options = run.scene.options;
        options.threads = 1;
        options.interrupt = stopIfInterrupted;
        return {run.scene.world, options};
    }

    Spent advance() {
        using Clock = std::chrono::steady_clock;
        const double cpu = threadTime();
        const auto start = Clock::now();
        solver_.frame();
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        return {seconds, threadTime() - cpu};
    }

    double energy(double stored) const {
        return kineticEnergy(run_.scene.world.mass, solver_.velocities()) +
               gravitationalEnergy(run_.scene.world.mass, solver_.positions(), study_.gravity) +
               stored;
    }

    void note(Recording& recording, int frame) const {
        recording.positions.push_back(solver_.positions());
        const Strain strain = strainOf(solver_, run_.scene.world);
        recording.energy.push_back(energy(strain.stored));
        recording.violation.push_back(strain.greatest);
        recording.violationMean.push_back(strain.mean);
        recording.violationRms.push_back(strain.rms);
        const std::vector<Vec<double>> velocities = solver_.velocities();
        const Snapshot snapshot{.positions = recording.positions.back(),
                                .velocities = velocities,
                                .time = solver_.time(),
                                .frame = frame,
                                .failures = solver_.failures(),
                                .cuts = solver_.state().cuts};
        recording.metrics.emplace_back();
        for (const Metric& metric : run_.scene.metrics)
            recording.metrics.back().push_back(metric.measure(snapshot));
    }

    const Study& study_;
    const Run& run_;
    Solver<Real> solver_;
};

template <class Real>
Recording solveIn(const Study& study, const Run& run, bool timed, long mostWork) {
    Trial<Real> trial(study, run);
    Recording recording = trial.record(mostWork);
    if (timed && recording.ending == "complete" && recording.seconds < 0.5) trial.repeat(recording);
    return recording;
}

// Where the prelude of a study ends; solved once.
const Motions& endOfPrelude(const Study& study) {
    static std::mutex one;
    static std::map<std::string, Motions> kept;
    const std::lock_guard lock(one);
    Motions& end = kept[study.name];
    if (end.x.empty()) {
        const Run run = studyRun(study, study.prelude);
        SolverOptions options = run.scene.options;
        options.interrupt = stopIfInterrupted;
        Solver<double> solver(run.scene.world, options);
        for (int f = 0; f < run.frames(); ++f) {
            solver.frame();
            frameSolved();
        }
        end = {solver.positions(), solver.velocities()};
    }
    return end;
}

}  // namespace

Recording solve(const Study& study, const Run& run, bool timed, long mostWork) {
    if (!study.prelude.empty()) {
        Study later = study;
        Run begun = run;
        begun.scene.world.start = endOfPrelude(study).x;
        begun.scene.world.velocity = endOfPrelude(study).v;
        later.prelude.clear();
        return solve(later, begun, timed, mostWork);
    }
    try {
        return run.precision == Precision::single ? solveIn<float>(study, run, timed, mostWork)
                                                  : solveIn<double>(study, run, timed, mostWork);
    } catch (const std::invalid_argument& error) {
        Recording none;
        none.ending = std::string("omitted: ") + error.what();
        return none;
    }
}

void pinThread(int k) {
    cpu_set_t usable, one;
    if (sched_getaffinity(0, sizeof usable, &usable) != 0) return;
    static const cpu_set_t all = usable;  // before any thread was pinned
    int left = k % std::max(1, CPU_COUNT(&all));
    for (std::size_t core = 0; core < CPU_SETSIZE; ++core) {
        if (!CPU_ISSET(core, &all) || left-- > 0) continue;
        CPU_ZERO(&one);
        CPU_SET(core, &one);
        sched_setaffinity(0, sizeof one, &one);
        return;
    }
}

int movingVertices(const World& world) {
    return static_cast<int>(std::count(world.pinned.begin(), world.pinned.end(), 0));
}

}  // namespace plait
