// One line a scene and precision, "name precision hash": the state after some frames, which every
// compiler, level, lane width and number of threads must agree on (tests/run --long compares).
#include "scene.h"
#include "solver.h"

#include <algorithm>
#include <cstdio>

namespace {

template <class Real>
void print(const plait::SceneEntry& entry, const char* precision) {
    // Contact among matter is dear: its scenes are taken at draft, and not as far.
    plait::Scene scene = plait::build(entry, plait::Quality::draft);
    const bool dear = std::ranges::any_of(scene.world.sets, [](const plait::World::Set& set) {
        return set.options.name == "contacts";
    });
    if (!dear) scene = plait::build(entry);
    plait::Solver<Real> solver(scene.world, scene.options);
    for (int frame = 0; frame < (dear ? 6 : 24); ++frame) solver.frame();
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
