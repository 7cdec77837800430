// What strangers bring: meshes that change, and machines that lack threads or locks.
#include "demos/runs/run_all.h"
#include "demos/runs/settings.h"
#include "demos/study/tasks.h"
#include "strangers.h"
#include "tests/no_threads.h"

#include <plait/files/mesh_sequence.h>

#include <cerrno>
#include <cstring>

using namespace plait;
using namespace plait::test;

namespace fs = std::filesystem;

namespace {

// On a machine that lacks something (poor_machine.cpp).
Outcome poor(const TemporaryFolder& folder, const char* lack, int value,
             const std::vector<std::string>& words) {
    // What libraries leak whose threads do not start is theirs, and a symbolizer would be poor too.
    const char* const given = std::getenv("ASAN_OPTIONS");
    const std::string sanitizer = given ? given : "";
    setenv("ASAN_OPTIONS", (sanitizer + ":detect_leaks=0").c_str(), 1);
    setenv("LD_PRELOAD", PLAIT_POOR_MACHINE, 1);
    setenv(lack, std::to_string(value).c_str(), 1);
    const Outcome outcome = plait::test::plait(folder, words);
    for (const char* name : {"LD_PRELOAD", lack}) unsetenv(name);
    setenv("ASAN_OPTIONS", sanitizer.c_str(), 1);
    return outcome;
}

// A cloth of 0.6 m x 0.4 m whose last corner hangs `low` below its place.
void writeCloth(const fs::path& path, double low) {
    std::ofstream file(path);
    for (int i = 0; i < 12; ++i)
        file << "v " << 0.2 * (i % 4) << " " << -0.2 * (i / 4) - (i == 11 ? low : 0) << " 0\n";
    for (const int i : {1, 2, 3, 5, 6, 7})
        file << "f " << i << " " << i + 4 << " " << i + 5 << " " << i + 1 << "\n";
}

Outcome fly(const TemporaryFolder& folder, const std::vector<std::string>& more) {
    return plait::test::plait(
        folder, with({"run", "flag", "--quiet", "-q", "draft", "--no-render", "--set",
                      "self-collision=off", "--set", "mesh=" + (folder / "cloth.obj").string(),
                      "--out", (folder / "run").string()},
                     more));
}

std::vector<std::string> contentsIn(const fs::path& path) {
    std::vector<std::string> all;
    forContents(path, [&](std::string_view bytes) { all.emplace_back(bytes); });
    return all;
}

}  // namespace

TEST_CASE("an edited mesh is not taken for the old one", "[program][strangers]") {
    const TemporaryFolder folder;
    const fs::path mesh = folder / "cloth.obj";
    const std::string run = (folder / "run").string();
    const std::vector<std::string> tenth{"--seconds", "0.1"};
    writeCloth(mesh, 0.1);
    REQUIRE(fly(folder, tenth).status == 0);
    const std::string before = contents(folder / "run/metrics.csv");
    const auto written = fs::last_write_time(mesh);

    writeCloth(mesh, 0.2);
    fs::last_write_time(mesh, written);
    refuses(fly(folder, with(tenth, {"--resume"})), 5, mesh.string());
    refuses(fly(folder, tenth), 5, mesh.string());
    refuses(plait::test::plait(folder, {"check", run}), 5, mesh.string());
    refuses(plait::test::plait(folder, {"render", run}), 5, mesh.string());
    CHECK(contents(folder / "run/metrics.csv") == before);

    fs::remove(mesh);
    refuses(plait::test::plait(folder, {"check", run}), 5, "no such file");
    writeCloth(mesh, 0.1);
    CHECK(plait::test::plait(folder, {"check", run}).status == 0);
    CHECK(fly(folder, with(tenth, {"--resume"})).status == 0);

    writeCloth(mesh, 0.2);
    CHECK(fly(folder, with(tenth, {"--force"})).status == 0);
    CHECK(contents(folder / "run/metrics.csv") != before);
}

TEST_CASE("a mesh edited while a run goes is not that of the run", "[program][strangers]") {
    const TemporaryFolder folder;
    writeCloth(folder / "cloth.obj", 0.1);
    const Program program(
        folder, {"run", "flag", "--quiet", "-q", "draft", "--no-render", "--set",
                 "self-collision=off", "--set", "mesh=" + (folder / "cloth.obj").string(), "--out",
                 (folder / "run").string(), "--seconds", "1"});
    while (!fs::exists(folder / "run/cache/00001.frame")) usleep(1000);
    writeCloth(folder / "cloth.obj", 0.2);
    CHECK(program.wait().status == 0);
    refuses(plait::test::plait(folder, {"check", (folder / "run").string()}), 5, "cloth.obj");
}

TEST_CASE("the content of a sequence is that of all its files", "[program][strangers]") {
    const TemporaryFolder folder;
    using Contents = std::vector<std::string>;
    for (const char* name : {"b10.obj", "b2.obj", "c.pc2", "c.obj"})
        std::ofstream(folder / name) << name;
    CHECK(contentsIn(folder / "c.obj") == Contents{"c.obj"});
    CHECK(contentsIn(folder / "b*.obj") == Contents{"b2.obj", "b10.obj"});
    CHECK(contentsIn(folder / "c.pc2") == Contents{"c.pc2", "c.obj"});
    for (const char* none : {"d*.obj", "d.obj"})
        CHECK_THROWS_AS(contentsIn(folder / none), MeshFileError);
}

TEST_CASE("settings name a file the same way from any folder", "[program][strangers]") {
    const TemporaryFolder folder;
    fs::create_directories(folder / "elsewhere");
    writeCloth(folder / "cloth.obj", 0);
    const fs::path back = fs::current_path();
    const auto settings = [&](const char* from, const char* mesh) {
        fs::current_path(folder / from);
        const Run run = makeRun({{"scene", "flag"}, {"quality", "draft"}, {"knob.mesh", mesh}});
        fs::current_path(back);
        return textOf(settingsOf(run));
    };
    const std::string here = settings(".", "cloth.obj");
    CHECK(settings("elsewhere", "../cloth.obj") == here);
    CHECK(contains(here, "\ncontent.mesh="));
    // A run without a mesh may go on where an older program began it.
    const Settings none = settingsOf(makeRun({{"scene", "flag"}, {"quality", "draft"}}));
    CHECK_FALSE(contains(textOf(none), "content"));
}

TEST_CASE("a study does again what was done with another mesh", "[program][strangers]") {
    const TemporaryFolder folder;
    writeCloth(folder / "cloth.obj", 0.1);
    const StudyFolder kept(studyNamed("flag"), folder / "study");
    const StudyTask task{{{"knob.mesh", (folder / "cloth.obj").string()}}, 1};
    const fs::path row = kept.rowPath(task);
    CHECK(kept.rowPath(task) == row);
    writeCloth(folder / "cloth.obj", 0.2);
    CHECK(kept.rowPath(task) != row);
}

TEST_CASE("a machine that starts few threads simulates with those", "[program][strangers]") {
    const TemporaryFolder folder;
    std::string expected;
    for (const int threads : {7, 4, 3, 1, 0}) {
        const Outcome outcome = poor(folder, "POOR_THREADS", threads,
                                     pendulumRun(folder, {"--threads", "8", "--no-render"}));
        INFO(threads << " " << outcome.err);
        CHECK(outcome.status == 0);
        CHECK(lines(outcome.err) == (threads < 7 ? 1 : 0));
        CHECK(contains(contents(folder / "run/run.json"),
                       "\"threads\": " + std::to_string(threads + 1)));
        const std::string metrics = contents(folder / "run/metrics.csv");
        if (expected.empty()) expected = metrics;
        CHECK(metrics == expected);
    }
}

TEST_CASE("a film without threads is refused and not waited for", "[program][strangers]") {
    const TemporaryFolder folder;
    for (const int threads : {0, 1}) {
        refuses(poor(folder, "POOR_THREADS", threads, pendulumRun(folder, {"--threads", "1"})), 5,
                "Resource temporarily unavailable");
        CHECK_FALSE(fs::exists(folder / "run/clip.mp4"));
    }
    // Those of Mesa and of the encoder are not of our making: without them it films or says why.
    for (const int threads : {2, 3, 4, 6}) {
        const Outcome outcome = poor(folder, "POOR_THREADS", threads,
                                     pendulumRun(folder, {"--threads", "1", "--force"}));
        INFO(threads << " " << outcome.err);
        CHECK((outcome.status == 0 || (outcome.status == 5 && lines(outcome.err) == 1)));
        CHECK(fs::exists(folder / "run/clip.mp4") == (outcome.status == 0));
    }
}

TEST_CASE("tasks are done where no thread starts", "[program][threads][strangers]") {
    const NoThreads none;
    Progress progress("tasks", 0, 3, true);
    std::vector<int> done(3, 0);
    runAll(3, 2, 0, progress, [&](int i, int) { ++done[static_cast<std::size_t>(i)]; });
    CHECK(done == std::vector<int>{1, 1, 1});
}

TEST_CASE("a file system without locks is not another run", "[program][strangers]") {
    const TemporaryFolder folder;
    const std::vector<std::string> words = pendulumRun(folder, {"--no-render"});
    for (const int reason : {ENOSYS, EBADF, ENOLCK, EOPNOTSUPP, EINVAL}) {
        const Outcome outcome = poor(folder, "POOR_LOCKS", reason, words);
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(lines(outcome.err) == 1);
        CHECK(contains(outcome.err, std::string("no locks here (") + std::strerror(reason)));
    }
    refuses(poor(folder, "POOR_LOCKS", EWOULDBLOCK, words), 5, "another run is at work");
}
