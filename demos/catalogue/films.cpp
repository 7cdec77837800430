#include "films.h"

#include "demos/runs/run_job.h"
#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/progress.h"
#include "demos/tools/words.h"

#include <plait/solver_options.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plait {
namespace {

namespace fs = std::filesystem;

constexpr double shortFilm = 3;  // s

// Half way from the knob's own value to an end of its range, or to what is `times` as large where
// that is nearer.
double beside(double value, double end, double times) {
    const double half = (value + end) / 2;
    const double by = value > 0 ? value * times : half;
    const double near = std::fabs(by - value) < std::fabs(half - value) ? by : half;
    const bool whole = value == std::floor(value) && std::fabs(end) > 4;
    return whole ? std::round(near) : near;
}

Settings settingsFor(const SceneEntry& entry, const std::string& quality) {
    return {{"scene", entry.name}, {"quality", quality}};
}

// Of this very program.
bool isOurs(const fs::path& folder) {
    std::error_code none;
    const fs::path settings = folder / "cache" / "settings.txt";
    const auto made = fs::last_write_time(settings, none);
    return !none && made > fs::last_write_time("/proc/self/exe", none);
}

PictureOptions picturesOf(const Film& film, const Run& run) {
    PictureOptions pictures;
    pictures.width = film.knob.empty() ? 640 : 320;
    pictures.height = film.knob.empty() ? 360 : 180;
    pictures.last = run.frames();
    pictures.caption = false;
    pictures.keep = true;
    return pictures;
}

void makeFilm(const Film& film, const fs::path& folder, int threads) {
    const Run run = makeRun(film.settings);
    RunJobOptions options;
    options.threads = threads;
    options.quiet = true;
    options.pictures = picturesOf(film, run);
    RunJob job(run, options);
    const bool ours = isOurs(folder);
    job.execute({folder, settingsOf(run), {.resume = ours, .replace = !ours}});
}

}  // namespace

std::vector<std::string> shownValues(const Knob& knob) {
    if (!knob.isNumber())
        return {knob.choices.begin(),
                knob.choices.begin() + std::min<std::ptrdiff_t>(3, std::ssize(knob.choices))};
    std::vector<double> values{beside(knob.value, knob.low, 0.5), knob.value,
                               beside(knob.value, knob.high, 2)};
    if (knob.value == knob.low) values = {knob.low, beside(knob.low, knob.high, 2), knob.high};
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    std::vector<std::string> words;
    for (const double value : values) words.push_back(text(value));
    return words;
}

std::vector<Film> filmsOf(const SceneEntry& entry, const std::string& quality) {
    std::vector<Film> films{
        {.scene = entry.name, .settings = settingsFor(entry, quality), .folder = entry.name}};
    const double seconds = std::min(shortFilm, build(entry, Quality::draft).seconds);
    for (const Knob& knob : entry.knobs)
        for (const std::string& value : shownValues(knob)) {
            Film& film = films.emplace_back(
                Film{.scene = entry.name,
                     .knob = knob.name,
                     .value = value,
                     .settings = settingsFor(entry, quality),
                     .folder = fs::path("knobs") / entry.name / (knob.name + "=" + value)});
            film.settings.emplace_back("knob." + knob.name, value);
            film.settings.emplace_back("seconds", text(seconds));
        }
    return films;
}

void makeFilms(std::span<const Film> films, const fs::path& runs, int threads, bool quiet) {
    Progress progress("films", 0, static_cast<int>(films.size()), quiet, "films");
    int done = 0;
    for (const Film& film : films) {
        stopIfInterrupted();
        const fs::path folder = runs / film.folder;
        if (!fs::exists(folder / "clip.mp4")) try {
                makeFilm(film, folder, threads);
            } catch (const Diverged& error) {
                std::fprintf(stderr, "plait: %s: %s\n", folder.c_str(), error.what());
            } catch (const SceneError& error) {
                std::fprintf(stderr, "plait: %s: %s\n", folder.c_str(), error.what());
            }
        progress.show(++done);
    }
}

}  // namespace plait
