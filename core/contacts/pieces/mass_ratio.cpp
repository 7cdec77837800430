#include "mass_ratio.h"

#include "../../world.h"

#include <algorithm>
#include <cstdio>

namespace plait {

void warnOfMassRatio(World& world, const ScheduleOptions& schedule, double timeScale) {
    double light = infinity, heavy = 0, evaluations = 0;
    for (const Range& piece : world.pieces) {
        double mass = 0;
        bool yields = true;
        for (int v = piece.first; v < piece.last; ++v) {
            mass += world.mass[v];
            yields = yields && !world.pinned[v];
        }
        if (!yields) continue;
        light = std::min(light, mass);
        heavy = std::max(heavy, mass);
    }
    for (const World::Set& set : world.sets)
        if (set.contact) evaluations = std::max(evaluations, double(set.options.importance));
    if (evaluations == 0) return;
    if (schedule.collisionPasses > 0)
        evaluations = double(schedule.collisionPasses) * schedule.substeps *
                      schedule.frameRate.frames / (24.0 * schedule.frameRate.seconds);
    evaluations /= timeScale;
    if (heavy <= evaluations * light) return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "pieces differ in mass by %.3g : 1; contacts evaluated %.3g times in 1/24 s hold "
                  "up to %.3g : 1",
                  heavy / light, evaluations, evaluations);
    world.warnings.push_back(text);
}

}  // namespace plait
