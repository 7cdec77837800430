#include "golden_pictures.h"

#include "demos/runs/simulation.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/words.h"
#include "render/pictures/image.h"

#include <plait/numbers/finite.h>

#include <stdexcept>

namespace plait::test {
namespace {

namespace fs = std::filesystem;

const GoldenScene& goldenNamed(const std::string& scene) {
    std::vector<std::string> names;
    for (const GoldenScene& golden : goldenScenes) names.push_back(golden.name);
    return goldenScenes[static_cast<std::size_t>(parseChoice("golden", scene, names))];
}

}  // namespace

fs::path goldenFolder(const fs::path& root, const std::string& scene) {
    return root / "golden/pictures" / scene;
}

Run goldenRun(const std::string& scene) {
    return makeRun({{"scene", scene}, {"quality", "draft"}});
}

RunFrame simulated(const Run& run, int number) {
    const auto simulation = makeSimulation(run, 1);
    settle(*simulation, run);
    for (int i = 0; i < number; ++i) simulation->advance();
    RunFrame frame = simulation->frame();
    frame.seconds = 0;
    return frame;
}

Picture goldenPicture(const fs::path& path) { return fs::exists(path) ? readPng(path) : Picture{}; }

std::vector<ComparisonEntry> bless(const fs::path& root, const std::string& scene) {
    const GoldenScene& golden = goldenNamed(scene);
    const fs::path folder = goldenFolder(root, scene), path = folder / "state";
    const Run run = goldenRun(scene);
    RunFrame state;
    if (fs::exists(path)) state = decodeFrame(readWhole(path), path.string());
    const bool kept = state.positions.size() == run.scene.world.rest.size();
    if (!kept) state = simulated(run, golden.frame);

    Renderer renderer(run.scene, goldenOptions);
    std::vector<ComparisonEntry> entries;
    const auto draw = [&](const std::string& file, const RunFrame& frame) {
        if (!allFinite(frame.positions)) throw std::domain_error(scene + ": not finite");
        entries.push_back(
            {scene + " " + file, renderer.draw(momentOf(frame)), goldenPicture(folder / file)});
    };
    draw("state.png", state);
    draw("frame.png", simulated(run, golden.early));
    makeFolder(folder);
    if (!kept) writeWhole(path, encodeFrame(state, numberSize(run)));
    writePng(folder / "state.png", entries[0].actual);
    writePng(folder / "frame.png", entries[1].actual);
    return entries;
}

}  // namespace plait::test
