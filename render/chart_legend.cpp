#include "chart_parts.h"

#include <algorithm>

namespace plait {
namespace {

constexpr double sampleWidth = 64, gap = 12;

TextStyle styleOf(double size) { return {Weight::regular, 18 * size, ink}; }

void addSample(Drawing& drawing, const LegendEntry& entry, double x, double y, double size) {
    const double end = x + sampleWidth * size;
    const Color color =
        entry.kind == LegendEntry::Kind::front ? frontColor : curveColor(entry.style.color);
    if (entry.kind == LegendEntry::Kind::category) {
        addRectangle(drawing, {x, y - 10, end, y + 10}, ink);
        addCells(drawing, {x + 1, y - 9, end - 1, y + 9}, entry.category);
        return;
    }
    if (entry.style.dash != Dash::none)
        drawing.items.emplace_back(Stroke{{{x, y}, {end, y}},
                                          false,
                                          color,
                                          entry.kind == LegendEntry::Kind::front ? 9.0 : 3.0,
                                          dashPattern(entry.style.dash)});
    addMarker(drawing, {(x + end) / 2, y}, entry.style, 6);
}

}  // namespace

std::vector<LegendEntry> legendEntries(std::span<const Chart> charts) {
    using Kind = LegendEntry::Kind;
    std::vector<LegendEntry> entries;
    const auto add = [&](const LegendEntry& entry) {
        const bool known = std::any_of(entries.begin(), entries.end(),
                                       [&](const LegendEntry& e) { return e.name == entry.name; });
        if (!known && !entry.name.empty()) entries.push_back(entry);
    };
    for (const Chart& chart : charts)
        if (chart.map)
            for (int i = 0; i < static_cast<int>(chart.map->categories.size()); ++i)
                add({Kind::category, chart.map->categories[static_cast<std::size_t>(i)], {}, i});
    for (const Chart& chart : charts)
        if (chart.map && std::count(chart.map->cells.begin(), chart.map->cells.end(), -1) > 0)
            add({Kind::category, "not measured", {}, -1});
    for (const Chart& chart : charts)
        for (const Curve& curve : chart.curves) add({Kind::curve, curve.name, curve.style});
    for (const Chart& chart : charts)
        if (!chart.front.empty())
            add({Kind::front, "Pareto front", {0, Marker::none, Dash::solid}});
    return entries;
}

double legendWidth(std::span<const LegendEntry> entries, double size) {
    double width = 0;
    for (const LegendEntry& entry : entries)
        width = std::max(width, textWidth(entry.name, styleOf(size)));
    return (sampleWidth + gap) * size + width;
}

// Rows draw together where there are too many.
void addLegend(Drawing& drawing, std::span<const LegendEntry> entries, const Box& box,
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
