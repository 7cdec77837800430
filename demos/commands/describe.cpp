#include "commands.h"
#include "demos/output/metric_table.h"
#include "demos/runs/settings.h"
#include "demos/tools/errors.h"
#include "demos/tools/words.h"

#include <cstdio>

namespace plait {
namespace {

void print(const char* heading, const std::vector<std::string>& lines) {
    std::printf("\n%s\n", heading);
    if (lines.empty()) std::printf("  none\n");
    for (const std::string& line : lines) std::printf("  %s\n", line.c_str());
}

std::string columns(const std::string& name, const std::string& value, const std::string& rest) {
    char line[512];
    std::snprintf(line, sizeof line, "%-18s %-26s %s", name.c_str(), value.c_str(), rest.c_str());
    return line;
}

std::string describe(const Knob& knob) {
    const std::string unit = knob.unit.empty() ? "" : " " + knob.unit;
    if (knob.isNumber())
        return columns(knob.name, text(knob.value) + unit,
                       text(knob.low) + " to " + text(knob.high) + unit + ": " + knob.meaning);
    const std::string value = knob.text.empty() ? "none" : knob.text;
    const std::string allowed = knob.isFile() ? "a file" : joined(knob.choices);
    return columns(knob.name, value, allowed + ": " + knob.meaning);
}

int describe(const Arguments& arguments) {
    const std::string quality = arguments.value("quality", "preview");
    const Run run = makeRun({{"scene", arguments.operands[0]}, {"quality", quality}});
    const SceneEntry& entry = *run.entry;
    std::printf("%s (%s)%s\n%s.\n", entry.title.c_str(), entry.name.c_str(),
                entry.demo ? ", a demo" : "", entry.lesson.c_str());
    print("Ingredients", entry.ingredients);
    print("Left out, and why", entry.omissions);

    if (!run.scene.facts.empty()) print("By closed forms", run.scene.facts);

    std::vector<std::string> knobs, metrics, settings;
    for (const Knob& knob : entry.knobs) knobs.push_back(describe(knob));
    print("Knobs: default, range (--set NAME=VALUE)", knobs);
    for (const Metric& metric : run.scene.metrics) {
        const std::string band = bandOf(metric);
        metrics.push_back(columns(metric.name, metric.unit, band.empty() ? "no band" : band));
    }
    print(("Metrics: unit, band in " + quality).c_str(), metrics);
    const Settings values = settingsOf(run);
    for (const SettingOption& option : settingOptions())
        for (const auto& [name, value] : values)
            if (name == option.name)
                settings.push_back(columns("--" + name, value, option.argument));
    print(("Options: value in " + quality).c_str(), settings);
    print("Sets and forces (--without NAME,...)", partsOf(run));
    print("Warnings", run.scene.world.warnings);
    const SimplicialComplex& complex = run.scene.world.complex;
    std::printf("\n%d vertices, %d edges, %d triangles in %s\n", complex.count(0), complex.count(1),
                complex.count(2), quality.c_str());
    return exitOk;
}

}  // namespace

Command describeCommand() {
    return {.name = "describe",
            .operands = {"SCENE"},
            .meaning = "lesson, ingredients, knobs, metrics and bands of a scene",
            .options = {{.name = "quality",
                         .argument = "draft|preview|final",
                         .meaning = "whose values are shown",
                         .letter = 'q'}},
            .examples = {"describe pendulum"},
            .run = describe};
}

}  // namespace plait
