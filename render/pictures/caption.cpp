#include "caption.h"

#include "text.h"

#include <algorithm>
#include <cmath>

namespace plait {

void drawCaption(Picture& picture, const Caption& caption) {
    const double unit = picture.height / 720.0, fade = std::clamp(caption.fade, 0.0, 1.0);
    const int height = static_cast<int>(std::lround(64 * unit));
    const int rule = std::max(1, static_cast<int>(std::lround(2 * unit)));
    const int top = picture.height - height;
    paintRectangle(picture, 0, top, picture.width, height, ink, 0.72 * fade);
    paintRectangle(picture, 0, top, picture.width, rule, vermilion, fade);

    TextStyle title{Weight::semibold, 24 * unit, ivory, fade};
    TextStyle numbers{Weight::regular, 18 * unit, steel, fade, true};
    const double margin = 40 * unit, gap = caption.title.empty() ? 0 : 32 * unit;
    const double length = textWidth(caption.title, title) + textWidth(caption.numbers, numbers);
    const double fit = std::min(1.0, (picture.width - 2 * margin - gap) / std::max(length, 1.0));
    title.size *= fit;
    numbers.size *= fit;
    const double baseline = picture.height - std::round((height - rule - capHeight(title)) / 2);
    drawText(picture, margin, baseline, caption.title, title);
    drawText(picture, picture.width - margin - textWidth(caption.numbers, numbers), baseline,
             caption.numbers, numbers);
}

}  // namespace plait
