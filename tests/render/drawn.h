// Charts as the tests see them: what is drawn, and where.
#pragma once

#include "render/charts/chart.h"
#include "render/charts/drawing.h"
#include "render/charts/parts.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace plait::test {

// What of one sort a drawing has.
template <class Item>
std::vector<Item> every(const Drawing& drawing) {
    std::vector<Item> result;
    for (const auto& item : drawing.items)
        if (const Item* found = std::get_if<Item>(&item)) result.push_back(*found);
    return result;
}

inline Word wordOf(const Drawing& drawing, const std::string& text) {
    for (const Word& word : every<Word>(drawing))
        if (word.text == text) return word;
    throw std::runtime_error("no word " + text);
}

// Where the number is on the page, from the places of the ticks `low` and `high` alone.
inline double across(const Drawing& drawing, const std::string& low, const std::string& high,
                     double s) {
    const PageBox a = boxOf(wordOf(drawing, low)), b = boxOf(wordOf(drawing, high));
    return (1 - s) * (a.left + a.right) / 2 + s * (b.left + b.right) / 2;
}

inline double up(const Drawing& drawing, const std::string& low, const std::string& high,
                 double s) {
    const Word a = wordOf(drawing, low), b = wordOf(drawing, high);
    return (1 - s) * a.baseline + s * b.baseline - capHeight(a.style) / 2;
}

inline const Axis anyX{.label = "x [s]"}, anyY{.label = "y [m]"},
    workAxis{"work [ms]", true, {}, {}}, errorAxis{"error [m]", true, {}, {}};

inline Figure figureOf(Chart chart) { return {.title = "T", .charts = {std::move(chart)}}; }

inline bool same(Color a, Color b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

inline Color pixel(const Picture& picture, double x, double y) {
    const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(x));
    return {picture.rgb[at], picture.rgb[at + 1], picture.rgb[at + 2]};
}

}  // namespace plait::test
