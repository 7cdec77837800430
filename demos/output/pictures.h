// The one place where runs meet pictures: frames in; frames/*.png, clip.mp4 and contact.png out,
// drawn and encoded while the run goes on.
#pragma once

#include "demos/runs/run_folder.h"
#include "demos/runs/run_frame.h"
#include "demos/runs/settings.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plait {

// A camera that stands still.
struct FixedCamera {
    Vec<double> eye, target;  // m
    double focalLength;       // mm, of a sensor 36 mm wide
};

struct PictureOptions {
    int width = 1280, height = 720;
    int first = 1, last = 1;       // frames that are drawn
    std::string overlay = "none";  // overlayNames()
    bool caption = true;
    int subframes = 1;  // moments of which a picture is the mean
    bool webp = false;  // clip.webp as well, an animation that loops
    std::string gl = "auto";
    std::optional<FixedCamera> camera;
    bool keep = false;  // pictures that are there already, of the same options
};

// Seconds by stage.
using Stages = std::vector<std::pair<std::string, double>>;

class Pictures {
public:
    // Throws FileError, or std::runtime_error where nothing can draw. `run` must live as long.
    Pictures(const Run& run, const RunFolder& folder, const PictureOptions& options);
    // Ends the stages; what is not finished leaves no file. Ends the program if it was interrupted
    // and a picture takes longer than one would wait.
    ~Pictures();

    // The next frame, from 0 on; waits while the stages are busy. Throws what they threw, and
    // Interrupted.
    void add(RunFrame frame);
    // Waits until everything is on disk, at most `seconds`. True when it is.
    bool finish(double seconds);

    int done() const;  // frames that went through
    Stages stages() const;
    std::string glLibrary() const;   // "osmesa" or "egl"
    std::string glRenderer() const;  // its own words

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

}  // namespace plait
