// Lines of text in a picture.
#pragma once

#include "paint.h"

#include <string_view>

namespace plait {

enum class Weight { regular, semibold };

struct TextStyle {
    Weight weight = Weight::regular;
    double size = 18;  // pixels of the em
    Color color = ivory;
    double alpha = 1;
    bool tabular = false;  // every digit as wide as the widest
};

// Inter, or DejaVu Sans where it is missing, from the usual folders of fonts. Text is UTF-8. All
// throw std::runtime_error where neither is installed.

// Pixels.
double textWidth(std::string_view text, const TextStyle& style);
// Of an H above the baseline, pixels.
double capHeight(const TextStyle& style);

// Kerned, at fractions of a pixel; what lies outside of the picture is left out.
void drawText(Picture& picture, double x, double baseline, std::string_view text,
              const TextStyle& style);

}  // namespace plait
