// out/<scene>/: what a run leaves, and who may write there.
//
// frames/00001.png ..., clip.mp4, clip.webp, contact.png, metrics.csv, run.json, export/, and in
// cache/ the settings (settings.txt), a file a frame and the last checkpoint (run_frame.h).
#pragma once

#include "demos/tools/files.h"
#include "run_frame.h"
#include "settings.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace plait {

class RunFolder {
public:
    using Path = std::filesystem::path;

    struct Use {
        bool resume = false;   // an earlier run with these settings is kept, to go on with
        bool replace = false;  // one with other settings is removed
    };

    // For a run with these settings; made if it is not there. Throws FileError for one that holds
    // another run, unless it is to be replaced, for one that is not empty and holds no run, and if
    // another program is at work there.
    RunFolder(const Path& path, const Settings& settings, Use use);
    // One that holds a run. Throws FileError if it holds none.
    explicit RunFolder(const Path& path);

    // True if `path` holds a run.
    static bool holdsRun(const Path& path);

    const Path& path() const { return path_; }
    Path framePath(int frame) const;    // in the cache
    Path picturePath(int frame) const;  // frames/00001.png
    Path exportPath(const std::string& name) const { return path_ / "export" / name; }
    Path checkpointPath() const { return path_ / "cache" / "checkpoint"; }
    Path settingsPath() const { return path_ / "cache" / "settings.txt"; }
    Path metricsPath() const { return path_ / "metrics.csv"; }
    Path recordPath() const { return path_ / "run.json"; }

    // Pictures, clips and contact sheet.
    void removeFilm() const;
    // What writes leave that are killed.
    void removeParts() const noexcept;

    // The run that was begun here.
    Run run() const;
    RunFrame frame(int number) const;
    // The frame of the checkpoint, -1 without one: all frames up to it are in the cache.
    int lastFrame() const;

private:
    void clear() const;

    Path path_;
    std::unique_ptr<FolderLock> lock_;
};

// "00012" and an extension.
std::string numbered(int frame, const std::string& extension);

}  // namespace plait
