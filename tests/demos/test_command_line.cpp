// What the command line says, and how it ends: design.md section 9.
#include "demos/runs/settings.h"
#include "program.h"
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/small_scenes.h"

#include <algorithm>
#include <filesystem>

using namespace plait;
using namespace plait::test;

namespace {

// One line on stderr that has all these parts, nothing on stdout, and this status.
void refuses(const std::vector<std::string>& words, int status,
             const std::vector<std::string>& parts) {
    const TemporaryFolder folder;
    std::vector<std::string> all = words;
    const bool out = words.size() > 1 && words[0] == "run";
    if (out) all.insert(all.end(), {"--out", (folder / "run").string()});
    const Outcome outcome = plait::test::plait(folder, all);
    INFO(outcome.err);
    CHECK(outcome.status == status);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    for (const std::string& part : parts) CHECK(contains(outcome.err, part));
    if (out) CHECK_FALSE(std::filesystem::exists(folder / "run"));
}

}  // namespace

TEST_CASE("list names every scene with its lesson", "[program]") {
    const TemporaryFolder folder;
    const Outcome list = plait::test::plait(folder, {"list"});
    CHECK(list.status == 0);
    for (const SceneEntry& entry : scenes()) {
        CHECK(contains(list.out, entry.name));
        CHECK(contains(list.out, entry.lesson));
    }
    const Outcome demos = plait::test::plait(folder, {"list", "--demos"});
    std::string names;
    for (const SceneEntry& entry : scenes())
        if (entry.demo) names += entry.name + "\n";
    CHECK(demos.out == names);
}

TEST_CASE("describe shows everything that a scene says of itself", "[program]") {
    const TemporaryFolder folder;
    for (const SceneEntry& entry : scenes()) {
        const Outcome outcome = plait::test::plait(folder, {"describe", entry.name, "-q", "draft"});
        INFO(outcome.out << outcome.err);
        CHECK(outcome.status == 0);
        std::vector<std::string> parts{entry.title, entry.lesson};
        parts.insert(parts.end(), entry.ingredients.begin(), entry.ingredients.end());
        parts.insert(parts.end(), entry.omissions.begin(), entry.omissions.end());
        for (const Knob& knob : entry.knobs) {
            parts.insert(parts.end(), {knob.name, knob.meaning, knob.unit});
            parts.insert(parts.end(), knob.choices.begin(), knob.choices.end());
        }
        for (const Metric& metric : build(entry, Quality::draft).metrics)
            parts.insert(parts.end(), {metric.name, metric.unit});
        for (const std::string& part : parts) CHECK(contains(outcome.out, part));
    }
}

TEST_CASE("every command has its help", "[program]") {
    const TemporaryFolder folder;
    const Outcome help = plait::test::plait(folder, {"--help"});
    CHECK(help.status == 0);
    for (const char* command : {"list", "describe", "run", "render", "check", "compare", "bench"}) {
        CHECK(contains(help.out, command));
        const Outcome own = plait::test::plait(folder, {command, "--help"});
        CHECK(own.status == 0);
        CHECK(contains(own.out, "plait " + std::string(command)));
    }
    const Outcome run = plait::test::plait(folder, {"run", "--help"});
    for (const char* option :
         {"-q, --quality", "--set",      "--method",     "--substeps",  "--iterations",
          "--direction",   "--schedule", "--integrator", "--precision", "--threads",
          "--seed",        "--fps",      "--seconds",    "--frames",    "--size",
          "--camera",      "--overlay",  "--no-caption", "--no-render", "--export",
          "--gl",          "--webp",     "--out",        "--resume",    "--force",
          "--quiet"})
        CHECK(contains(run.out, option));
}

TEST_CASE("help of a command, and what the program is made of", "[program]") {
    const TemporaryFolder folder;
    CHECK(plait::test::plait(folder, {"help", "run"}).out ==
          plait::test::plait(folder, {"run", "--help"}).out);
    const Outcome version = plait::test::plait(folder, {"--version"});
    CHECK(version.status == 0);
    for (const char* part :
         {"plait 0.", "compiler ", "kernels x86-64-v", " lanes", "OpenGL ", "Mesa"})
        CHECK(contains(version.out, part));
    refuses({"help", "rnu"}, 2, {"command", "'rnu'", "nearest: run"});
}

TEST_CASE("wrong words are refused in one line: what, allowed, nearest", "[program]") {
    refuses({"rnu", "pendulum"}, 2, {"command", "'rnu'", "nearest: run"});
    refuses({"run", "pendulm"}, 2, {"scene", "'pendulm'", "nearest: pendulum"});
    refuses({"run"}, 2, {"SCENE is missing"});
    refuses({"run", "pendulum", "chain"}, 2, {"'chain'", "one word too many"});
    refuses({"run", "pendulum", "--substep", "3"}, 2, {"--substep", "nearest: --substeps"});
    refuses({"run", "pendulum", "--substeps"}, 2, {"--substeps needs a value"});
    refuses({"run", "pendulum", "--quiet=yes"}, 2, {"--quiet takes no value"});
    refuses({"run", "pendulum", "--fps", "24", "--fps=30"}, 2, {"--fps is given twice"});
    refuses({"run", "pendulum", "--substeps", "0"}, 2, {"--substeps", "'0'", "1 to 1000000"});
    refuses({"run", "pendulum", "--substeps", "3.5"}, 2, {"--substeps", "whole number"});
    refuses({"run", "pendulum", "--seconds", "nan"}, 2, {"--seconds", "'nan'"});
    refuses({"run", "pendulum", "-q", "drat"}, 2, {"nearest: draft", "preview"});
    refuses({"run", "pendulum", "--method", "xpdb"}, 2, {"nearest: xpbd", "nucleus"});
    refuses({"run", "hanging-sheet", "--method", "implicit"}, 3,
            {"hanging-sheet", "method implicit", "set stretch", "compliance"});
    refuses({"run", "band", "--method", "symplectic"}, 3, {"method symplectic", "no rigid"});
    refuses({"run", "pendulum", "--set", "lenght=2"}, 2, {"pendulum", "nearest: length"});
    refuses({"run", "pendulum", "--set", "length=99"}, 2, {"--set length", "'99'", "0.1 to 10"});
    refuses({"run", "pendulum", "--set", "length"}, 2, {"KNOB=VALUE"});
    refuses({"run", "hanging-sheet", "--set", "pins=edges"}, 2, {"nearest: edge", "corners"});
    refuses({"run", "pendulum", "--size", "640"}, 2, {"--size", "WxH"});
    refuses({"run", "pendulum", "--size", "641x360"}, 2, {"--size", "odd"});
    refuses({"run", "pendulum", "--frames", "9:3"}, 2, {"--frames", "9 to 240"});
    refuses({"run", "pendulum", "--camera", "1,2,3"}, 2, {"--camera"});
    refuses({"run", "pendulum", "--overlay", "strian"}, 2, {"nearest: strain"});
    refuses({"run", "pendulum", "--export", "abc"}, 2, {"--export", "pc2"});
    refuses({"check", "no-such-place"}, 2, {"'no-such-place'", "nearest"});
    refuses({"render", "no-such-place"}, 5, {"no-such-place", "holds no run"});
    refuses({"compare", "no.png", "such.png"}, 5, {"no.png"});
    refuses({"run", "flag", "--set", "mesh=no-such.obj"}, 5, {"no-such.obj:0: no such file"});
}

TEST_CASE("options come in any order", "[program]") {
    const TemporaryFolder folder;
    const std::string out = (folder / "run").string();
    CHECK(plait::test::plait(folder, {"run", "--seconds", "0.1", "--no-render", "pendulum",
                                      "--out=" + out, "-q", "draft", "--quiet"})
              .status == 0);
    const std::string settings = contents(folder / "run/cache/settings.txt");
    CHECK(contains(settings, "quality=draft\n"));
    CHECK(contains(settings, "seconds=0.1\n"));
}

TEST_CASE("a frame rate looks more often and changes no substep", "[program][CA13]") {
    const TemporaryFolder folder;
    const auto settings = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{
            "run",     "hanging-sheet", "--no-render", "--out", (folder / "run").string(),
            "--force", "--seconds",     "0.1",         "-q",    "draft",
            "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        CHECK(plait::test::plait(folder, words).status == 0);
        return contents(folder / "run/cache/settings.txt");
    };
    const auto kept = [&] {  // but the start
        long frames = -1;
        for (const auto& file : std::filesystem::directory_iterator(folder / "run/cache"))
            frames += file.path().extension() == ".frame";
        return frames;
    };
    CHECK(contains(settings({}), "substeps=40\n"));
    CHECK(kept() == 2);
    CHECK(contains(settings({"--fps", "60"}), "substeps=16\n"));
    CHECK(kept() == 6);
    CHECK(contains(settings({"--substeps", "7", "--fps", "60"}), "substeps=7\n"));
    CHECK(contains(settings({"--fps", "30000/1001"}), "fps=30000/1001\n"));
}

namespace {

// No longer than `most` (s) of each.
void checkAll(const std::string& quality, double most) {
    const TemporaryFolder folder;
    for (const SceneEntry& entry : smallScenes()) {
        std::vector<std::string> words{"check", entry.name, "-q", quality};
        if (makeRun({{"scene", entry.name}, {"quality", quality}}).scene.seconds > most)
            words.insert(words.end(), {"--seconds", std::to_string(most)});
        const Outcome check = plait::test::plait(folder, words);
        INFO(entry.name << "\n" << check.out << check.err);
        CHECK(check.status == 0);
    }
}

}  // namespace

TEST_CASE("every scene keeps to its bands for a second of draft", "[program][figures]") {
    checkAll("draft", 1);
}

TEST_CASE("every scene keeps to its bands at draft", "[program][long]") {
    checkAll("draft", infinity);
}

TEST_CASE("every scene keeps to its bands at preview", "[program][long]") {
    checkAll("preview", infinity);
}

TEST_CASE("check holds a scene and a run to their bands", "[program]") {
    const TemporaryFolder folder;
    const Outcome scene = plait::test::plait(folder, {"check", "pendulum", "-q", "draft"});
    CHECK(scene.status == 0);
    CHECK(contains(scene.out, "strain"));
    const std::string out = (folder / "run").string();
    REQUIRE(plait::test::plait(
                folder, {"run", "pendulum", "--no-render", "--out", out, "-q", "draft", "--quiet"})
                .status == 0);
    CHECK(plait::test::plait(folder, {"check", out}).status == 0);
    CHECK(plait::test::plait(folder, {"check", out, "-q", "final"}).status == 2);

    // A bob above its pin; a row that lacks; columns of another scene.
    const std::string csv = contents(folder / "run/metrics.csv");
    const std::size_t comma = csv.rfind(','), row = csv.rfind('\n', csv.size() - 2);
    const auto with = [&](const std::string& text) {
        std::ofstream(folder / "run/metrics.csv") << text;
        return plait::test::plait(folder, {"check", out});
    };
    const Outcome high = with(csv.substr(0, comma) + ",0.5\n");
    CHECK(high.status == 1);
    CHECK(contains(high.out, "OUTSIDE from frame 96"));
    CHECK(with(csv.substr(0, comma) + ",nan\n").status == 1);
    const Outcome shorter = with(csv.substr(0, row + 1));
    CHECK(shorter.status == 1);
    CHECK(contains(shorter.out, "stopped at frame 95 of 96"));
    CHECK(with("frame,time[s]\n").status == 5);
}
