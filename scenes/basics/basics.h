// Small scenes with one lesson each, for teaching, tests and charts.
#pragma once

#include "../scene.h"

namespace plait {

Scene band(const Knobs&);
Scene bullet(const Knobs&);
Scene cantilever(const Knobs&);
Scene coil(const Knobs&);
Scene elbow(const Knobs&);
Scene handkerchief(const Knobs&);
Scene hangingChain(const Knobs&);
Scene hangingSheet(const Knobs&);
Scene layeredSheets(const Knobs&);
Scene medley(const Knobs&);
Scene pendulum(const Knobs&);
Scene pile(const Knobs&);
Scene stacks(const Knobs&);
Scene swatches(const Knobs&);
Scene sampler(const Knobs&);
Scene sheetOnSphere(const Knobs&);
Scene softPins(const Knobs&);
Scene stripInWind(const Knobs&);
Scene tablecloth(const Knobs&);
Scene trampoline(const Knobs&);
Scene unitSpring(const Knobs&);
Scene windGauge(const Knobs&);

}  // namespace plait
