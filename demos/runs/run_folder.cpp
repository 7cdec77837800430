#include "run_folder.h"

#include "demos/tools/errors.h"

#include <cstdio>
#include <cstring>
#include <system_error>

namespace plait {
namespace {

namespace fs = std::filesystem;

// The first setting in which two runs differ.
std::string difference(const Settings& there, const Settings& here) {
    const std::string content = "content.";
    for (const auto& [name, value] : here) {
        const std::string before = valueOf(there, name);
        if (before == value) continue;
        if (name.starts_with(content))
            return valueOf(here, "knob." + name.substr(content.size())) +
                   " as it was before it changed";
        return name + "=" + before + " where this one has " + name + "=" + value;
    }
    return "other settings";
}

// True if nothing is there but what a run leaves that was killed before it wrote its settings.
bool isFree(const fs::path& folder) {
    if (!fs::exists(folder)) return true;
    if (!fs::is_directory(folder)) return false;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path() != folder / "cache" && entry.path().extension() != ".part") return false;
    return true;
}

}  // namespace

std::string numbered(int frame, const std::string& extension) {
    char name[32];
    std::snprintf(name, sizeof name, "%05d%s", frame, extension.c_str());
    return name;
}

bool RunFolder::holdsRun(const Path& path) { return fs::exists(path / "cache" / "settings.txt"); }

RunFolder::RunFolder(const Path& path, const Settings& settings, Use use) : path_(path) {
    const bool run = holdsRun(path);
    if (!run && !isFree(path))
        throw FileError(path.string() + ": is not empty and holds no run; choose another --out");
    makeFolder(path / "cache");
    lock_ = std::make_unique<FolderLock>(path);
    if (run) {
        const std::string there = readWhole(settingsPath());
        const bool same = there == textOf(settings);
        if (!same && !use.replace)
            throw FileError(path.string() + ": holds a run with " +
                            difference(settingsFrom(there), settings) +
                            "; --force replaces it, --out DIR goes elsewhere");
        if (!same || !use.resume) clear();
    }
    removeParts();
    writeWhole(settingsPath(), textOf(settings));
}

RunFolder::RunFolder(const Path& path) : path_(path) {
    if (!holdsRun(path)) throw FileError(path.string() + ": holds no run");
    lock_ = std::make_unique<FolderLock>(path);
    removeParts();
}

void RunFolder::removeParts() const noexcept {
    std::vector<Path> parts;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(path_, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().extension() == ".part") parts.push_back(entry->path());
    for (const Path& part : parts) fs::remove(part, error);
}

// The checkpoint first: without it, nothing else counts.
void RunFolder::clear() const {
    for (const Path& path : {checkpointPath(), recordPath(), metricsPath()}) fs::remove(path);
    removeFilm();
    fs::remove_all(path_ / "export");
    for (const auto& entry : fs::directory_iterator(path_ / "cache"))
        if (entry.path().extension() == ".frame") fs::remove(entry.path());
}

void RunFolder::removeFilm() const {
    for (const char* name : {"frames", "clip.mp4", "clip.webp", "contact.png"})
        fs::remove_all(path_ / name);
}

RunFolder::Path RunFolder::framePath(int frame) const {
    return path_ / "cache" / numbered(frame, ".frame");
}

RunFolder::Path RunFolder::picturePath(int frame) const {
    return path_ / "frames" / numbered(frame, ".png");
}

Run RunFolder::run() const {
    try {
        return makeRun(settingsFrom(readWhole(settingsPath())));
    } catch (const UsageError& error) {
        throw FileError(settingsPath().string() + ": " + error.what());
    }
}

RunFrame RunFolder::frame(int number) const {
    const Path path = framePath(number);
    return decodeFrame(readWhole(path), path.string());
}

int RunFolder::lastFrame() const {
    if (!fs::exists(checkpointPath())) return -1;
    const std::string bytes = readWhole(checkpointPath());
    std::int32_t frame;
    if (bytes.size() < 20) throw FileError(checkpointPath().string() + ": too short");
    std::memcpy(&frame, bytes.data() + 16, sizeof frame);
    return frame;
}

}  // namespace plait
