#include "map.h"

#include "demos/tools/errors.h"
#include "demos/tools/words.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace plait {
namespace {

constexpr double resolved = 1.01;  // ratio of the pair between which a boundary lies
constexpr double pulled = 1.05, beyond = 1.1;

double middle(const StabilityAxis& axis, double a, double b) {
    return axis.whole ? std::round((a + b) / 2) : std::sqrt(a * b);
}

bool close(const StabilityAxis& axis, double a, double b) {
    return axis.whole ? std::fabs(a - b) <= 1 : std::max(a / b, b / a) <= resolved;
}

std::string format(const char* pattern, const std::string& a, double b, double c, double d) {
    char line[200];
    std::snprintf(line, sizeof line, pattern, a.c_str(), b, c, d);
    return line;
}

}  // namespace

const std::vector<StabilityMap>& stabilityMaps() {
    static const std::vector<StabilityMap> all{
        stepStiffnessMap(), massRatioMap(),   stiffnessRatioMap(), chainLengthMap(),
        resolutionMap(),    rotationMap(),    bdf2SweepsMap(),     bulletMap(),
        layersMap(),        rodSegmentsMap(), stairsMap()};
    return all;
}

const StabilityMap& stabilityMapNamed(const std::string& name) {
    std::vector<std::string> names;
    for (const StabilityMap& map : stabilityMaps()) names.push_back(map.name);
    return stabilityMaps()[static_cast<std::size_t>(parseChoice("map", name, names))];
}

std::vector<double> valuesOf(const StabilityAxis& axis, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        double value = axis.low * std::pow(axis.high / axis.low, i / double(count - 1));
        if (axis.whole) value = std::round(value);
        if (values.empty() || value > values.back()) values.push_back(value);
    }
    return values;
}

Boundary traceBoundary(const StabilityMap& map, const StabilityPanel& panel, double x) {
    const auto good = [&](double y) { return panel.cell(x, y) < map.fails; };
    const bool goodBelow = map.goodAtLowY;
    double below = map.y.low;
    if (good(below) != goodBelow)
        return goodBelow ? Boundary{panel.name, x, {}} : Boundary{panel.name, x, below, true};
    while (below < map.y.high) {
        double above = std::min(2 * below, map.y.high);
        if (good(above) == goodBelow) {
            below = above;
            continue;
        }
        while (!close(map.y, below, above)) {
            const double y = middle(map.y, below, above);
            (good(y) == goodBelow ? below : above) = y;
        }
        return {panel.name, x, goodBelow ? below : above};
    }
    return goodBelow ? Boundary{panel.name, x, map.y.high, true} : Boundary{panel.name, x, {}};
}

std::string csvOf(const std::vector<Boundary>& boundaries) {
    std::string lines = "panel,x,y,open\n";
    for (const Boundary& b : boundaries)
        lines += b.panel + "," + text(b.x) + "," + (b.y ? text(*b.y) : "none") + "," +
                 (b.open ? "1" : "0") + "\n";
    return lines;
}

std::vector<Boundary> boundariesFrom(const std::string& csv, const std::string& name) {
    std::vector<Boundary> boundaries;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string panel, x, y, open;
        std::getline(words, panel, ',');
        std::getline(words, x, ',');
        std::getline(words, y, ',');
        if (!std::getline(words, open, ',')) throw FileError(name + ": no boundary in: " + line);
        Boundary boundary{panel, std::stod(x), {}, open == "1"};
        if (y != "none") boundary.y = std::stod(y);
        boundaries.push_back(boundary);
    }
    return boundaries;
}

std::vector<std::string> complaints(const StabilityMap& map, const std::vector<Boundary>& stored,
                                    const std::vector<Boundary>& found) {
    std::vector<std::string> lines;
    // How far out, as a ratio: what is good at high y counts downward.
    const auto reach = [&](double y) { return map.goodAtLowY ? y : 1 / y; };
    for (const Boundary& now : found) {
        const auto before = std::find_if(stored.begin(), stored.end(), [&](const Boundary& b) {
            return b.panel == now.panel && std::fabs(b.x / now.x - 1) < 1e-9;
        });
        // On a logarithmic axis 0 is nowhere.
        const double was = before == stored.end() ? 0 : before->y.value_or(0);
        const double is = now.y.value_or(0);
        if (before == stored.end())
            lines.push_back(format("%s at %g: no boundary is stored", now.panel, now.x, 0, 0));
        else if (was > 0 && (!(is > 0) || pulled * reach(is) < reach(was)))
            lines.push_back(format("%s at %g: pulled in from %g to %g", now.panel, now.x, was, is));
        const auto panel =
            std::find_if(map.panels.begin(), map.panels.end(),
                         [&](const StabilityPanel& p) { return p.name == now.panel; });
        if (!panel->mustFail || !(is > 0)) continue;
        const double theory = panel->theory(now.x);
        const bool within = theory * beyond < map.y.high && theory / beyond > map.y.low;
        if (within && reach(is) > beyond * reach(theory))
            lines.push_back(format("%s at %g: does not fail at %g where theory says %g", now.panel,
                                   now.x, is, theory));
    }
    return lines;
}

}  // namespace plait
