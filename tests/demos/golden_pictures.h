// Golden pictures: what stands in golden/pictures/SCENE, and how it is made again.
//
//   state      one frame of the scene at draft quality, in the bytes of a frame of the cache
//   state.png  that frame drawn: only the renderer can change it
//   frame.png  frame `early`, simulated and drawn
#pragma once

#include "demos/output/exposure.h"
#include "demos/runs/run_frame.h"
#include "demos/runs/settings.h"
#include "render/camera.h"
#include "render/pictures/compare.h"
#include "render/renderer.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plait::test {

struct GoldenScene {
    std::string name;
    int frame;       // whose state is stored: one that shows what the scene is about
    int early = 12;  // soon reached: every run of the tests simulates it
};

// Every scene that has goldens: a new one is a line here and a blessing.
inline const std::vector<GoldenScene> goldenScenes{
    {"balloon", 60},
    {"band", 4},
    {"bullet", 6},
    {"burst", 30},
    {"cantilever", 9},
    {"caramel", 72, 6},
    {"chain", 26},
    {"coil", 14},
    {"dam-break", 34},
    {"dissolve", 40, 6},
    {"dress", 112, 1},
    {"droplets", 14, 3},
    {"elbow", 28, 1},
    {"fireworks", 58},
    {"flag", 40},
    {"glass", 60, 14},
    {"goal", 66, 6},
    {"grain-pile", 60},
    {"handkerchief", 36, 24},
    {"hanging-sheet", 79},
    {"heavy-rod", 24},
    {"layered-sheets", 10},
    {"let-go", 40, 6},
    {"levitation", 108},
    {"liquid", 120, 1},
    {"medley", 30},
    {"pendulum", 18},
    {"pile", 16},
    {"sheet-on-sphere", 30},
    {"sheet-slinky", 9, 3},
    {"slinky", 100, 2},
    {"stacks", 14},
    {"strip-in-wind", 30},
    {"swatches", 30},
    {"tablecloth", 28},
    {"tendrils", 30},
    {"torn-vest", 52},
    {"trampoline", 10},
    {"tress", 22, 1},
    {"two-balloons", 24},
    {"unit-spring", 75},
    {"wind-gauge", 1},
    {"wine-glass", 420, 60},
};

inline constexpr RenderOptions goldenOptions{.width = 480, .height = 270};

// Of frame.png: the loose rule, and the tight one's FLIP, since a thin object that is not there at
// all is less than 2 % of a picture.
inline constexpr PassRule earlyRule{.beyond8 = looseRule.beyond8, .meanFlip = tightRule.meanFlip};

// The folder of a scene's goldens in `root`, the repository.
std::filesystem::path goldenFolder(const std::filesystem::path& root, const std::string& scene);

Run goldenRun(const std::string& scene);
// Frame `number` of it; the seconds that it took are 0, so that equal frames have equal bytes.
RunFrame simulated(const Run& run, int number);

// The picture in a file; one without pixels where there is none.
Picture goldenPicture(const std::filesystem::path& path);

// Writes the goldens of a scene and returns its pictures, the new ones as actual, beside those
// that they replace. A stored state that fits the scene is kept, so that pictures change by the
// renderer alone: remove the file for a new one. Throws UsageError for a scene without goldens,
// FileError, std::runtime_error, and std::domain_error for a state that is not finite.
std::vector<ComparisonEntry> bless(const std::filesystem::path& root, const std::string& scene);

}  // namespace plait::test
