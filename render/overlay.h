// Numbers by vertex, shown as colours over the shape.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace plait {

// heat: Ink over Vermilion to Ivory; diverging: Teal, Ivory, Vermilion, for values with a sign;
// categories: whole numbers, the chart colours in turn.
enum class Palette { heat, diverging, categories };

struct Overlay {
    std::vector<float> values;  // by vertex of the world
    float low = 0, high = 1;    // the ends of the palette; not used by categories
    Palette palette = Palette::heat;
};

// Linear colour of a value, as the overlay draws it and as its legend shows it. Values beyond the
// ends take the colour of the end.
glm::vec3 overlayColor(const Overlay& overlay, float value);

// The colours between which a palette is interpolated linearly, evenly spaced.
std::span<const glm::vec3> paletteColors(Palette palette);

}  // namespace plait
