#include "run_options.h"

#include "demos/output/overlays.h"
#include "demos/tools/errors.h"
#include "demos/tools/machine.h"
#include "demos/tools/words.h"

#include <algorithm>
#include <array>

namespace plait {
namespace {

std::array<int, 2> sizeOf(const std::string& word) {
    const std::size_t x = word.find('x');
    if (x == std::string::npos) throw UsageError("--size: '" + word + "' is not WxH, as 1280x720");
    std::array<int, 2> size;
    const std::string parts[2] = {word.substr(0, x), word.substr(x + 1)};
    for (std::size_t i = 0; i < 2; ++i) {
        size[i] = static_cast<int>(parseInteger("--size", parts[i], 16, 7680));
        if (size[i] % 2)
            throw UsageError("--size: " + parts[i] + " is odd, and video has pairs of pixels");
    }
    return size;
}

// Numbers between separators.
std::vector<double> numbersOf(const std::string& what, const std::string& word,
                              const std::string& separators) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= word.size();) {
        const std::size_t end = std::min(word.find_first_of(separators, begin), word.size());
        numbers.push_back(parseNumber(what, word.substr(begin, end - begin), -1e6, 1e6));
        begin = end + 1;
    }
    return numbers;
}

FixedCamera cameraOf(const std::string& word) {
    const std::vector<double> n = numbersOf("--camera", word, ",:");
    if (n.size() < 6 || n.size() > 7 || (n.size() == 7 && n[6] <= 0))
        throw UsageError("--camera: '" + word +
                         "' is not X,Y,Z:X,Y,Z[:MM]: eye and target in m, focal length above 0");
    if (n[0] == n[3] && n[2] == n[5])
        throw UsageError("--camera: '" + word + "' looks nowhere, straight up or straight down");
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n.size() == 7 ? n[6] : 50};
}

void setFrames(PictureOptions& options, const std::string& word, int last) {
    const std::size_t colon = word.find(':');
    if (colon == std::string::npos)
        throw UsageError("--frames: '" + word + "' is not A:B, as 1:" + std::to_string(last));
    options.first = static_cast<int>(parseInteger("--frames", word.substr(0, colon), 1, last));
    options.last =
        static_cast<int>(parseInteger("--frames", word.substr(colon + 1), options.first, last));
}

}  // namespace

std::vector<Option> stateOptions() {
    std::vector<Option> options{{.name = "quality",
                                 .argument = "draft|preview|final",
                                 .meaning = "mesh, size and playing time",
                                 .letter = 'q'},
                                {.name = "set",
                                 .argument = "KNOB=VALUE",
                                 .meaning = "a knob of the scene; repeatable",
                                 .letter = 0,
                                 .repeatable = true}};
    for (const SettingOption& option : settingOptions())
        options.push_back({option.name, option.argument, option.meaning});
    return options;
}

Settings requestedSettings(const Arguments& arguments) {
    Settings settings{{"scene", arguments.operands[0]},
                      {"quality", arguments.value("quality", "preview")}};
    for (const std::string& knob : arguments.values("set")) {
        const std::size_t equals = knob.find('=');
        if (equals == std::string::npos)
            throw UsageError("--set: '" + knob + "' is not KNOB=VALUE");
        settings.emplace_back("knob." + knob.substr(0, equals), knob.substr(equals + 1));
    }
    for (const SettingOption& option : settingOptions())
        if (arguments.has(option.name))
            settings.emplace_back(option.name, arguments.value(option.name));
    return settings;
}

std::vector<Option> pictureOptions() {
    std::string overlays;
    for (const std::string& name : overlayNames()) overlays += (overlays.empty() ? "" : "|") + name;
    return {{"size", "WxH", "of pictures, in pixels"},
            {"frames", "A:B", "which are drawn; all are simulated"},
            {"camera", "X,Y,Z:X,Y,Z[:MM]", "that stands: eye, target, focal length"},
            {"overlay", overlays, "colours by a quantity, with a legend"},
            {"subframes", "N", "moments of half a frame's time that a picture is the mean of; 1"},
            {"no-caption", "", "without the strip at the bottom"},
            {"webp", "", "clip.webp as well, an animation that loops"},
            {"gl", "auto|osmesa|egl", "what draws"}};
}

PictureOptions requestedPictures(const Arguments& arguments, const Run& run) {
    PictureOptions options;
    const std::array<int, 2> size =
        sizeOf(arguments.value("size", run.knobs.byQuality("640x360", "1280x720", "1920x1080")));
    options.width = size[0];
    options.height = size[1];
    options.last = run.frames();
    if (arguments.has("frames")) setFrames(options, arguments.value("frames"), run.frames());
    if (arguments.has("camera")) options.camera = cameraOf(arguments.value("camera"));
    options.overlay = arguments.value("overlay", "none");
    parseChoice("--overlay", options.overlay, overlayNames());
    options.caption = !arguments.has("no-caption");
    options.subframes =
        static_cast<int>(parseInteger("--subframes", arguments.value("subframes", "1"), 1, 64));
    options.webp = arguments.has("webp");
    options.gl = arguments.value("gl", "auto");
    parseChoice("--gl", options.gl, {"auto", "osmesa", "egl"});
    return options;
}

int requestedThreads(const Arguments& arguments) {
    if (!arguments.has("threads")) return usableCores();
    return static_cast<int>(parseInteger("--threads", arguments.value("threads"), 1, 256));
}

Option threadsOption() { return {"threads", "N", "that simulate; any number gives the same bits"}; }

Option quietOption() { return {"quiet", "", "no progress, no closing lines"}; }

}  // namespace plait
