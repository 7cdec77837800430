// What the colours of an overlay mean.
#pragma once

#include "picture.h"
#include "render/overlay.h"

#include <string>

namespace plait {

struct Legend {
    std::string name;  // "stretch"
    std::string unit;  // "%"
    float low = 0, high = 1;
    Palette palette = Palette::heat;
};

// A colour bar with ticks at round numbers in the upper right corner; of categories, one swatch a
// colour with the first number that has it.
void drawLegend(Picture& picture, const Legend& legend);

}  // namespace plait
