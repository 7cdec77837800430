#include "drawing.h"

#include "render/charts/chart.h"  // escaped

#include <algorithm>

namespace plait {
namespace {

constexpr int nameWidth = 210, rowHeight = 30, top = 58, markWidth = 12, groupGap = 14;

std::string numberOf(int value) { return std::to_string(value); }

std::string svgText(int x, int y, const std::string& words, const std::string& kind,
                    const std::string& anchor = "start") {
    return "<text class=\"" + kind + "\" x=\"" + numberOf(x) + "\" y=\"" + numberOf(y) +
           "\" text-anchor=\"" + anchor + "\">" + escaped(words) + "</text>\n";
}

std::string svgRectangle(int x, int y, int width, int height, const std::string& kind) {
    return "<rect class=\"" + kind + "\" x=\"" + numberOf(x) + "\" y=\"" + numberOf(y) +
           "\" width=\"" + numberOf(width) + "\" height=\"" + numberOf(height) +
           "\" rx=\"2\"></rect>\n";
}

// Where columns stand.
struct Places {
    std::vector<int> x;       // of each column
    std::vector<int> starts;  // of each substep
    int right = 0;
};

Places placesOf(const SceneFacts& facts) {
    const int count = static_cast<int>(facts.columns.size());
    const int pitch = std::clamp(count > 0 ? 880 / count : 90, 20, 90);
    Places places;
    int x = nameWidth, substep = -1;
    for (const ColumnFacts& column : facts.columns) {
        if (column.substep != substep) {
            if (substep >= 0) x += groupGap;
            substep = column.substep;
            places.starts.push_back(x);
        }
        places.x.push_back(x + (pitch - markWidth) / 2);
        x += pitch;
    }
    places.right = x;
    return places;
}

std::string rowsOf(const SceneFacts& facts, const std::vector<std::string>& links,
                   const Places& places) {
    std::string svg;
    for (std::size_t s = 0; s < facts.sets.size(); ++s) {
        const SetFacts& set = facts.sets[s];
        const int y = top + rowHeight * static_cast<int>(s);
        svg += R"(<path class="rule" d="M0 )" + numberOf(y + rowHeight) + "H" +
               numberOf(places.right) + "\"></path>\n";
        const std::string name = svgText(0, y + 20, set.name, "set");
        svg += links[s].empty() ? name : "<a href=\"" + escaped(links[s]) + "\">" + name + "</a>\n";
        for (std::size_t c = 0; c < facts.columns.size(); ++c)
            svg += facts.columns[c].runs[s]
                       ? svgRectangle(places.x[c], y + 5, markWidth, rowHeight - 10,
                                      set.contact ? "mark contact" : "mark")
                       : svgRectangle(places.x[c] + 4, y + 13, 4, 4, "dot");
    }
    return svg;
}

// The substeps of a frame as ticks on a bar; those drawn above are filled.
std::string frameBar(const SceneFacts& facts, const Places& places, int y) {
    const int width = places.right - nameWidth, drawn = static_cast<int>(places.starts.size());
    std::string svg = svgText(0, y + 13, "one frame", "set");
    svg += svgRectangle(nameWidth, y, width, 16, "frame");
    svg += svgRectangle(nameWidth, y, std::max(3, width * drawn / facts.substeps), 16, "drawn");
    if (facts.substeps * 4 <= width)
        for (int n = 1; n < facts.substeps; ++n)
            svg += R"(<path class="tick" d="M)" + numberOf(nameWidth + width * n / facts.substeps) +
                   " " + numberOf(y) + "v16\"></path>\n";
    std::string words = numberOf(facts.substeps) + (facts.substeps == 1 ? " substep" : " substeps");
    if (drawn < facts.substeps)
        words += ", of which " + numberOf(drawn) + (drawn == 1 ? " is drawn" : " are drawn");
    return svg + svgText(nameWidth, y + 36, words, "note");
}

}  // namespace

std::string scheduleWords(const SceneFacts& facts) {
    const std::size_t columns =
        static_cast<std::size_t>(std::ranges::count(facts.columns, 0, &ColumnFacts::substep));
    std::string words =
        "Time runs from left to right, one column after the other; within a column "
        "from the top down";
    words += facts.palindrome ? ", and then exactly back up. " : ". ";
    words += "A substep has " + std::to_string(columns) + (columns == 1 ? " column" : " columns") +
             ", as many as its busiest set has evaluations. ";
    if (std::ranges::any_of(facts.sets, &SetFacts::contact))
        words += "Contacts stand last, in red: they have the last word. ";
    if (!facts.even)
        words +=
            "Substeps are not all alike: sets run as often as their importance "
            "says in the mean. ";
    if (!facts.interleaved)
        words += "Sets are not interleaved: one is done before the next begins. ";
    return words;
}

std::string scheduleDrawing(const SceneFacts& facts, const std::vector<std::string>& links) {
    const Places places = placesOf(facts);
    const int bottom = top + rowHeight * static_cast<int>(facts.sets.size()) + 22;
    const int width = std::max(places.right, nameWidth + 330), height = bottom + 44;
    std::string svg = R"(<svg class="schedule" width=")" + numberOf(width) + "\" height=\"" +
                      numberOf(height) + "\" viewBox=\"0 0 " + numberOf(width) + " " +
                      numberOf(height) + R"(" role="group" aria-label=")" +
                      escaped("Schedule of " + facts.entry->title) + "\">\n";
    svg += svgText(0, 44, facts.palindrome ? "down, then up ↓↑" : "down ↓", "note");
    svg += svgText(0, 18, "substep", "note");
    for (std::size_t g = 0; g < places.starts.size(); ++g) {
        svg += svgText(places.starts[g] + 2, 18, numberOf(static_cast<int>(g) + 1), "note");
        svg += R"(<path class="bracket" d="M)" + numberOf(places.starts[g]) + " 30v-5H" +
               numberOf(
                   (g + 1 < places.starts.size() ? places.starts[g + 1] - groupGap : places.right) -
                   2) +
               "v5\"></path>\n";
    }
    svg += rowsOf(facts, links, places) + frameBar(facts, places, bottom);
    return R"(<div class="wide" tabindex="0" role="region" aria-label="schedule, drawn">)" + svg +
           "</svg></div>\n";
}

}  // namespace plait
