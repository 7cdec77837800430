#include "caption.h"

#include "text.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace plait {
namespace {

constexpr double leastFit = 0.9;  // of its size, to which text may be set smaller in its line

// The parts between dots, in as few lines as the width (pixels) allows.
std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, double width) {
    const std::string dot = " · ";
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(dot, begin), text.size());
        const std::string part = text.substr(begin, end - begin);
        if (lines.empty() || textWidth(lines.back() + dot + part, style) > width)
            lines.push_back(part);
        else
            lines.back() += dot + part;
        begin = end + dot.size();
    }
    return lines;
}

}  // namespace

void drawCaption(Picture& picture, const Caption& caption) {
    const double unit = unitOf(picture), fade = std::clamp(caption.fade, 0.0, 1.0);
    TextStyle title{Weight::semibold, 24 * unit, ivory, fade};
    TextStyle numbers{Weight::regular, 18 * unit, steel, fade, true};
    const double margin = 40 * unit, gap = caption.title.empty() ? 0 : 32 * unit;
    const double room = picture.width - 2 * margin;
    const auto shrink = [](double width, double into) {
        return std::min(1.0, into / std::max(width, 1.0));
    };
    const double fit =
        shrink(textWidth(caption.title, title) + textWidth(caption.numbers, numbers), room - gap);
    std::vector<std::string> below;
    if (fit < leastFit) below = wrapped(caption.numbers, numbers, room);

    const double pitch = 28 * unit;
    const int line = static_cast<int>(std::lround(64 * unit)),
              height =
                  line + static_cast<int>(std::lround(pitch * static_cast<double>(below.size())));
    const int rule = std::max(1, static_cast<int>(std::lround(2 * unit)));
    const int top = picture.height - height;
    paintRectangle(picture, 0, top, picture.width, height, ink, 0.72 * fade);
    paintRectangle(picture, 0, top, picture.width, rule, vermilion, fade);

    title.size *= below.empty() ? fit : shrink(textWidth(caption.title, title), room);
    double baseline = top + line - std::round((line - rule - capHeight(title)) / 2);
    drawText(picture, margin, baseline, caption.title, title);
    if (below.empty()) {
        numbers.size *= fit;
        drawText(picture, picture.width - margin - textWidth(caption.numbers, numbers), baseline,
                 caption.numbers, numbers);
    }
    for (const std::string& text : below) {
        baseline += pitch;
        TextStyle style = numbers;
        style.size *= shrink(textWidth(text, numbers), room);
        drawText(picture, margin, baseline, text, style);
    }
}

void drawHeadline(Picture& picture, const std::string& words) {
    const double unit = unitOf(picture), margin = 40 * unit;
    TextStyle style{Weight::semibold, 32 * unit, ivory};
    style.size *=
        std::min(1.0, (picture.width - 2 * margin) / std::max(1.0, textWidth(words, style)));
    drawText(picture, margin, margin + capHeight(style), words, style);
}

}  // namespace plait
