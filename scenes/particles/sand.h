// What scenes of grains have in common: sand on a rough table.
#pragma once

#include "../scene.h"

#include <plait/grains/grains.h>

namespace plait {

// kg, of a grain of this radius (m).
double sandMass(double radius);
// Slides at four fifths of the friction that holds it.
Grains sandOf(Range vertices, double radius, double friction);

// Gravity, grains that push each other, and the table at y = 0, which is as rough as sand glued to
// it; 30 substeps of 4 evaluations.
void addSand(Scene& scene, const Grains& sand);

// How many are there.
Metric countThere(const std::string& name, double low, double high);
// How many are in the table, deeper than half a radius.
Metric inTheTable(const Grains& sand);

}  // namespace plait
