#include "parts.h"

#include <algorithm>

namespace plait {
namespace {

constexpr double sampleWidth = 64, gap = 12;

TextStyle styleOf(double size) { return {Weight::regular, 18 * size, ink}; }

void addSample(Drawing& drawing, const LegendEntry& entry, double x, double y, double size) {
    const double end = x + sampleWidth * size;
    if (entry.area) {
        addRectangle(drawing, {x, y - 10, end, y + 10}, ink);
        return addRectangle(drawing, {x + 1, y - 9, end - 1, y + 9}, entry.color);
    }
    if (entry.style.dash != Dash::none)
        drawing.items.emplace_back(Stroke{
            {{x, y}, {end, y}}, false, entry.color, entry.width, dashPattern(entry.style.dash)});
    addMarker(drawing, {(x + end) / 2, y}, entry.style, 6);
}

}  // namespace

std::vector<LegendEntry> legendEntries(std::span<const Chart> charts) {
    std::vector<LegendEntry> entries;
    const auto add = [&](const LegendEntry& entry) {
        const bool known = std::any_of(entries.begin(), entries.end(),
                                       [&](const LegendEntry& e) { return e.name == entry.name; });
        if (!known && !entry.name.empty()) entries.push_back(entry);
    };
    for (const Chart& chart : charts)
        for (std::size_t i = 0; chart.map && i < chart.map->categories.size(); ++i)
            add({chart.map->categories[i], {}, categoryColor(static_cast<int>(i)), 0, true});
    for (const Chart& chart : charts)
        for (const Curve& curve : chart.curves)
            add({curve.name, curve.style, curveColor(curve.style.color)});
    for (const Chart& chart : charts)
        if (!chart.front.empty())
            add({"Pareto front", {0, Marker::none, Dash::solid}, frontColor, 9});
    return entries;
}

double legendWidth(std::span<const LegendEntry> entries, double size) {
    double width = 0;
    for (const LegendEntry& entry : entries)
        width = std::max(width, textWidth(entry.name, styleOf(size)));
    return (sampleWidth + gap) * size + width;
}

// Rows draw together where there are too many.
void addLegend(Drawing& drawing, std::span<const LegendEntry> entries, const PageBox& box,
               double size) {
    const auto count = static_cast<double>(std::max<std::size_t>(entries.size(), 1));
    const double step = std::min(legendPitch * size, (box.bottom - box.top) / count);
    TextStyle text = styleOf(size);
    text.size = std::min(text.size, 0.8 * step);
    double y = box.top + step / 2;
    for (const LegendEntry& entry : entries) {
        addSample(drawing, entry, box.left, y, size);
        addWord(drawing, box.left + (sampleWidth + gap) * size, y + capHeight(text) / 2, entry.name,
                text);
        y += step;
    }
}

}  // namespace plait
