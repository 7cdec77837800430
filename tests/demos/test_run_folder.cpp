// What a run leaves, and that it can be stopped at any moment.
#include "demos/runs/simulation.h"
#include "program.h"
#include "tests/blessed_hashes.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/small_scenes.h"

#include <plait/solver.h>

#include <algorithm>
#include <csignal>
#include <ctime>

using namespace plait;
using namespace plait::test;

namespace fs = std::filesystem;

namespace {

// Long enough to be killed in: some 0.3 s.
std::vector<std::string> longRun(const TemporaryFolder& folder, const std::string& name) {
    return {"run",         "hanging-sheet",
            "--no-render", "--quiet",
            "--out",       (folder / name).string(),
            "--seconds",   "3",
            "--substeps",  "200",
            "--threads",   "1",
            "-q",          "draft"};
}

std::vector<std::string> with(std::vector<std::string> words, const std::string& more) {
    words.push_back(more);
    return words;
}

std::string hashIn(const fs::path& run) {
    const std::string json = contents(run / "run.json"), key = "\"hash\": \"";
    const std::size_t at = json.find(key);
    return at == std::string::npos ? "" : json.substr(at + key.size(), 16);
}

// No file of `run` was left half-written.
bool isWhole(const fs::path& run) {
    for (const auto& entry : fs::recursive_directory_iterator(run))
        if (entry.path().extension() == ".part") return false;
    return true;
}

void sleepFor(double seconds) {
    const timespec time{0, static_cast<long>(1e9 * seconds)};
    nanosleep(&time, nullptr);
}

}  // namespace

TEMPLATE_TEST_CASE("a checkpoint goes on with the same bits, in every scene",
                   "[program][figures][CA9]", float, double) {
    const std::string precision = sizeof(TestType) == sizeof(float) ? "float" : "double";
    for (const SceneEntry& entry : smallScenes()) {
        INFO(entry.name);
        const Run run =
            makeRun({{"scene", entry.name}, {"quality", "draft"}, {"precision", precision}});
        const auto paused = makeSimulation(run, 1), resumed = makeSimulation(run, 2);
        for (int i = 0; i < 2; ++i) paused->advance();
        resumed->restore(paused->checkpoint(), "checkpoint");
        const RunFrame a = paused->frame(), b = resumed->frame();
        CHECK(a.metrics == b.metrics);
        CHECK(a.evaluations == b.evaluations);
        CHECK(a.number == b.number);
        CHECK(a.time == b.time);
        for (int i = 2; i < blessedFrames; ++i) resumed->advance();
        CHECK(resumed->hash() == blessedHash<TestType>(entry.name));
    }
}

TEST_CASE("a checkpoint keeps every drawer and every cut", "[program]") {
    Checkpoint<float> checkpoint;
    checkpoint.state.particles.resize(4);
    checkpoint.state.velocity.resize(4);
    checkpoint.state.kept = {{.numbers = {}, .integers = {1, 0, 10}},
                             {.numbers = {2}, .integers = {}}};
    checkpoint.state.id = {0, 0, 2};
    checkpoint.state.born = {0, 0, 7};
    checkpoint.state.cuts = {9, 4};
    const std::string bytes = encodeCheckpoint(checkpoint);
    const State<float> state = decodeCheckpoint<float>(bytes, "it").state;
    CHECK(state.particles.size() == 4);
    CHECK(state.velocity.size() == 4);
    CHECK(state.last.empty());
    REQUIRE(state.kept.size() == 2);
    CHECK(state.kept[0].integers == std::vector<std::int32_t>{1, 0, 10});
    CHECK(state.kept[1].numbers == std::vector<float>{2});
    CHECK(state.id == checkpoint.state.id);
    CHECK(state.born == checkpoint.state.born);
    CHECK(state.cuts == checkpoint.state.cuts);
}

TEST_CASE("a frame is read as it was written, cuts and all", "[program]") {
    const RunFrame frame{.number = 12,
                         .time = 0.5,
                         .evaluations = 1L << 40,
                         .seconds = 0.25,
                         .metrics = {1.0 / 3, -2},
                         .positions = {{1, 2, 3}, {0.5, -0.25, 4}},
                         .velocities = {{0, -1, 0}, {8, 0, 0.125}},
                         .touched = {0, 1},
                         .ids = {0, -1},
                         .ages = {0.5, -1},
                         .cuts = {7, 3, 5}};
    for (const int size : {4, 8}) {
        const RunFrame back = decodeFrame(encodeFrame(frame, size), "it");
        CHECK(back.number == frame.number);
        CHECK(back.time == frame.time);
        CHECK(back.evaluations == frame.evaluations);
        CHECK(back.seconds == frame.seconds);
        CHECK(back.metrics == frame.metrics);
        CHECK((back.positions == frame.positions && back.velocities == frame.velocities));
        CHECK(back.touched == frame.touched);
        CHECK(back.ids == frame.ids);
        CHECK(back.ages == frame.ages);
        CHECK(back.cuts == frame.cuts);
    }
}

TEST_CASE("a state of another world is not restored", "[program]") {
    const Scene pendulum = build(findScene("pendulum")), chain = build(findScene("chain"));
    Solver<float> solver(pendulum.world, pendulum.options);
    const Solver<float> other(chain.world, chain.options);
    CHECK_THROWS_AS(solver.restore(other.state(), 0), std::invalid_argument);
}

TEST_CASE("a run leaves what it promises", "[program]") {
    const TemporaryFolder folder;
    const Outcome outcome = plait::test::plait(
        folder, {"run", "pendulum", "--no-render", "--out", (folder / "run").string(), "-q",
                 "draft", "--seconds", "0.5", "--set", "length=2"});
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out == (folder / "run/run.json").string() + "\n");
    CHECK(contains(outcome.err, "12/12 frames"));
    CHECK(isWhole(folder / "run"));

    const std::string csv = contents(folder / "run/metrics.csv");
    CHECK(csv.starts_with("frame,time[s],evaluations,strain[%],energy[%],bob[m]\n0,0,0,"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 14);
    for (int i = 0; i <= 12; ++i)
        CHECK(fs::exists(folder / ("run/cache/000" + std::string(i < 10 ? "0" : "") +
                                   std::to_string(i) + ".frame")));

    const std::string json = contents(folder / "run/run.json");
    const std::string readme = contents(PLAIT_ROOT "/demos/README.md");
    for (const char* key :
         {"versions",  "plait",     "compiler", "eigen",         "scene",       "quality",
          "ending",    "knobs",     "settings", "size",          "vertices",    "frames",
          "simulated", "resumedAt", "hash",     "work",          "evaluations", "seconds",
          "build",     "simulate",  "total",    "peakMemory[B]", "machine",     "processor",
          "cores",     "threads",   "kernels",  "lanes",         "metrics",     "least",
          "most"}) {
        INFO(key);
        CHECK(contains(json, "\"" + std::string(key) + "\": "));
        CHECK(contains(readme, "`" + std::string(key) + "`"));
    }
    CHECK(contains(json, "\"length\": 2"));
    CHECK(contains(json, "\"ending\": \"complete\""));
}

TEST_CASE("a folder with another run is refused, and replaced by force", "[program]") {
    const TemporaryFolder folder;
    const std::vector<std::string> words{
        "run",   "pendulum",  "--no-render", "--quiet", "-q",
        "draft", "--seconds", "0.2",         "--out",   (folder / "run").string()};
    REQUIRE(plait::test::plait(folder, words).status == 0);
    const std::string csv = contents(folder / "run/metrics.csv");
    CHECK(plait::test::plait(folder, words).status == 0);  // the same once more

    auto other = words;
    other.insert(other.end(), {"--substeps", "10"});
    for (const auto& refused : {other, with(other, "--resume")}) {
        const Outcome outcome = plait::test::plait(folder, refused);
        CHECK(outcome.status == 5);
        CHECK(contains(outcome.err, "substeps=20"));
        CHECK(contains(outcome.err, "substeps=10"));
        CHECK(contains(outcome.err, "--force"));
        CHECK(contents(folder / "run/metrics.csv") == csv);
    }
    CHECK(plait::test::plait(folder, with(other, "--force")).status == 0);
    CHECK(contents(folder / "run/metrics.csv") != csv);
}

TEST_CASE("a folder of the user's own is never touched", "[program]") {
    const TemporaryFolder folder;
    fs::create_directories(folder / "mine/cache");
    std::ofstream(folder / "mine/cache/letter") << "dear";
    const Outcome outcome = plait::test::plait(
        folder, {"run", "pendulum", "--no-render", "--force", "--out", (folder / "mine").string()});
    CHECK(outcome.status == 5);
    CHECK(contains(outcome.err, "holds no run"));
    CHECK(contents(folder / "mine/cache/letter") == "dear");
}

TEST_CASE("killed at any moment, a run goes on with the same bits", "[program][CA9]") {
    const TemporaryFolder folder;
    REQUIRE(plait::test::plait(folder, longRun(folder, "straight")).status == 0);
    Random random(7);
    int kills = 0;
    for (int attempt = 0; attempt < 60; ++attempt) {
        const Program program(folder, with(longRun(folder, "killed"), "--resume"));
        sleepFor(kills < 6 ? random.uniform(0.01, 0.06) : 0.9);
        program.signal(SIGKILL);
        const Outcome outcome = program.wait();
        INFO(outcome.err);
        if (outcome.status == 0) break;
        REQUIRE(outcome.status == 128 + SIGKILL);
        ++kills;
    }
    note("kills until the run was complete", kills);
    CHECK(kills >= 3);
    REQUIRE(plait::test::plait(folder, with(longRun(folder, "killed"), "--resume")).status == 0);
    CHECK(contents(folder / "killed/metrics.csv") == contents(folder / "straight/metrics.csv"));
    CHECK(hashIn(folder / "killed") == hashIn(folder / "straight"));
    CHECK(hashIn(folder / "killed").size() == 16);
    CHECK(isWhole(folder / "killed"));
}

TEST_CASE("interrupted, a run stops between frames and tells so", "[program]") {
    const TemporaryFolder folder;
    REQUIRE(plait::test::plait(folder, longRun(folder, "straight")).status == 0);
    for (const int signal : {SIGINT, SIGTERM}) {
        fs::remove_all(folder / "stopped");
        const Program program(folder, longRun(folder, "stopped"));
        while (!fs::exists(folder / "stopped/cache/00002.frame")) sleepFor(0.001);
        program.signal(signal);
        const Outcome outcome = program.wait();
        CHECK(outcome.status == 130);
        CHECK(outcome.err == "plait: interrupted\n");
        CHECK(isWhole(folder / "stopped"));
        CHECK(contains(contents(folder / "stopped/run.json"), "\"ending\": \"interrupted\""));
        const Outcome check = plait::test::plait(folder, {"check", (folder / "stopped").string()});
        CHECK(check.status == 1);
        CHECK(contains(check.out, "stopped at frame"));
        REQUIRE(plait::test::plait(folder, with(longRun(folder, "stopped"), "--resume")).status ==
                0);
        CHECK(contents(folder / "stopped/metrics.csv") ==
              contents(folder / "straight/metrics.csv"));
        CHECK(hashIn(folder / "stopped") == hashIn(folder / "straight"));
    }
}

// A frame of some 20 s: where a signal waits for its end, the frame is there.
TEST_CASE("interrupted within a frame, a run does not wait for its end", "[program][strangers]") {
    const TemporaryFolder folder;
    std::vector<std::string> words = longRun(folder, "stopped");
    *std::ranges::find(words, "200") = "1000000";
    const Program program(folder, words);
    while (!fs::exists(folder / "stopped/cache")) sleepFor(0.001);
    sleepFor(0.1);
    program.signal(SIGINT);
    const Outcome outcome = program.wait();
    CHECK(outcome.status == 130);
    CHECK(outcome.err == "plait: interrupted\n");
    CHECK(isWhole(folder / "stopped"));
    CHECK_FALSE(fs::exists(folder / "stopped/cache/00001.frame"));
    CHECK(contains(contents(folder / "stopped/run.json"), "\"ending\": \"interrupted\""));
}

TEST_CASE("two runs do not share a folder", "[program]") {
    const TemporaryFolder folder;
    const Program first(folder, longRun(folder, "run"));
    while (!fs::exists(folder / "run/cache/00001.frame")) sleepFor(0.001);
    const TemporaryFolder outputs;
    const Outcome second = plait::test::plait(outputs, longRun(folder, "run"));
    CHECK(second.status == 5);
    CHECK(contains(second.err, "another run is at work"));
    CHECK(first.wait().status == 0);
}

TEST_CASE("a damaged cache is noticed", "[program]") {
    const TemporaryFolder folder;
    const std::vector<std::string> words{
        "run",   "chain",     "--no-render", "--quiet", "-q",
        "draft", "--seconds", "0.2",         "--out",   (folder / "run").string()};
    REQUIRE(plait::test::plait(folder, words).status == 0);
    for (const char* name : {"run/cache/00002.frame", "run/cache/checkpoint"}) {
        const std::string bytes = contents(folder / name);
        for (const std::string& bad : {bytes.substr(0, bytes.size() / 2), std::string("x"),
                                       bytes.substr(0, 99) + '!' + bytes.substr(100)}) {
            std::ofstream(folder / name, std::ios::binary) << bad;
            const Outcome outcome = plait::test::plait(folder, with(words, "--resume"));
            CHECK(outcome.status == 5);
            CHECK(contains(outcome.err, name));
        }
        std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    CHECK(plait::test::plait(folder, with(words, "--resume")).status == 0);
}

TEST_CASE("a run that diverges says what broke it and keeps the last good frame", "[program]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    const std::vector<std::string> words{"run",   "wind-gauge", "--no-render", "--quiet",
                                         "--set", "lift=20",    "--out",       out};
    const Outcome outcome = plait::test::plait(folder, words);
    INFO(outcome.err);
    CHECK(outcome.status == 4);
    CHECK(contains(outcome.err, "air made a number that is not finite"));
    CHECK(contains(contents(folder / "run/run.json"), "\"ending\": \"diverged: air"));
    CHECK(contains(contents(folder / "run/metrics.csv"), "\n0,0,0,"));
    CHECK(isWhole(folder / "run"));
    CHECK(plait::test::plait(folder, with(words, "--resume")).status == 4);  // it is deterministic
}
