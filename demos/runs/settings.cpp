#include "settings.h"

#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/words.h"

#include <plait/contacts/pieces/mass_ratio.h>
#include <plait/files/mesh_sequence.h>
#include <plait/measure/hash.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>

namespace plait {
namespace {

using Names = std::vector<std::string>;

constexpr double mostFrames = 1e6;  // of a run

struct Setting {
    SettingOption option;
    std::function<std::string(const Run&)> get;
    std::function<void(Run&, const std::string&)> set;
};

// A setting that is one of some words, in the order of the enumerators.
template <class Place>
Setting choice(const std::string& name, const Names& words, const std::string& meaning,
               Place place) {
    std::string argument;
    for (const std::string& word : words) argument += (argument.empty() ? "" : "|") + word;
    return {{name, argument, meaning},
            [=](const Run& run) { return words[static_cast<std::size_t>(place(run))]; },
            [=](Run& run, const std::string& word) {
                auto& value = place(run);
                value = static_cast<std::remove_reference_t<decltype(value)>>(
                    parseChoice("--" + name, word, words));
            }};
}

template <class Place>
Setting count(const std::string& name, long low, const std::string& meaning, Place place) {
    return {{name, "N", meaning},
            [=](const Run& run) { return std::to_string(place(run)); },
            [=](Run& run, const std::string& word) {
                auto& value = place(run);
                value = static_cast<std::remove_reference_t<decltype(value)>>(
                    parseInteger("--" + name, word, low, 1000000));
            }};
}

std::string frameRateText(const Run& run) {
    const FrameRate rate = run.scene.options.schedule.frameRate;
    return std::to_string(rate.frames) +
           (rate.seconds == 1 ? "" : "/" + std::to_string(rate.seconds));
}

void setFrameRate(Run& run, const std::string& word) {
    ScheduleOptions& schedule = run.scene.options.schedule;
    const std::size_t slash = word.find('/');
    const std::string frames = word.substr(0, slash);
    const std::string seconds = slash == std::string::npos ? "1" : word.substr(slash + 1);
    const std::string what = "--fps N or N/M (29.97 is 30000/1001, 23.976 is 24000/1001)";
    const double before = run.frameRate();
    schedule.frameRate = {static_cast<int>(parseInteger(what, frames, 1, 1000000)),
                          static_cast<int>(parseInteger(what, seconds, 1, 1000000))};
    const double substeps = std::round(schedule.substeps * before / run.frameRate());
    schedule.substeps = static_cast<int>(std::clamp(substeps, 1.0, 1e6));
}

// Methods of springs have integrators of their own, which take the place of the scene's.
Setting methodSetting() {
    Setting setting = choice("method",
                             {"xpbd", "nucleus", "explicit", "symplectic", "implicit", "linearised",
                              "block", "global", "newton"},
                             "how constraints are solved",
                             [](auto& run) -> auto& { return run.scene.options.method; });
    setting.set = [set = setting.set](Run& run, const std::string& word) {
        set(run, word);
        SolverOptions& options = run.scene.options;
        if (options.method == Method::explicitEuler || options.method == Method::symplectic ||
            options.method == Method::implicit)
            options.integrator = Integrator::first;
    };
    return setting;
}

// "stretch=48,contacts=24", of the sets that are evaluated by it.
std::string importanceText(const Run& run) {
    const ScheduleOptions& schedule = run.scene.options.schedule;
    std::string words;
    for (const World::Set& set : run.scene.world.sets)
        if ((set.contact ? schedule.collisionPasses : schedule.iterations) == 0 &&
            set.options.secondaryInterval == 0)
            words += (words.empty() ? "" : ",") + set.options.name + "=" +
                     std::to_string(set.options.importance);
    return words;
}

// Of two sets of one name the first comes first.
void setImportance(Run& run, const std::string& words) {
    std::map<std::string, std::size_t> next;  // by name: where to seek
    std::vector<World::Set>& sets = run.scene.world.sets;
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find(',', begin), words.size());
        const std::string word = words.substr(begin, end - begin);
        begin = end + 1;
        const std::size_t equals = word.rfind('=');
        const std::string name = word.substr(0, equals);
        std::size_t& place = next[name];
        while (place < sets.size() && sets[place].options.name != name) ++place;
        if (equals == std::string::npos || place == sets.size())
            throw UsageError("--importance SET=N,..., with a set of " + run.entry->name + ", not " +
                             word);
        sets[place++].options.importance = static_cast<int>(
            parseInteger("--importance " + name, word.substr(equals + 1), 1, 1000000));
    }
}

void leaveOut(Run& run, const std::string& words) {
    World& world = run.scene.world;
    const Names names = partsOf(run);
    const std::size_t sets = world.sets.size();
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find(',', begin), words.size());
        const std::string name = words.substr(begin, end - begin);
        begin = end + 1;
        parseChoice("--without", name, names);
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (names[i] != name) continue;
            if (i < sets)
                world.sets[i].recipe = {};
            else
                world.forces[i - sets] = {};
        }
    }
    world.sweepOut();
    run.without = words;
}

constexpr const char* withoutName = "without";

// In the order in which they are applied: what is left out first, frame rate before substeps,
// method before integrator.
const std::vector<Setting>& table() {
    static const std::vector<Setting> all = {
        {{withoutName, "NAME,...", "leaves out sets and forces: `describe` names them"},
         [](const Run& run) { return run.without; },
         leaveOut},
        {{"fps", "N|N/M", "frames in a second"}, frameRateText, setFrameRate},
        {{"seconds", "S", "playing time"},
         [](const Run& run) { return text(run.scene.seconds); },
         [](Run& run, const std::string& word) {
             run.scene.seconds = parseNumber("--seconds", word, 0.001, 3600);
         }},
        methodSetting(),
        choice("integrator", {"first", "bdf2", "midpoint"}, "order of the velocity rule",
               [](auto& run) -> auto& { return run.scene.options.integrator; }),
        choice("direction", {"palindrome", "one-way", "alternating"}, "of the sweeps of a column",
               [](auto& run) -> auto& { return run.scene.options.sweeps; }),
        choice("schedule", {"interleaved", "sequential"}, "order of the sets of constraints",
               [](auto& run) -> auto& { return run.scene.options.schedule.mode; }),
        count("substeps", 1, "in a frame",
              [](auto& run) -> auto& { return run.scene.options.schedule.substeps; }),
        count("iterations", 0, "in a substep, of every set but contacts; 0: by importance",
              [](auto& run) -> auto& { return run.scene.options.schedule.iterations; }),
        count("passes", 0, "in a substep, of contacts; 0: by importance",
              [](auto& run) -> auto& { return run.scene.options.schedule.collisionPasses; }),
        {{"importance", "SET=N,...", "evaluations of sets in 1/24 s, where no count is given"},
         importanceText,
         setImportance},
        {{"chebyshev", "RHO", "mixes iterations, for rates up to this, below 1; 0: off"},
         [](const Run& run) { return text(run.scene.options.chebyshev); },
         [](Run& run, const std::string& word) {
             run.scene.options.chebyshev = parseNumber("--chebyshev", word, 0, 0.999);
         }},
        choice("precision", {"float", "double"}, "of the state",
               [](auto& run) -> auto& { return run.precision; }),
    };
    return all;
}

constexpr const char *knobPrefix = "knob.", *contentPrefix = "content.";

// The same words for the same file, whatever folder they are said in.
std::string foundAnywhere(const std::filesystem::path& file) {
    const std::filesystem::path from = std::filesystem::absolute(file);
    return std::filesystem::weakly_canonical(from.parent_path()) / from.filename();
}

void setKnob(Knobs& knobs, const SceneEntry& entry, const std::string& name,
             const std::string& value) {
    Names names;
    for (const Knob& knob : entry.knobs) names.push_back(knob.name);
    const Knob& knob =
        entry.knobs[static_cast<std::size_t>(parseChoice("knob of " + entry.name, name, names))];
    const std::string what = "--set " + name;
    if (knob.isNumber())
        knobs.numbers[name] = parseNumber(what, value, knob.low, knob.high);
    else if (!knob.choices.empty())
        knobs.texts[name] =
            knob.choices[static_cast<std::size_t>(parseChoice(what, value, knob.choices))];
    else
        knobs.texts[name] = value.empty() ? "" : foundAnywhere(value);
}

const std::string* find(const Settings& settings, const std::string& name) {
    const auto found = std::find_if(settings.begin(), settings.end(),
                                    [&](const auto& setting) { return setting.first == name; });
    return found == settings.end() ? nullptr : &found->second;
}

Knobs makeKnobs(const SceneEntry& entry, const Settings& settings) {
    const std::string* quality = find(settings, "quality");
    Knobs knobs = Knobs::defaults(
        entry.knobs, static_cast<Quality>(
                         parseChoice("--quality", quality ? *quality : "preview", qualityNames())));
    if (const std::string* seed = find(settings, "seed"))
        knobs.seed = static_cast<std::uint64_t>(parseInteger("--seed", *seed, 0, 1000000000));
    const std::string prefix = knobPrefix;
    for (const auto& [name, value] : settings)
        if (name.starts_with(prefix)) setKnob(knobs, entry, name.substr(prefix.size()), value);
    return knobs;
}

std::map<std::string, std::string> contentsOf(const Run& run) {
    std::map<std::string, std::string> contents;
    for (const Knob& knob : run.entry->knobs) {
        if (!knob.isFile()) continue;
        char word[20] = "";
        if (const std::string& file = run.knobs.text(knob.name); !file.empty()) {
            std::uint64_t hash = hashSeed;
            forContents(file, [&](std::string_view bytes) { hash = hashOf(bytes, hash); });
            std::snprintf(word, sizeof word, "%016llx", static_cast<unsigned long long>(hash));
        }
        contents[knob.name] = word;
    }
    return contents;
}

// The scene of what its files were when `settings` were written down, if they were.
Scene buildScene(Run& run, const Settings& settings) {
    const EndsAtOnce building;
    try {
        run.contents = contentsOf(run);
        for (const auto& [name, content] : run.contents) {
            const std::string* before = find(settings, contentPrefix + name);
            if (before && *before != content)
                throw FileError(run.knobs.text(name) + ": has changed since the run began (" +
                                name + "); plait run --force makes it anew");
        }
        Scene scene = run.entry->build(run.knobs);
        if (contentsOf(run) != run.contents)
            throw FileError(run.entry->name + ": a file changed while it was read");
        return scene;
    } catch (const FileError&) {
        throw;
    } catch (const MeshFileError& error) {
        throw FileError(error.what());
    } catch (const std::exception& error) {
        throw SceneError(run.entry->name + " cannot be built: " + error.what());
    }
}

}  // namespace

std::vector<std::string> partsOf(const Run& run) {
    const World& world = run.scene.world;
    Names names;
    for (const World::Set& set : world.sets) names.push_back(set.options.name);
    for (const Recipe<Force>& force : world.forces)
        names.push_back(force.make<double>(world, run.scene.options.kernels)->name());
    return names;
}

int Run::frames() const {
    return std::max(1, static_cast<int>(std::lround(scene.seconds * frameRate())));
}

double Run::frameRate() const {
    const FrameRate rate = scene.options.schedule.frameRate;
    return double(rate.frames) / rate.seconds;
}

const std::vector<SettingOption>& settingOptions() {
    static const std::vector<SettingOption> all = [] {
        std::vector<SettingOption> options;
        for (const Setting& setting : table()) options.push_back(setting.option);
        options.push_back({"seed", "N", "of whatever is random"});
        return options;
    }();
    return all;
}

Run makeRun(const Settings& settings) {
    const std::string* scene = find(settings, "scene");
    if (!scene) throw UsageError("no scene is named");
    Run run;
    run.entry = &sceneNamed(*scene);
    run.knobs = makeKnobs(*run.entry, settings);
    run.scene = buildScene(run, settings);
    if (run.knobs.quality == Quality::draft) run.scene.seconds = std::min(run.scene.seconds, 4.0);
    for (const Setting& setting : table())
        if (const std::string* value = find(settings, setting.option.name))
            setting.set(run, *value);
    if (const double frames = run.scene.seconds * run.frameRate(); frames > mostFrames)
        throw UsageError("--seconds and --fps: " + text(std::ceil(frames)) +
                         " frames are more than " + text(mostFrames));
    const SolverOptions& options = run.scene.options;
    warnOfMassRatio(run.scene.world, options.schedule, options.timeScale);
    return run;
}

Settings settingsOf(const Run& run) {
    Settings settings{{"scene", run.entry->name},
                      {"quality", qualityNames()[static_cast<std::size_t>(run.knobs.quality)]},
                      {"seed", std::to_string(run.knobs.seed)}};
    for (const Knob& knob : run.entry->knobs)
        settings.emplace_back(knobPrefix + knob.name, knob.isNumber()
                                                          ? text(run.knobs.number(knob.name))
                                                          : run.knobs.text(knob.name));
    for (const auto& [name, content] : run.contents)
        settings.emplace_back(contentPrefix + name, content);
    for (const Setting& setting : table())
        if (setting.option.name != withoutName || !run.without.empty())
            settings.emplace_back(setting.option.name, setting.get(run));
    return settings;
}

std::string valueOf(const Settings& settings, const std::string& name) {
    const std::string* value = find(settings, name);
    return value ? *value : "";
}

std::string textOf(const Settings& settings) {
    std::string lines;
    for (const auto& [name, value] : settings)
        if (!value.empty() || !name.starts_with(contentPrefix)) lines += name + "=" + value + "\n";
    return lines;
}

Settings settingsFrom(const std::string& text) {
    Settings settings;
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
        const std::string line = text.substr(begin, end - begin);
        const std::size_t equals = line.find('=');
        if (equals == std::string::npos) throw FileError("not a setting: " + line);
        settings.emplace_back(line.substr(0, equals), line.substr(equals + 1));
    }
    return settings;
}

const SceneEntry& sceneNamed(const std::string& name) {
    Names names;
    for (const SceneEntry& entry : scenes()) names.push_back(entry.name);
    return scenes()[static_cast<std::size_t>(parseChoice("scene", name, names))];
}

const std::vector<std::string>& qualityNames() {
    static const Names names{"draft", "preview", "final"};
    return names;
}

}  // namespace plait
