// What contacts of pieces bear under given settings.
#pragma once

#include "../../schedule.h"

namespace plait {

struct World;

// Notes one line in the world's warnings if the heaviest piece that yields has more times the mass
// of the lightest than contacts are evaluated in 1/24 s. A heavy box on a light one drifts by 2 %
// of its side in 10 s at about that: measured at 240 substeps a second with 2 to 32 evaluations
// each, at 960 with 2 to 32 (120 : 1 to 1200 : 1). `timeScale` as in SolverOptions.
void warnOfMassRatio(World& world, const ScheduleOptions& schedule, double timeScale = 1);

}  // namespace plait
