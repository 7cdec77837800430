#include "contact_sheet.h"

#include "text.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

namespace plait {
namespace {

// Four of pictures of 16:9; of others about as many as give twelve a sheet of the same shape.
int columnsFor(const Picture& picture) {
    constexpr std::array divisors{1, 2, 3, 4, 6, 12};
    const double square = 16 * (16.0 / 9) * picture.height / picture.width;
    std::size_t i = 0;
    while (i + 1 < divisors.size() && divisors[i] * divisors[i + 1] <= square) ++i;
    return divisors[i];
}

}  // namespace

std::vector<int> sheetFrames(int frames, int count) {
    const int n = std::min(frames, count);
    std::vector<int> result;
    for (int i = 0; i < n; ++i)
        result.push_back(n == 1 ? 0 : (2 * i * (frames - 1) + n - 1) / (2 * (n - 1)));
    return result;
}

Picture contactSheet(std::span<const SheetFrame> frames, const std::string& title, int width) {
    if (frames.empty()) throw std::invalid_argument("a contact sheet without frames");
    const double unit = width / 1920.0;
    const auto px = [&](double v) { return static_cast<int>(v * unit); };
    const int margin = px(40), gap = px(16), head = px(92), foot = px(44);
    const Picture& first = frames[0].picture;
    const int columns = columnsFor(first);
    const int cell = (width - 2 * margin - (columns - 1) * gap) / columns;
    // Pictures that are taller than a cell and one more are drawn smaller, or a sheet had no end.
    const int highest = 2 * cell;
    int wide = cell, height = std::max(1, cell * first.height / first.width);
    if (height > highest) {
        wide = std::max(1, highest * first.width / first.height);
        height = highest;
    }
    const int rows = (static_cast<int>(frames.size()) + columns - 1) / columns;
    Picture sheet = filled(width, head + rows * (height + foot) + px(12), ink);

    drawText(sheet, margin, px(56), title, {Weight::semibold, 32 * unit, ivory});
    paintRectangle(sheet, margin, px(74), width - 2 * margin, std::max(1, px(2)), vermilion);
    const TextStyle style{Weight::regular, 20 * unit, steel, 1, true};
    for (int i = 0; i < static_cast<int>(frames.size()); ++i) {
        const int x = margin + i % columns * (cell + gap);
        const int y = head + i / columns * (height + foot);
        paintPicture(sheet, x, y, scaled(frames[i].picture, wide, height));
        char time[32];
        std::snprintf(time, sizeof time, "%.2f s", frames[i].time);
        drawText(sheet, x, y + height + px(27), time, style);
    }
    return sheet;
}

}  // namespace plait
