#include "render/video.h"
#include "studio.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/scratch_folder.h"
#include "video_reader.h"

#include <fstream>

using namespace plait;
using namespace plait::test;

namespace {

constexpr int width = 320, height = 180;

const Picture& frameAt(int i) {
    static std::vector<Picture> frames;
    for (int n = static_cast<int>(frames.size()); n <= i; ++n)
        frames.push_back(studio(width, height, {.time = n / 24.0}));
    return frames[i];
}

void writeVideo(const std::filesystem::path& path, int frames, FrameRate rate = {24, 1}) {
    VideoWriter writer(path, width, height, rate);
    for (int i = 0; i < frames; ++i) writer.add(frameAt(i));
    writer.finish();
}

std::string messageOf(const auto& action) {
    try {
        action();
    } catch (const std::exception& e) {
        return e.what();
    }
    return "";
}

int littleEndian(const std::vector<std::uint8_t>& bytes, std::size_t at, int count) {
    int value = 0;
    for (int i = 0; i < count; ++i) value |= bytes[at + i] << (8 * i);
    return value;
}

// Pictures of an animated WebP, which FFmpeg reads one by one only.
struct Animation {
    int width = 0, height = 0, loops = -1;
    std::vector<int> milliseconds;
    std::vector<std::uint8_t> first;  // a WebP of its own
};

Animation readAnimation(const std::vector<std::uint8_t>& file) {
    Animation animation;
    REQUIRE(file.size() > 12);
    REQUIRE(std::string(file.begin(), file.begin() + 4) == "RIFF");
    REQUIRE(littleEndian(file, 4, 4) + 8 == static_cast<int>(file.size()));
    for (std::size_t at = 12; at + 8 <= file.size();) {
        const std::string name(file.begin() + at, file.begin() + at + 4);
        const auto size = static_cast<std::size_t>(littleEndian(file, at + 4, 4));
        if (name == "VP8X") {
            animation.width = littleEndian(file, at + 12, 3) + 1;
            animation.height = littleEndian(file, at + 15, 3) + 1;
        } else if (name == "ANIM") {
            animation.loops = littleEndian(file, at + 12, 2);
        } else if (name == "ANMF") {
            animation.milliseconds.push_back(littleEndian(file, at + 20, 3));
            if (animation.first.empty()) {
                animation.first.assign(file.begin(), file.begin() + 12);
                animation.first.insert(animation.first.end(), file.begin() + at + 24,
                                       file.begin() + at + 8 + size);
                const auto length = animation.first.size() - 8;
                for (int i = 0; i < 4; ++i)
                    animation.first[4 + i] = static_cast<std::uint8_t>(length >> (8 * i));
            }
        }
        at += 8 + size + size % 2;
    }
    return animation;
}

}  // namespace

TEST_CASE("A clip decodes to what was put in", "[video]") {
    const ScratchFolder folder;
    const int frames = 24;
    writeVideo(folder / "clip.mp4", frames);
    const Video video = readVideo(folder / "clip.mp4");
    CHECK(video.codec == "h264");
    CHECK(video.pixelFormat == "yuv420p");
    CHECK(video.colorSpace == "bt709");
    CHECK(video.colorRange == "tv");
    CHECK(video.width == width);
    CHECK(video.height == height);
    CHECK(video.rateFrames == 24);
    CHECK(video.rateSeconds == 1);
    REQUIRE(video.frames.size() == frames);
    double worst = 1e9;
    for (int i = 0; i < frames; ++i) {
        CHECK(video.times[i] == Approx(i / 24.0));
        worst = std::min(worst, signalToNoise(video.frames[i], frameAt(i)));
        // Neither a frame late nor early.
        CHECK(signalToNoise(video.frames[i], frameAt(i)) >
              signalToNoise(video.frames[i], frameAt(i + 1)) + 3);
    }
    note("signal to noise of the worst frame, dB", worst);
    REQUIRE(worst > 35);
    CHECK(folder.count() == 1);
}

TEST_CASE("A clip keeps colours and brightness", "[video]") {
    const ScratchFolder folder;
    double worst = 0;
    for (const auto& color : {std::array{200, 50, 31},
                              {241, 230, 212},
                              {22, 32, 44},
                              {0, 0, 0},
                              {255, 255, 255},
                              {30, 122, 128}}) {
        Picture plain{64, 64, {}};
        for (int i = 0; i < 3 * 64 * 64; ++i)
            plain.rgb.push_back(static_cast<std::uint8_t>(color[i % 3]));
        VideoWriter writer(folder / "clip.mp4", 64, 64, {24, 1});
        writer.add(plain);
        writer.finish();
        const Video video = readVideo(folder / "clip.mp4");
        REQUIRE(video.frames.size() == 1);
        for (int k = 0; k < 3; ++k)
            worst = std::max(worst, std::abs(video.frames[0].rgb[3 * (32 * 64 + 32) + k] -
                                             static_cast<double>(color[k])));
    }
    REQUIRE(report("largest error of a plain colour, of 255", worst, 3));
}

TEST_CASE("A clip starts before it is loaded: its index lies in front", "[video]") {
    const ScratchFolder folder;
    writeVideo(folder / "clip.mp4", 5);
    const auto file = readBytes(folder / "clip.mp4");
    std::string order;
    std::uint64_t total = 0;
    for (const auto& [name, size] : boxes(file)) {
        order += name + " ";
        total += size;
    }
    CHECK(order.find("moov") < order.find("mdat"));
    CHECK(order.find("mdat") != std::string::npos);
    CHECK(total == file.size());
}

TEST_CASE("The same pictures give the same clip, at any rate", "[video][determinism]") {
    const ScratchFolder folder;
    for (const FrameRate rate : {FrameRate{24, 1}, {25, 1}, {60, 1}, {30000, 1001}, {15, 1}}) {
        for (const char* name : {"a.mp4", "b.mp4", "a.webp", "b.webp"})
            writeVideo(folder / name, 6, rate);
        CHECK(readBytes(folder / "a.mp4") == readBytes(folder / "b.mp4"));
        CHECK(readBytes(folder / "a.webp") == readBytes(folder / "b.webp"));
        const Video video = readVideo(folder / "a.mp4");
        CHECK(video.frames.size() == 6);
        CHECK(video.rateFrames == rate.frames);
        CHECK(video.rateSeconds == rate.seconds);
    }
}

TEST_CASE("A frame of another size is scaled", "[video]") {
    const ScratchFolder folder;
    VideoWriter writer(folder / "clip.mp4", width, height, {24, 1});
    writer.add(studio(2 * width, 2 * height));
    writer.add(studio(width, height));
    writer.finish();
    const Video video = readVideo(folder / "clip.mp4");
    REQUIRE(video.frames.size() == 2);
    CHECK(signalToNoise(video.frames[0], video.frames[1]) > 30);
}

TEST_CASE("An animation for the README loops and is small", "[video]") {
    const ScratchFolder folder;
    const int frames = 15;
    {
        VideoWriter writer(folder / "clip.webp", 480, 270, {15, 1});
        for (int i = 0; i < frames; ++i) writer.add(studio(480, 270, {.time = i / 15.0}));
        writer.finish();
    }
    const auto file = readBytes(folder / "clip.webp");
    const Animation animation = readAnimation(file);
    CHECK(animation.width == 480);
    CHECK(animation.height == 270);
    CHECK(animation.loops == 0);  // for ever
    CHECK(animation.milliseconds.size() == frames);
    int total = 0;
    for (const int ms : animation.milliseconds) total += ms;
    CHECK(std::abs(total - 1000) <= 70);
    REQUIRE(report("megabytes of a second", static_cast<double>(file.size()) / 1e6, 0.3));

    std::ofstream(folder / "first.webp", std::ios::binary)
        .write(reinterpret_cast<const char*>(animation.first.data()),
               static_cast<std::streamsize>(animation.first.size()));
    const Video first = readVideo(folder / "first.webp");
    REQUIRE(first.frames.size() == 1);
    const double decibels = signalToNoise(first.frames[0], studio(480, 270));
    note("signal to noise of the first frame, dB", decibels);
    CHECK(decibels > 30);
}

TEST_CASE("What is no video is refused in one line", "[video]") {
    const ScratchFolder folder;
    const auto open = [&](const std::string& name, int w, int h, FrameRate rate) {
        return messageOf([&] { const VideoWriter writer(folder / name, w, h, rate); });
    };
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    for (const auto& [w, h] : {std::pair{321, 180}, {320, 181}, {0, 0}, {-2, 4}, {14, 16}})
        CHECK(open("a.mp4", w, h, {24, 1}) ==
              path("a.mp4") + ": width and height of a video are even and at least 16, not " +
                  std::to_string(w) + "x" + std::to_string(h));
    CHECK(open("a.avi", 320, 180, {24, 1}) == path("a.avi") + ": a video ends in .mp4 or .webp");
    CHECK(open("a.mp4", 320, 180, {0, 1}) == path("a.mp4") + ": the frame rate is not positive");
    CHECK(open("a.mp4", 320, 180, {24, -1}) == path("a.mp4") + ": the frame rate is not positive");
    CHECK(open("no/a.mp4", 320, 180, {24, 1}) ==
          path("no/a.mp4") + ": cannot be written: No such file or directory");
    CHECK(messageOf([&] { VideoWriter(folder / "a.mp4", 320, 180, {24, 1}).finish(); }) ==
          path("a.mp4") + ": a video without a frame");
    CHECK(messageOf([&] { VideoWriter(folder / "a.mp4", 320, 180, {24, 1}).add({}); }) ==
          path("a.mp4") + ": a frame without pixels");
    CHECK(folder.count() == 0);
}

TEST_CASE("A clip that is not finished leaves what was there", "[video]") {
    const ScratchFolder folder;
    writeVideo(folder / "clip.mp4", 3);
    const auto before = readBytes(folder / "clip.mp4");
    for (const char* name : {"clip.mp4", "other.mp4", "other.webp"}) {
        VideoWriter writer(folder / name, width, height, {24, 1});
        for (int i = 0; i < 60; ++i) writer.add(frameAt(i % 4));
    }
    CHECK(readBytes(folder / "clip.mp4") == before);
    CHECK(folder.count() == 1);

    // Nor one whose name is taken by a folder.
    std::filesystem::create_directory(folder / "taken.mp4");
    CHECK(messageOf([&] { writeVideo(folder / "taken.mp4", 2); }) ==
          (folder / "taken.mp4").string() + ": cannot be written: Is a directory");
    CHECK(folder.count() == 2);
}

TEST_CASE("A full disk leaves the old clip and nothing beside it", "[video]") {
    const ScratchFolder folder;
    writeVideo(folder / "clip.mp4", 3);
    writeVideo(folder / "clip.webp", 3);
    for (const char* name : {"clip.mp4", "clip.webp"}) {
        const auto before = readBytes(folder / name);
        std::string message;
        {
            const FullDisk full(1500);
            message = messageOf([&] { writeVideo(folder / name, 12); });
        }
        CHECK(message == (folder / name).string() + ": cannot be written: File too large");
        CHECK(readBytes(folder / name) == before);
    }
    CHECK(folder.count() == 2);
}
