// Studies: tables and medians of made-up runs, tasks that are not done twice, references that agree
// with each other, and the tables of validation B.
#include "demos/study/median.h"
#include "demos/study/references/reference.h"
#include "demos/study/references/rigid_chain.h"
#include "demos/study/solve.h"
#include "demos/study/tables.h"
#include "demos/study/tasks.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "program.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <cmath>

using namespace plait;
using namespace plait::test;

namespace {

StudyPoint made(const std::string& curve, double work, double seconds, double error) {
    return {.curve = curve,
            .settings = {{"substeps", "1"}},
            .ending = "complete",
            .runs = 1,
            .seconds = seconds,
            .cpu = seconds,
            .least = seconds,
            .evaluations = work,
            .errors = {error}};
}

const Study twoCurves{.name = "made",
                      .title = "made",
                      .model = {},
                      .errors = {{"position", "error"}},
                      .measure = measureUsual,
                      .curves = {{"a", {}}, {"b", {}}}};

// The rms position error of the chain with these settings on top of the study's model.
double chainError(const Reference& reference, Settings settings) {
    const Study& study = studyNamed("chain");
    settings.insert(settings.end(), {{"precision", "double"}});
    const Run run = studyRun(study, settings);
    return measureUsual(study, run, solve(study, run, false), reference)[0];
}

Settings equalWork(const std::string& integrator, int substeps, int iterations) {
    return {{"integrator", integrator},
            {"direction", "one-way"},
            {"knob.solve", "sweeps"},
            {"substeps", std::to_string(substeps)},
            {"iterations", std::to_string(iterations)}};
}

}  // namespace

TEST_CASE("medians", "[study]") {
    CHECK(median({3, 1, 2}) == 2);
    CHECK(median({4, 1, 3, 2}) == 2.5);
    CHECK(median({7}) == 7);
    CHECK_THROWS_AS(median({}), std::invalid_argument);
}

TEST_CASE("the default's work is held against the least that does as well", "[study]") {
    std::vector<StudyPoint> points{made("a", 100, 1, 0.1), made("a", 200, 2, 0.01),
                                   made("b", 150, 3, 0.02), made("b", 10, 1, 3)};
    points[1].isDefault = true;
    CHECK(defaultExcess(twoCurves, points) == 1);
    points[1].isDefault = false;
    points.push_back(made("", 300, 1, 0.02));
    points.back().isDefault = true;
    CHECK(defaultExcess(twoCurves, points) == 2);  // b reaches 0.02 with 150
    points.push_back(made("b", 1, 1, 0.001));
    points.back().ending = "diverged";
    CHECK(defaultExcess(twoCurves, points) == 2);  // what diverged reaches nothing
    points[4].errors = {0.05};
    // Between 100 and 200 a falls as the power -log2(10) of its work.
    CHECK(std::fabs(defaultExcess(twoCurves, points) - 3 / std::exp2(std::log10(2))) < 1e-12);
    Study flawed = twoCurves;
    flawed.curves[0].flaw = "it may burst";
    CHECK(defaultExcess(flawed, points) == 2);
    const auto lines = findings(flawed, points);
    REQUIRE(lines.size() == 1);
    CHECK(contains(lines[0], "a reaches the default's error with 0.41 of its work, but it may"));
    points[4].errors = {3};  // the default failed
    CHECK(defaultExcess(flawed, points) == 0);
    CHECK(findings(flawed, points).empty());
}

TEST_CASE("a curve that more work makes worse is a finding", "[study]") {
    CHECK(findings(twoCurves, {made("a", 1, 1, 0.1), made("a", 2, 1, 0.01), made("b", 3, 1, 0.5)})
              .empty());
    const auto lines =
        findings(twoCurves, {made("a", 1, 1, 0.01), made("a", 2, 1, 0.1), made("b", 3, 1, 0.5)});
    REQUIRE(lines.size() == 1);
    CHECK(contains(lines[0], "a: more work is worse"));
}

TEST_CASE("tables of equal cost and equal error", "[study]") {
    // 1 s: ms a frame = 1000 seconds / 24.
    const std::vector<StudyPoint> points{made("a", 100, 0.024, 0.05), made("a", 1000, 0.24, 0.002),
                                         made("b", 50, 0.072, 0.0005), made("b", 1, 1e-6, 3)};
    const Table cost = equalCost(twoCurves, points, 1);
    CHECK(cost == Table{{"least error within", "1 ms/frame", "4 ms/frame", "16 ms/frame"},
                        {"a", "0.05", "0.05", "0.002"},
                        {"b", "-", "0.0005", "0.0005"}});
    const Table error = equalError(twoCurves, points, 1);
    CHECK(error == Table{{"ms/frame, constraints/s to reach", "0.1", "0.01", "0.001"},
                         {"a", "1, 1e+02", "10, 1e+03", "-"},
                         {"b", "3, 50", "3, 50", "3, 50"}});
}

TEST_CASE("rows go to text and back", "[study]") {
    const Study& study = studyNamed("chain");
    const std::size_t kinds = study.errors.size();
    StudyRow row{.settings = settingsOf(studyRun(study, {{"substeps", "7"}})),
                 .repeat = 3,
                 .ending = "complete",
                 .evaluations = 123456789012,
                 .seconds = 0.1 + 0.2,
                 .cpu = 1 / 3.0,
                 .errors = std::vector<double>(kinds, 1e-17 / 3),
                 .hash = "18446744073709551615"};
    row.errors[1] = std::numeric_limits<double>::infinity();
    const std::string csv = csvOf(study, {row, row});
    CHECK(rowsFrom(study, csv, "csv") == std::vector<StudyRow>{row, row});
    CHECK_THROWS_AS(rowsFrom(study, csv.substr(0, csv.size() - 30), "csv"), FileError);
    CHECK_THROWS_AS(rowsFrom(studyNamed("pendulum"), csv, "csv"), FileError);
}

TEST_CASE("a task is one word and comes back the same", "[study]") {
    const std::string word = "integrator=bdf2,substeps=16,repeat=2";
    CHECK(wordOf(taskFrom(word)) == word);
    CHECK_THROWS_AS(taskFrom("substeps"), UsageError);
    CHECK_THROWS_AS(taskFrom("repeat=0"), UsageError);
}

TEST_CASE("methods take turns, and no settings come twice in a round", "[study]") {
    const Study& study = studyNamed("chain");
    const std::vector<StudyTask> once = tasksOf(study, 1), thrice = tasksOf(study, 3);
    REQUIRE(thrice.size() == 3 * once.size());
    for (std::size_t i = 0; i < thrice.size(); ++i) {
        CHECK(thrice[i].settings == once[i % once.size()].settings);
        CHECK(thrice[i].repeat == static_cast<int>(i / once.size()) + 1);
    }
    std::vector<Settings> settings;
    for (const StudyTask& task : once)
        settings.push_back(settingsOf(studyRun(study, task.settings)));
    std::sort(settings.begin(), settings.end());
    CHECK(std::adjacent_find(settings.begin(), settings.end()) == settings.end());
}

TEST_CASE("a finished task is not run again, one of other settings is", "[study]") {
    const TemporaryFolder folder;
    const Study& study = studyNamed("unit-spring");
    const StudyFolder kept(study, folder / "study");
    const Reference reference{.trajectory = study.reference.solve(studyRun(study, {}), 0),
                              .frames = 10};
    std::vector<StudyTask> tasks{{{{"substeps", "2"}}, 1}, {{{"substeps", "2"}}, 2}};
    CHECK(executeAll(study, tasks, reference, kept, 1, true) == 2);
    const std::string before = readWhole(kept.rowPath(tasks[0]));
    tasks.push_back({{{"substeps", "4"}}, 1});
    CHECK(executeAll(study, tasks, reference, kept, 2, true) == 1);
    CHECK(readWhole(kept.rowPath(tasks[0])) == before);  // times would differ
    CHECK(kept.rows().size() == 3);
    writeWhole(kept.rowPath(tasks[0]), readWhole(kept.rowPath(tasks[2])));
    CHECK(executeAll(study, tasks, reference, kept, 1, true) == 1);
    writeWhole(kept.rowPath(tasks[0]), "half");
    CHECK(executeAll(study, tasks, reference, kept, 1, true) == 1);
    kept.clear(wordOf(tasks[1]));
    CHECK(kept.rows().size() == 2);
    CHECK_FALSE(kept.done(tasks[1]));
    writeWhole(kept.path() / "rows" / "notes", "not ours");
    kept.clear("");
    CHECK(kept.rows().empty());
    CHECK(std::filesystem::exists(kept.path() / "rows" / "notes"));
}

TEST_CASE("a reference is kept, and found again for another model", "[study]") {
    const TemporaryFolder folder;
    Study study = studyNamed("unit-spring");
    study.reference.confirm = [&](const Run& run) { return study.reference.solve(run, 0); };
    const auto path = folder / "reference.csv";
    const Reference first = keptReference(study, path);
    CHECK(first.frames == 10);
    const auto solve = study.reference.solve;
    int solved = 0;
    study.reference.solve = [&](const Run& run, int r) { return ++solved, solve(run, r); };
    const Reference second = keptReference(study, path);
    CHECK(solved == 0);
    CHECK(second.trajectory.size() == first.trajectory.size());
    CHECK(rmsDistance(second.trajectory, first.trajectory, 10, 1) == 0);
    study.model = {{"scene", "unit-spring"}, {"fps", "1/2"}, {"seconds", "10"}};
    CHECK(keptReference(study, path).frames == 5);
    CHECK(solved > 0);
}

TEST_CASE("a comparison ends where the reference stops converging", "[study]") {
    Study study = studyNamed("unit-spring");
    study.reference.confirm = [&](const Run& run) {
        Trajectory other = study.reference.solve(run, 0);
        for (std::size_t f = 6; f < other.size(); ++f) other[f][0].x += 1e-3;
        return other;
    };
    const Reference reference = findReference(study);
    CHECK(reference.frames == 6);
    CHECK(contains(describe(study, reference), "NOT converged after 12 of 20 s"));
}

TEST_CASE("two ways to a pendulum agree", "[study]") {
    const Study& study = studyNamed("pendulum");
    Run run = studyRun(study, {});
    const Trajectory a = rigidChain(run.scene.world, {0, -9.81, 0}, 1.0 / 12, 24, 500);
    const Trajectory b = pendulumByAngle(run.scene.world, 9.81, 1.0 / 12, 24, 500);
    CHECK(
        report("pendulum, multipliers against the angle, 2 s, m", rmsDistance(a, b, 24, 1), 1e-11));
}

// Validation B, "Equal work": rms position error over frames of 1/60 s of a chain of 20 links let
// go from horizontal, one-way sweeps.
TEST_CASE("equal work", "[study]") {
    const Study& study = studyNamed("chain");
    const Run run = studyRun(study, {});
    Reference reference;
    reference.frames = run.frames();
    const auto exact = [&](int steps) {
        return rigidChain(run.scene.world, {0, -9.81, 0}, 1.0 / 60, run.frames(), steps);
    };
    reference.trajectory = exact(200);
    REQUIRE(report("chain, the reference halved, m",
                   rmsDistance(reference.trajectory, exact(100), run.frames(), 20), 5e-11));
    struct Row {
        const char* integrator;
        int substeps, iterations;
        double table;
    };
    // The last column of the table is rounded: .00013 and .00001 are one or two digits.
    const Row rows[] = {
        {"first", 1, 16, .0536},   {"first", 4, 4, .0195},    {"first", 16, 1, .00616},
        {"first", 1, 64, .0238},   {"first", 4, 16, .00927},  {"first", 16, 4, .00326},
        {"first", 64, 1, .00100},  {"first", 1, 256, .0180},  {"first", 4, 64, .00718},
        {"first", 16, 16, .00268}, {"first", 256, 1, .00023}, {"bdf2", 1, 16, .0296},
        {"bdf2", 16, 1, .00213},   {"bdf2", 1, 64, .0116},    {"bdf2", 64, 1, .00013},
        {"bdf2", 1, 256, .0079}};
    for (const Row& row : rows) {
        const double error =
            chainError(reference, equalWork(row.integrator, row.substeps, row.iterations));
        const std::string name = std::string(row.integrator) + ", " + std::to_string(row.substeps) +
                                 " x " + std::to_string(row.iterations);
        note("chain, " + name + ": error", error);
        CHECK(report("chain, " + name + ": ratio to the table, less 1",
                     std::fabs(error / row.table - 1), 0.2));
    }
    // The direct solve, evaluated as often as there are sweeps in the last column.
    for (const auto& [substeps, table] : {std::pair{16, .00213}, {64, .00013}, {256, .00001}})
        CHECK(report("chain, direct, BDF2, " + std::to_string(substeps) + " x 1: error",
                     chainError(reference, {{"integrator", "bdf2"},
                                            {"substeps", std::to_string(substeps)},
                                            {"iterations", "1"}}),
                     table));
}

TEST_CASE("study, from outside", "[study][program]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "spring").string();
    const auto study = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "study");
        return plait::test::plait(folder, words);
    };
    CHECK(contains(study({}).out, "pendulum"));
    CHECK(study({"pendulm"}).status == 2);
    CHECK(contains(study({"certifcate"}).err, "nearest: certificate"));
    CHECK(study({"certificate", "--repeats", "2"}).status == 2);
    CHECK(study({"pendulum", "--collect", "--force", "--out", out}).status == 2);
    CHECK(study({"pendulum", "--task", "substep=3", "--out", out}).status == 2);
    const Outcome tasks =
        study({"unit-spring", "--out", out, "--tasks", (folder / "tasks").string()});
    REQUIRE(tasks.status == 0);
    const std::string lines = contents(folder / "tasks");
    CHECK(std::count(lines.begin(), lines.end(), '\n') > 100);
    const std::string word = "integrator=first,precision=double,substeps=64,iterations=1,repeat=1";
    CHECK(contains(lines, "study unit-spring --out " + out + " --task " + word + "\n"));
    const Outcome once = study({"unit-spring", "--out", out, "--task", word});
    REQUIRE(once.status == 0);
    CHECK(study({"unit-spring", "--out", out, "--task", word}).out == once.out);
    const Outcome solved =
        study({"unit-spring", "--out", (folder / "other").string(), "--collect"});
    CHECK(contains(solved.err, "reference of unit-spring: 30/30 frames"));
    const Outcome again = study({"unit-spring", "--out", out, "--task", word, "--force"});
    CHECK(again.status == 0);
    CHECK(again.out != once.out);  // times differ
    const Outcome report = study({"unit-spring", "--out", out, "--collect"});
    INFO(report.out << report.err);
    REQUIRE(report.status == 0);
    CHECK(contains(report.out, "reference: closed form"));
    for (const char* file : {"points.csv", "chart.svg", "chart.png", "chart-work.svg",
                             "chart-energy.svg", "index.html"})
        CHECK(std::filesystem::exists(std::filesystem::path(out) / file));
    CHECK(contents(std::filesystem::path(out) / "points.csv") == again.out);
    CHECK(contains(contents(std::filesystem::path(out) / "index.html"),
                   "build/plait study unit-spring --out " + out + " --collect"));
}

// A flat sheet half a millimetre above the ball's top touches it with the four vertices that are
// next to its middle, of 32 x 32: the others of them are 2 mm further from it and more.
TEST_CASE("study: how cloth lies beside how it lies in the reference", "[study]") {
    const Study& study = studyNamed("sphere");
    const Run run = studyRun(study, {});
    const World& world = run.scene.world;
    const auto lowered = [&](double height) {
        std::vector<Vec<double>> x = world.start;
        for (std::size_t v = 0; v < x.size(); ++v)
            if (!world.pinned[v]) x[v].y = height;
        return x;
    };
    Reference reference;
    reference.trajectory = {lowered(0.1)};
    Recording recording;
    recording.positions = {lowered(0.0005)};
    recording.metrics = {{1.5, 0, 0}, {0.5, 0, 0}};
    const auto errors = study.measure(study, run, recording, reference);
    REQUIRE(errors.size() == 3);
    CHECK(report("greatest strain", std::fabs(errors[0] - 0.015), 1e-12));
    CHECK(report("height", std::fabs(errors[1] - 0.0995), 1e-12));
    CHECK(report("part that lies", std::fabs(errors[2] - 4.0 / 1024), 1e-12));
    REQUIRE(run.scene.metrics[2].name == "crossings");
    recording.metrics[0][2] = 1;
    CHECK(std::isinf(study.measure(study, run, recording, reference)[0]));
}
