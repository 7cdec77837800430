// What is filmed for the catalogue where nobody has: the clip of a scene, and short ones of each of
// its knobs at three values.
#pragma once

#include "demos/runs/settings.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace plait {

struct Film {
    std::string scene;
    std::string knob = {}, value = {};  // "" of the clip of the scene
    Settings settings;
    std::filesystem::path folder;  // of its run, from that of all runs
};

// The values at which a knob is shown: of a number the one it has by itself and one to either side,
// of a choice the first three; none of a file.
std::vector<std::string> shownValues(const Knob& knob);

// The clip first. Those of knobs take at most 3 s.
std::vector<Film> filmsOf(const SceneEntry& entry, const std::string& quality);

// Makes those whose clip is not in `runs` yet; one that was stopped goes on, if the program is the
// same. What diverges or cannot be built is told in a line, and left out. Throws FileError and
// Interrupted.
void makeFilms(std::span<const Film> films, const std::filesystem::path& runs, int threads,
               bool quiet);

}  // namespace plait
