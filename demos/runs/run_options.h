// What `run`, `render` and `check` are told, as plain values.
#pragma once

#include "demos/output/pictures.h"
#include "demos/tools/arguments.h"
#include "settings.h"

namespace plait {

// The options that decide a state: quality, knobs and those of settingOptions().
std::vector<Option> stateOptions();
// The settings asked for, of the scene that the first operand names.
Settings requestedSettings(const Arguments& arguments);

// The options of pictures.
std::vector<Option> pictureOptions();
// Defaults by quality. Throws UsageError.
PictureOptions requestedPictures(const Arguments& arguments, const Run& run);

// --threads, or all usable cores.
int requestedThreads(const Arguments& arguments);
Option threadsOption();
Option quietOption();

}  // namespace plait
