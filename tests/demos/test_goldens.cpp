// Pictures held to their goldens: golden_pictures.h tells which there are.
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "golden_pictures.h"
#include "render/pictures/image.h"
#include "render/pictures/paint.h"
#include "tests/catch.h"
#include "tests/render/studio.h"
#include "tests/scratch_folder.h"

#include <plait/numbers/finite.h>

#include <algorithm>
#include <cstdio>

using namespace plait;
using namespace plait::test;

namespace {

namespace fs = std::filesystem;

RunFrame storedState(const std::string& scene) {
    const fs::path path = goldenFolder(PLAIT_ROOT, scene) / "state";
    return decodeFrame(readWhole(path), path.string());
}

// Holds one scene to its goldens; all failures so far stand on one page.
void judge(const GoldenScene& of, std::vector<ComparisonEntry>& failures) {
    const std::string& scene = of.name;
    const Run run = goldenRun(scene);
    Renderer renderer(run.scene, goldenOptions);
    const auto hold = [&](const std::string& file, const RunFrame& frame, const PassRule& rule) {
        INFO(scene << " " << file);
        REQUIRE(frame.positions.size() == run.scene.world.rest.size());
        REQUIRE(allFinite(frame.positions));
        const Picture actual = renderer.draw(momentOf(frame));
        const Picture golden = goldenPicture(goldenFolder(PLAIT_ROOT, scene) / file);
        const Comparison comparison = compare(actual, golden);
        std::printf("    %-24s %s\n", (scene + " " + file).c_str(), describe(comparison).c_str());
        CHECK(passes(comparison, rule));
        if (passes(comparison, rule)) return;
        failures.push_back({scene + " " + file, actual, golden});
        std::printf("    side by side: %s\n",
                    writeComparisonPage(PLAIT_PAGES "/failed", failures).c_str());
    };
    hold("state.png", storedState(scene), tightRule);
    hold("frame.png", simulated(run, of.early), earlyRule);
}

// The positions, moved across the picture by so many of its pixels.
std::vector<Vec<double>> moved(const Run& run, const RunFrame& frame, double pixels) {
    const CameraPose pose = poseAt(run.scene.view.cameras, frame.time);
    const double pixel = 2 * glm::length(pose.target - pose.eye) * std::tan(pose.fieldOfView / 2) /
                         goldenOptions.height;
    const glm::vec3 right = glm::normalize(glm::cross(pose.forward(), glm::vec3(0, 1, 0)));
    std::vector<Vec<double>> positions = frame.positions;
    for (Vec<double>& x : positions) x += pixels * pixel * Vec<double>{right.x, right.y, right.z};
    return positions;
}

Scene recoloured(Scene scene) {
    for (Look& look : scene.view.looks) std::swap(look.color[0], look.color[2]);
    return scene;
}

}  // namespace

TEST_CASE("every scene looks like its goldens", "[goldens][figures]") {
    std::vector<ComparisonEntry> failures;
    for (const GoldenScene& golden : goldenScenes) judge(golden, failures);
}

TEST_CASE("every golden is of a scene that is listed", "[goldens]") {
    for (const auto& folder : fs::directory_iterator(goldenFolder(PLAIT_ROOT, ""))) {
        const std::string name = folder.path().filename();
        INFO(name);
        CHECK(std::any_of(goldenScenes.begin(), goldenScenes.end(),
                          [&](const GoldenScene& golden) { return golden.name == name; }));
    }
}

TEST_CASE("a doctored picture of a scene does not pass for its golden", "[goldens]") {
    // The thinnest, the smallest and the largest: the others lie between them.
    for (const std::string scene : {"chain", "pendulum", "hanging-sheet"}) {
        const Run run = goldenRun(scene);
        const RunFrame state = storedState(scene);
        const Picture golden = goldenPicture(goldenFolder(PLAIT_ROOT, scene) / "state.png");
        const auto rejected = [&](const char* what, const Picture& doctored, bool early = true) {
            const Comparison c = compare(doctored, golden);
            std::printf("    %-32s %s\n", (scene + ", " + what).c_str(), describe(c).c_str());
            return !passes(c, tightRule) && !(early && passes(c, earlyRule));
        };
        Renderer renderer(run.scene, goldenOptions);
        CHECK(rejected("moved by a pixel", renderer.draw(moved(run, state, 1), state.time), false));
        CHECK(rejected("absent", renderer.draw(moved(run, state, 1e5), state.time)));
        CHECK(rejected("mirrored", mirrored(golden)));
        CHECK(rejected("blank", filled(golden.width, golden.height, ink)));
        Renderer other(recoloured(run.scene), goldenOptions);
        CHECK(rejected("recoloured", other.draw(state.positions, state.time)));
    }
}

TEST_CASE("blessing writes goldens that pass, and keeps a state that fits", "[goldens]") {
    const ScratchFolder root;
    const fs::path folder = goldenFolder(root / "", "pendulum");
    const auto first = bless(root / "", "pendulum");
    REQUIRE(first.size() == 2);
    for (const ComparisonEntry& entry : first) CHECK(entry.golden.rgb.empty());
    CHECK(goldenPicture(folder / "state.png") == first[0].actual);
    CHECK(goldenPicture(folder / "frame.png") == first[1].actual);

    RunFrame state = decodeFrame(readWhole(folder / "state"), "state");
    state.positions.back().y -= 0.25;
    writeWhole(folder / "state", encodeFrame(state, 4));
    const auto second = bless(root / "", "pendulum");
    CHECK(second[0].golden == first[0].actual);
    CHECK_FALSE(passes(compare(second[0].actual, second[0].golden), tightRule));
    CHECK(second[1].actual == second[1].golden);
    CHECK_THROWS_AS(bless(root / "", "pendulun"), UsageError);
    CHECK_FALSE(fs::exists(goldenFolder(root / "", "pendulun")));
}
