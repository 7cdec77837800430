// A small chart in a corner of a picture: a curve, and a dot that moves along it.
#pragma once

#include "picture.h"
#include "render/charts/chart.h"
#include "render/charts/drawing.h"

#include <string>
#include <vector>

namespace plait {

struct InsetChart {
    std::string x, y;               // of the axes: "pressure [kPa]"
    std::vector<ChartPoint> curve;  // two points or more, which the axes are as long as
    std::vector<ChartPoint> trail;  // where the dot was; it is at the last. Not finite: not there
};

// In px of a picture 720 high, from the inset's own corner; what lies beyond the axes is cut off.
Drawing insetDrawing(const InsetChart& inset);

// In the upper right corner; the look book's pixels below its margin.
void drawInset(Picture& picture, const InsetChart& inset, double below = 0);

}  // namespace plait
