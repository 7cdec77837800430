#include "pictures.h"

#include "demos/tools/errors.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/pipe.h"
#include "demos/tools/words.h"
#include "exposure.h"
#include "film.h"
#include "inset_trail.h"
#include "overlays.h"
#include "render/pictures/caption.h"
#include "render/pictures/contact_sheet.h"
#include "render/pictures/image.h"
#include "render/pictures/legend.h"
#include "render/renderer.h"
#include "render/video.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace plait {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t queueLength = 4;

Settings wordsOf(const PictureOptions& options) {
    Settings settings{
        {"size", std::to_string(options.width) + "x" + std::to_string(options.height)},
        {"frames", std::to_string(options.first) + ":" + std::to_string(options.last)},
        {"overlay", options.overlay},
        {"caption", options.caption ? "yes" : "no"},
        {"gl", options.gl}};
    if (options.subframes > 1)
        settings.emplace_back("subframes", std::to_string(options.subframes));
    if (const auto& camera = options.camera) {
        std::string words;
        for (const double n : {camera->eye.x, camera->eye.y, camera->eye.z, camera->target.x,
                               camera->target.y, camera->target.z, camera->focalLength})
            words += (words.empty() ? "" : ",") + text(n);
        settings.emplace_back("camera", words);
    }
    return settings;
}

std::string numbersOf(const Run& run, const RunFrame& frame) {
    const auto rounded = [](const char* format, double value) {
        char buffer[32];
        std::snprintf(buffer, sizeof buffer, format, value);
        return std::string(buffer);
    };
    std::string line;
    for (const auto& [name, value] : settingsOf(run)) {
        if (name == "method") line += value;
        if (name == "substeps") line += " · " + value + (value == "1" ? " substep" : " substeps");
    }
    for (std::size_t i = 0; i < run.scene.metrics.size(); ++i) {
        const Metric& metric = run.scene.metrics[i];
        if (metric.caption)
            // Not -0.00.
            line += " · " + metric.name + " " +
                    rounded("%.2f", std::round(100 * frame.metrics[i]) / 100 + 0.0) +
                    (metric.unit.empty() ? "" : " " + metric.unit);
    }
    return line + " · " + rounded("%.1f", 1000 * frame.seconds) + " ms a frame";
}

}  // namespace

struct Pictures::Work {
    struct Drawn {
        int number;  // of the film
        RunFrame frame;
        Picture picture;
        bool fresh;  // not read from a file
    };

    Work(const Run& r, const RunFolder& f, const PictureOptions& o)
        : run(r),
          folder(f),
          options(o),
          film(r, o.first, o.last),
          overlays(r, o.overlay),
          trail(r) {
        if (film.size() == 0)
            throw FileError(run.entry->name +
                            " cannot be filmed: its film shows none of the frames");
        prepareFolder();
        try {
            encoder = std::jthread([this] { guarded([this] { encode(); }); });
            drawer = std::jthread([this] { guarded([this] { draw(); }); });
        } catch (const std::system_error& none) {
            abandon();  // or the first would wait for frames
            throw FileError(run.entry->name +
                            " cannot be filmed: no thread that draws: " + none.what());
        }
    }
    ~Work() {
        abandon();
        if (interrupted()) endSoon();
    }

    // Pictures of other options would mix with these.
    void prepareFolder() const {
        const fs::path into = folder.path() / "frames", settings = into / "settings.txt";
        const std::string words = textOf(wordsOf(options));
        if (options.keep && fs::exists(settings) && readWhole(settings) == words) return;
        folder.removeFilm();
        makeFolder(into);
        writeWhole(settings, words);
    }

    void draw();
    void encode();
    Picture drawn(Renderer& lens, int number, const RunFrame& frame, const RunFrame* before) const;
    Picture finished(const Drawn& drawn) const;

    // What a stage throws ends both, and is thrown again where frames come from.
    template <class Stage>
    void guarded(const Stage& stage) {
        try {
            stage();
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!error) error = std::current_exception();
            abandon();
        }
        --atWork;
    }
    void abandon() {
        stopped = true;
        opened();
        frames.close(true);
        pictures.close(true);
    }
    // Mesa is to have its threads before the encoder takes some: it waits for ever for those that
    // do not start, and looks whether they would only before it starts them.
    void opened() {
        open = true;
        open.notify_all();
    }
    // A picture of 8K takes ten seconds, and none of those that draw it asks for interrupts.
    void endSoon() const {
        for (int i = 0; i < 30; ++i) {
            if (atWork == 0) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        folder.removeParts();
        endInterrupted();
    }
    void rethrow() {
        std::exception_ptr thrown;
        {
            const std::lock_guard lock(mutex);
            thrown = error;
        }
        if (!thrown) return;
        try {
            std::rethrow_exception(thrown);
        } catch (const std::invalid_argument& wrong) {
            throw SceneError(run.entry->name + " cannot be filmed: " + wrong.what());
        } catch (const std::runtime_error& wrong) {
            throw FileError(wrong.what());
        }
    }
    void note(double& stage, std::chrono::steady_clock::time_point since) {
        const std::lock_guard lock(mutex);
        stage += std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
    }

    const Run& run;
    const RunFolder& folder;
    PictureOptions options;
    Film film;
    Overlays overlays;
    InsetTrail trail;
    Pipe<RunFrame> frames{queueLength};
    Pipe<Drawn> pictures{queueLength};
    std::atomic<int> done{0}, atWork{2};
    std::atomic<bool> open{false}, stopped{false}, ended{false};
    std::mutex mutex;  // of what follows
    std::exception_ptr error;
    std::string library, renderer;
    double opening = 0, drawing = 0, encoding = 0;  // s
    std::jthread drawer, encoder;
};

void Pictures::Work::draw() {
    const auto start = std::chrono::steady_clock::now();
    Renderer lens(run.scene, {.width = options.width,
                              .height = options.height,
                              .samples = 4,
                              .gl = glChoice(options.gl)});
    opened();
    note(opening, start);
    {
        const std::lock_guard lock(mutex);
        library = lens.context().library();
        renderer = lens.context().renderer();
    }
    std::optional<RunFrame> before;  // where pictures are exposed to what lies between
    while (std::optional<RunFrame> frame = frames.pop()) {
        for (const int number : film.showing(frame->number)) {
            const auto begin = std::chrono::steady_clock::now();
            const fs::path path = folder.picturePath(number);
            const bool fresh = !(options.keep && fs::exists(path));
            Picture picture;
            if (fresh)
                picture = drawn(lens, number, *frame, before ? &*before : nullptr);
            else if (!film.isCut())
                picture = readPng(path);
            note(drawing, begin);
            if (!pictures.push({number, *frame, std::move(picture), fresh})) return;
        }
        if (options.subframes > 1) before = std::move(*frame);
    }
    pictures.close();
}

Picture Pictures::Work::drawn(Renderer& lens, int number, const RunFrame& frame,
                              const RunFrame* before) const {
    std::optional<CameraPose> pose;
    const Take* take = film.picture(number).take;
    if (const auto& c = options.camera) {
        const auto vec = [](const Vec<double>& v) { return glm::vec3(glm::dvec3(v.x, v.y, v.z)); };
        pose = CameraPose{vec(c->eye), vec(c->target),
                          static_cast<float>(2 * std::atan(10.125 / c->focalLength))};
    } else if (take && !take->cameras.empty()) {
        pose = poseAt(take->cameras, frame.time);
    }
    const Overlay overlay = overlays.of(frame);
    const Overlay* const colors = overlays.none() ? nullptr : &overlay;
    const CameraPose* const chosen = pose ? &*pose : nullptr;
    return before ? lens.draw(Exposure(run.scene.world, *before, frame, options.subframes).all,
                              colors, chosen)
                  : lens.draw(momentOf(frame), colors, chosen);
}

Picture Pictures::Work::finished(const Drawn& drawn) const {
    Picture picture = drawn.picture;
    if (!overlays.none()) drawLegend(picture, overlays.legend());
    const double below = overlays.none() ? 0 : 100;
    if (const auto inset = trail.at(drawn.frame.number)) drawInset(picture, *inset, below);
    if (!options.caption) return picture;
    const FrameRate rate = film.rate();
    const double shown = double(drawn.number - film.first() + 1) * rate.seconds / rate.frames;
    drawCaption(picture, {.title = run.entry->title,
                          .numbers = numbersOf(run, drawn.frame),
                          .fade = std::min(1.0, shown / 0.3)});
    if (const Take* take = film.picture(drawn.number).take) drawHeadline(picture, take->words);
    return picture;
}

void Pictures::Work::encode() {
    open.wait(false);
    if (stopped) return;
    const auto writer = [&](const char* name) {
        return std::make_unique<VideoWriter>(folder.path() / name, options.width, options.height,
                                             film.rate());
    };
    std::vector<std::unique_ptr<VideoWriter>> videos;
    videos.push_back(writer("clip.mp4"));
    if (options.webp) videos.push_back(writer("clip.webp"));
    const std::vector<int> chosen = sheetFrames(film.size());
    std::vector<SheetFrame> sheet;
    const auto take = [&](int number, Picture picture) {
        for (const auto& video : videos) video->add(picture);
        if (std::ranges::find(chosen, number - film.first()) != chosen.end())
            sheet.push_back({std::move(picture), film.picture(number).frame / run.frameRate()});
    };
    while (std::optional<Drawn> drawn = pictures.pop()) {
        const auto begin = std::chrono::steady_clock::now();
        if (drawn->fresh) drawn->picture = finished(*drawn);
        if (drawn->fresh) writePng(folder.picturePath(drawn->number), drawn->picture);
        if (!film.isCut()) take(drawn->number, std::move(drawn->picture));
        note(encoding, begin);
        done = drawn->frame.number;
    }
    // A take may show again what an earlier one did.
    for (int i = 0; film.isCut() && !stopped && i < film.size(); ++i)
        take(film.first() + i, readPng(folder.picturePath(film.first() + i)));
    if (stopped) return;
    for (const auto& video : videos) video->finish();
    writePng(folder.path() / "contact.png", contactSheet(sheet, run.entry->title));
    ended = true;
}

Pictures::Pictures(const Run& run, const RunFolder& folder, const PictureOptions& options)
    : work_(std::make_unique<Work>(run, folder, options)) {}

Pictures::~Pictures() = default;

void Pictures::add(RunFrame frame) {
    work_->rethrow();
    work_->trail.add(frame);
    const PictureOptions& options = work_->options;
    const int needed = options.first - (options.subframes > 1 ? 1 : 0);
    if (frame.number < needed || frame.number > options.last) return;
    if (options.subframes == 1 && work_->film.showing(frame.number).empty()) return;
    if (!work_->frames.push(std::move(frame), stopIfInterrupted)) work_->rethrow();
}

bool Pictures::finish(double seconds) {
    work_->frames.close();
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (!work_->ended && std::chrono::steady_clock::now() < until) {
        work_->rethrow();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return work_->ended;
}

int Pictures::done() const { return work_->done; }

Stages Pictures::stages() const {
    const std::lock_guard lock(work_->mutex);
    return {
        {"open renderer", work_->opening}, {"draw", work_->drawing}, {"encode", work_->encoding}};
}

std::string Pictures::glLibrary() const {
    const std::lock_guard lock(work_->mutex);
    return work_->library;
}

std::string Pictures::glRenderer() const {
    const std::lock_guard lock(work_->mutex);
    return work_->renderer;
}

}  // namespace plait
