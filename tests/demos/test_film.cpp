// Pictures of a run, through the program.
#include "demos/runs/run_folder.h"
#include "program.h"
#include "tests/catch.h"

#include <algorithm>
#include <csignal>

using namespace plait;
using namespace plait::test;

namespace fs = std::filesystem;

namespace {

std::vector<std::string> film(const TemporaryFolder& folder, const std::string& name) {
    return {"run",
            "strip-in-wind",
            "--quiet",
            "--out",
            (folder / name).string(),
            "--threads",
            "1",
            "-q",
            "draft",
            "--seconds",
            "0.5",
            "--size",
            "160x90",
            "--no-caption"};
}

// Every picture has the same bytes, and clip and sheet are there.
void checkAlike(const TemporaryFolder& folder, const std::string& a, const std::string& b) {
    for (int i = 1; i <= 12; ++i) {
        const std::string name = "frames/" + numbered(i, ".png");
        INFO(name);
        const bool same = contents(folder / a / name) == contents(folder / b / name);
        CHECK(same);
    }
    for (const char* name : {"clip.mp4", "contact.png"}) {
        INFO(name);
        CHECK(fs::file_size(folder / b / name) > 1000);
    }
}

}  // namespace

TEST_CASE("a film: pictures, clip and contact sheet, again from the cache, and compared",
          "[program][CA10]") {
    const TemporaryFolder folder;
    auto words = film(folder, "run");
    words.erase(std::find(words.begin(), words.end(), "--quiet"));
    const Outcome outcome = plait::test::plait(folder, words);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out == (folder / "run/clip.mp4").string() + "\n");
    const std::string json = contents(folder / "run/run.json");
    for (const char* key : {"library", "renderer", "open renderer", "draw", "encode", "width"})
        CHECK(contains(json, "\"" + std::string(key) + "\": "));

    fs::copy(folder / "run", folder / "again", fs::copy_options::recursive);
    // Mesa treats denormals by the thread that it draws in; none may reach a picture.
    setenv("LP_NUM_THREADS", "0", 1);
    REQUIRE(plait::test::plait(folder, {"render", (folder / "again").string(), "--size", "160x90",
                                        "--no-caption", "--quiet"})
                .status == 0);
    unsetenv("LP_NUM_THREADS");
    checkAlike(folder, "run", "again");

    const auto picture = [&](int i) {
        return (folder / ("run/frames/" + numbered(i, ".png"))).string();
    };
    const Outcome same = plait::test::plait(folder, {"compare", picture(3), picture(3)});
    CHECK(same.status == 0);
    CHECK(contains(same.out, "alike"));
    const Outcome other = plait::test::plait(folder, {"compare", picture(3), picture(12)});
    CHECK(other.status == 1);
    CHECK(contains(other.out, "DIFFERENT"));

    // Others of the same run: an overlay, and some frames alone.
    REQUIRE(
        plait::test::plait(folder, {"render", (folder / "again").string(), "--size", "160x90",
                                    "--overlay", "strain", "--frames", "4:6", "--webp", "--quiet"})
            .status == 0);
    CHECK(fs::exists(folder / "again/clip.webp"));
    CHECK_FALSE(fs::exists(folder / "again/frames/00003.png"));
    CHECK(fs::exists(folder / "again/frames/00006.png"));
    const bool same5 = contents(folder / "again/frames/00005.png") == contents(picture(5));
    CHECK_FALSE(same5);
}

TEST_CASE("killed while filming, a run goes on to the same film", "[program]") {
    const TemporaryFolder folder;
    REQUIRE(plait::test::plait(folder, film(folder, "straight")).status == 0);
    for (const int signal : {SIGKILL, SIGTERM}) {
        fs::remove_all(folder / "stopped");
        const Program program(folder, film(folder, "stopped"));
        while (!fs::exists(folder / "stopped/frames/00003.png")) usleep(1000);
        program.signal(signal);
        CHECK(program.wait().status == (signal == SIGKILL ? 137 : 130));
        CHECK_FALSE(fs::exists(folder / "stopped/clip.mp4"));
        for (const auto& entry : fs::directory_iterator(folder / "stopped"))
            CHECK((signal == SIGKILL || entry.path().extension() != ".part"));
        auto words = film(folder, "stopped");
        words.push_back("--resume");
        REQUIRE(plait::test::plait(folder, words).status == 0);
        checkAlike(folder, "straight", "stopped");
    }
}

TEST_CASE("what cannot be filmed is told so", "[program]") {
    const TemporaryFolder folder;
    auto words = film(folder, "run");
    words.insert(words.end(), {"--camera", "0,0,0:0,0,0"});
    const Outcome outcome = plait::test::plait(folder, words);
    INFO(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, "--camera"));
}
