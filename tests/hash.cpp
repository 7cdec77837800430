// One line a scene and precision, "name precision hash": the state after a few frames of draft.
// Every compiler, level, lane width and number of threads must agree on it (tests/run --long
// compares).
#include "scenes/scene.h"
#include "tests/blessed_hashes.h"

#include <plait/solver.h>

#include <cstdio>

namespace {

template <class Real>
void print(const plait::SceneEntry& entry, const char* precision) {
    const plait::Scene scene = plait::build(entry, plait::Quality::draft);
    plait::Solver<Real> solver(scene.world, scene.options);
    for (int frame = 0; frame < plait::test::blessedFrames; ++frame) solver.frame();
    std::printf("%s %s %016llx\n", entry.name.c_str(), precision,
                static_cast<unsigned long long>(solver.hash()));
}

}  // namespace

int main() {
    for (const plait::SceneEntry& entry : plait::scenes()) {
        print<float>(entry, "float");
        print<double>(entry, "double");
    }
}
