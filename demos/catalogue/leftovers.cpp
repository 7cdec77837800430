#include "leftovers.h"

#include "demos/runs/run_folder.h"
#include "demos/stability/atlas.h"
#include "demos/tools/errors.h"
#include "demos/tools/files.h"

#include <algorithm>

namespace plait {
namespace {

namespace fs = std::filesystem;

const CurveStyle storedBoundary{0, Marker::disc, Dash::solid};

// What of a map is known without its cells: boundaries, and theory's.
Figure boundaryFigure(const StabilityMap& map, const std::vector<Boundary>& boundaries) {
    Figure figure = emptyFigure(map);
    for (const StabilityPanel& panel : map.panels) {
        Chart chart{
            .title = panel.name,
            .x = {.label = map.x.label, .logarithmic = true, .low = map.x.low, .high = map.x.high},
            .y = {.label = map.y.label, .logarithmic = true, .low = map.y.low, .high = map.y.high}};
        Curve found{.name = map.goodAtLowY ? "holds up to here" : "holds from here on",
                    .style = storedBoundary};
        for (const Boundary& boundary : boundaries)
            if (boundary.panel == panel.name && boundary.y && *boundary.y > 0)
                found.points.push_back({boundary.x, *boundary.y});
        if (!found.points.empty()) chart.curves.push_back(found);
        Curve theory{.name = "theory", .style = theoryStyle};
        if (panel.theory)
            for (const double x : valuesOf(map.x, 25))
                if (const double y = panel.theory(x); y > map.y.low / 30 && y < map.y.high * 30)
                    theory.points.push_back({x, y});
        if (!theory.points.empty()) chart.curves.push_back(theory);
        if (!chart.curves.empty()) figure.charts.push_back(chart);
    }
    return figure;
}

}  // namespace

std::string Leftovers::copied(const Path& from, const std::string& name) const {
    std::error_code none;
    if (!fs::is_regular_file(from, none)) return "";
    const Path to = site_ / "media" / name;
    makeFolder(to.parent_path());
    const auto made = fs::last_write_time(from);
    if (!fs::exists(to) || fs::last_write_time(to) < made ||
        fs::file_size(to) != fs::file_size(from))
        writeWhole(to, readWhole(from));
    return "media/" + name;
}

std::string Leftovers::clip(const std::string& scene) const {
    return copied(runs_ / scene / "clip.mp4", scene + ".mp4");
}

std::string Leftovers::middlePicture(const Path& run, const std::string& name) const {
    std::vector<Path> frames;
    if (fs::is_directory(run / "frames"))
        for (const auto& entry : fs::directory_iterator(run / "frames"))
            if (entry.path().extension() == ".png") frames.push_back(entry.path());
    if (frames.empty()) return "";
    std::ranges::sort(frames);
    return copied(frames[frames.size() / 2], name);
}

std::string Leftovers::picture(const std::string& scene) const {
    const std::string made = middlePicture(runs_ / scene, scene + ".png");
    return made.empty() ? copied(golden_ / "pictures" / scene / "state.png", scene + ".png") : made;
}

std::string Leftovers::knobClip(const std::string& scene, const std::string& knob,
                                const std::string& value) const {
    return copied(runs_ / "knobs" / scene / (knob + "=" + value) / "clip.mp4",
                  scene + "-" + knob + "-" + value + ".mp4");
}

std::string Leftovers::knobPicture(const std::string& scene, const std::string& knob,
                                   const std::string& value) const {
    return middlePicture(runs_ / "knobs" / scene / (knob + "=" + value),
                         scene + "-" + knob + "-" + value + ".png");
}

Settings Leftovers::settings(const std::string& scene) const {
    const Path file = runs_ / scene / "cache" / "settings.txt";
    return fs::exists(file) ? settingsFrom(readWhole(file)) : Settings{};
}

std::vector<MetricRow> Leftovers::measured(const std::string& scene,
                                           const std::vector<Metric>& metrics) const {
    const Path file = runs_ / scene / "metrics.csv";
    if (!fs::exists(file)) return {};
    try {
        return rowsFrom(readWhole(file), metrics, file.string());
    } catch (const FileError&) {
        return {};
    }
}

std::optional<Ledger> Leftovers::ledger(const std::string& scene) const {
    for (const Path& file :
         {runs_ / "ledger" / scene / "ledger.csv", golden_ / "ledger" / (scene + ".csv")})
        if (fs::exists(file)) try {
                return ledgerFrom(readWhole(file), file.string());
            } catch (const FileError&) {
                continue;  // of another version: the next one, or none
            }
    return {};
}

std::string Leftovers::ledgerChart(const std::string& scene) const {
    return copied(runs_ / "ledger" / scene / "chart.svg", "ledger-" + scene + ".svg");
}

std::string Leftovers::studyChart(const std::string& study) const {
    const std::string name = "study-" + study + ".svg";
    if (std::string chart = copied(runs_ / "study" / study / "chart.svg", name); !chart.empty())
        return chart;
    // Two are stored, for the README.
    const std::string stored = study == "pendulum"            ? "pendulum.svg"
                               : study == "hanging-sheet-128" ? "sheet.svg"
                                                              : "";
    return stored.empty() ? "" : copied(golden_ / "readme" / stored, name);
}

std::string Leftovers::mapChart(const StabilityMap& map) const {
    const std::string name = "map-" + map.name + ".svg";
    if (std::string chart = copied(runs_ / "stability" / map.name / "chart.svg", name);
        !chart.empty())
        return chart;
    const Path stored = golden_ / "stability" / (map.name + ".csv");
    if (!fs::exists(stored)) return "";
    const Figure figure = boundaryFigure(map, boundariesFrom(readWhole(stored), stored.string()));
    if (figure.charts.empty()) return "";
    makeFolder(site_ / "media");
    writeWhole(site_ / "media" / name, figureSvg(figure));
    return "media/" + name;
}

}  // namespace plait
