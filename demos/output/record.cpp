#include "record.h"

#include "demos/tools/json.h"
#include "demos/tools/machine.h"
#include "demos/tools/words.h"

#include <Eigen/Core>

#include <charconv>
#include <cstdio>

namespace plait {
namespace {

void addVersions(JsonWriter& json) {
    json.beginObject("versions").field("plait", PLAIT_VERSION).field("compiler", PLAIT_COMPILER);
    json.field("eigen", std::to_string(EIGEN_WORLD_VERSION) + "." +
                            std::to_string(EIGEN_MAJOR_VERSION) + "." +
                            std::to_string(EIGEN_MINOR_VERSION));
    json.end();
}

// A number as a number, other words as text.
void addWord(JsonWriter& json, const std::string& key, const std::string& word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc{} && end == word.data() + word.size())
        json.field(key, value);
    else
        json.field(key, word);
}

void addSettings(JsonWriter& json, const Run& run) {
    const std::string prefix = "knob.";
    const Settings settings = settingsOf(run);
    for (const bool knobs : {true, false}) {
        json.beginObject(knobs ? "knobs" : "settings");
        for (const auto& [name, value] : settings) {
            const bool isKnob = name.starts_with(prefix);
            const bool elsewhere =
                name == "scene" || name == "quality" || name.starts_with("content.");
            if (isKnob == knobs && !elsewhere)
                addWord(json, isKnob ? name.substr(prefix.size()) : name, value);
        }
        json.end();
    }
    json.beginObject("contents");
    for (const auto& [name, content] : run.contents) json.field(name, content);
    json.end();
}

void addMachine(JsonWriter& json, int threads) {
    const Machine machine = thisMachine();
    json.beginObject("machine")
        .field("processor", machine.processor)
        .field("cores", machine.cores)
        .field("threads", threads)
        .field("memory[B]", machine.memory)
        .field("system", machine.system)
        .field("kernels", machine.kernels)
        .field("lanes", machine.lanes)
        .end();
}

void addMetrics(JsonWriter& json, const Record& record) {
    json.beginObject("metrics");
    const std::vector<Metric>& metrics = record.run.scene.metrics;
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        const Verdict verdict = verdictOn(metrics[i], i, record.rows);
        json.beginObject(metrics[i].name)
            .field("unit", metrics[i].unit)
            .field("least", verdict.least)
            .field("most", verdict.most)
            .field("low", metrics[i].low)
            .field("high", metrics[i].high)
            .field("from[s]", metrics[i].from)
            .field("ok", verdict.firstOutside < 0)
            .end();
    }
    json.end();
}

void addPictures(JsonWriter& json, const Record& record) {
    if (!record.pictures) return;
    const PictureOptions& pictures = *record.pictures;
    json.beginObject("pictures")
        .field("width", pictures.width)
        .field("height", pictures.height)
        .field("first", pictures.first)
        .field("last", pictures.last)
        .field("overlay", pictures.overlay)
        .field("subframes", pictures.subframes)
        .field("caption", pictures.caption)
        .field("library", record.glLibrary)
        .field("renderer", record.glRenderer)
        .end();
}

}  // namespace

std::string jsonOf(const Record& record) {
    const Run& run = record.run;
    const SimplicialComplex& complex = run.scene.world.complex;
    JsonWriter json;
    addVersions(json);
    json.field("scene", run.entry->name)
        .field("quality", qualityNames()[static_cast<std::size_t>(run.knobs.quality)])
        .field("ending", record.ending);
    addSettings(json, run);
    json.beginObject("size")
        .field("vertices", complex.count(0))
        .field("edges", complex.count(1))
        .field("triangles", complex.count(2))
        .field("tetrahedra", complex.count(3))
        .field("stateAVertex[B]", static_cast<double>(record.stateBytes) / complex.count(0))
        .end();
    const int last = record.rows.empty() ? 0 : record.rows.back().frame;
    json.beginObject("frames")
        .field("asked", run.frames())
        .field("simulated", last)
        .field("resumedAt", record.resumedAt)
        .end();
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(record.hash));
    json.field("hash", hash);
    json.beginObject("work")
        .field("evaluations", record.rows.empty() ? 0 : record.rows.back().evaluations)
        .end();
    json.beginObject("seconds");
    for (const auto& [stage, seconds] : record.stages) json.field(stage, seconds);
    json.field("total", record.seconds).end();
    json.field("peakMemory[B]", peakMemory());
    addMachine(json, record.threads);
    addPictures(json, record);
    addMetrics(json, record);
    return json.finish();
}

}  // namespace plait
