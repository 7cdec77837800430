// Everything that decides the state of a run, as words: options of the command line, lines of
// cache/settings.txt and keys of run.json are one table.
#pragma once

#include "scenes/scene.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace plait {

enum class Precision { single, full };

// A scene built with its knobs, its own options overruled by those given.
struct Run {
    const SceneEntry* entry = nullptr;
    Knobs knobs;
    // Of each knob that takes a file, a hash of all that is in what it names; "" where that is
    // none.
    std::map<std::string, std::string> contents;
    Scene scene;
    Precision precision = Precision::single;
    std::string without = {};  // names of sets and forces that are left out, commas between

    int frames() const;        // after frame 0, the start; at least 1
    double frameRate() const;  // frames in a second
};

// Names of the sets and forces that its world is made of, in that order.
std::vector<std::string> partsOf(const Run& run);

// Options that decide a state. Their values are those that `settingsOf` gives.
struct SettingOption {
    std::string name, argument, meaning;
};
const std::vector<SettingOption>& settingOptions();

// Name and value of each setting, scene, quality and knobs first.
using Settings = std::vector<std::pair<std::string, std::string>>;

// The run that these settings ask for; what is not named has the scene's own value. Settings may
// come in any order: "scene", "quality", "knob.NAME", "content.NAME" (Run::contents, of a run that
// was: its files must be the same) and the names of settingOptions().
//
// A new frame rate changes the substeps in a frame, unless they are given too, so that the length
// of a substep stays: it decides how often one looks, not what happens.
//
// Throws UsageError for unknown names and bad values, FileError for a mesh that cannot be read or
// has changed, SceneError for a scene that cannot be built.
Run makeRun(const Settings& settings);

// All settings of a run, in one fixed order: equal runs give equal text.
Settings settingsOf(const Run& run);

// "" for what is not among them.
std::string valueOf(const Settings& settings, const std::string& name);

// One a line, "name=value"; no line for the content of no file.
std::string textOf(const Settings& settings);
Settings settingsFrom(const std::string& text);

// Throws UsageError with the nearest name.
const SceneEntry& sceneNamed(const std::string& name);

const std::vector<std::string>& qualityNames();

}  // namespace plait
