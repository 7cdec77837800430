#include "render/pictures/caption.h"
#include "render/pictures/contact_sheet.h"
#include "render/pictures/image.h"
#include "render/pictures/legend.h"
#include "render/pictures/text.h"
#include "studio.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/scratch_folder.h"
#include "video_reader.h"

#include <chrono>
#include <fstream>

using namespace plait;
using namespace plait::test;

namespace {

Picture noise(int width, int height) {
    Random random(7);
    Picture picture{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i)
        picture.rgb.push_back(static_cast<std::uint8_t>(random.below(256)));
    return picture;
}

std::string messageOf(const auto& action) {
    try {
        action();
    } catch (const std::exception& e) {
        return e.what();
    }
    return "";
}

}  // namespace

TEST_CASE("A PNG gives back every bit, to stb and to FFmpeg", "[image]") {
    const ScratchFolder folder;
    for (const Picture& picture : {noise(1, 1), noise(7, 5), noise(64, 1), studio(480, 270)}) {
        writePng(folder / "a.png", picture);
        CHECK(readPng(folder / "a.png") == picture);
        const Video read = readVideo(folder / "a.png");
        REQUIRE(read.frames.size() == 1);
        CHECK(read.frames[0] == picture);
        CHECK(read.pixelFormat == "rgb24");
    }
    CHECK(folder.count() == 1);
}

TEST_CASE("The same picture gives the same PNG, small and fast", "[image][determinism]") {
    const ScratchFolder folder;
    const Picture picture = studio(480, 270);
    const auto start = std::chrono::steady_clock::now();
    writePng(folder / "a.png", picture);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    writePng(folder / "b.png", picture);
    CHECK(readBytes(folder / "a.png") == readBytes(folder / "b.png"));
    const auto size = static_cast<double>(readBytes(folder / "a.png").size());
    note("PNG of 480x270, ms", time.count());
    REQUIRE(report("bytes of the PNG over bytes of the pixels",
                   size / static_cast<double>(picture.rgb.size()), 0.25));
}

TEST_CASE("What cannot be written or read as PNG is said in one line", "[image]") {
    const ScratchFolder folder;
    const Picture picture = noise(40, 40);
    const auto write = [&](const std::string& name) {
        return messageOf([&] { writePng(folder / name, picture); });
    };
    const auto read = [&](const std::string& name) {
        return messageOf([&] { readPng(folder / name); });
    };
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    CHECK(write("no/a.png") == path("no/a.png") + ": cannot be written: No such file or directory");
    CHECK(read("a.png") == path("a.png") + ": cannot be read: No such file or directory");
    CHECK(folder.count() == 0);

    // A folder of that name: the file beside it must go.
    std::filesystem::create_directory(folder / "taken.png");
    CHECK(write("taken.png") == path("taken.png") + ": cannot be written: Is a directory");
    CHECK(read("taken.png") == path("taken.png") + ": cannot be read: Is a directory");
    CHECK(folder.count() == 1);

    std::ofstream(folder / "text.png") << "no picture";
    CHECK(read("text.png").starts_with(path("text.png") + ": is not a whole PNG: "));
    writePng(folder / "half.png", picture);
    std::filesystem::resize_file(folder / "half.png", 2000);
    CHECK(read("half.png").starts_with(path("half.png") + ": is not a whole PNG: "));
    CHECK_THROWS_AS(writePng(folder / "empty.png", Picture{}), std::invalid_argument);
    CHECK(folder.count() == 3);
}

TEST_CASE("A full disk leaves the old PNG and nothing beside it", "[image]") {
    const ScratchFolder folder;
    const Picture old = studio(32, 18);
    writePng(folder / "a.png", old);
    std::string message;
    {
        const FullDisk full(1000);
        message = messageOf([&] { writePng(folder / "a.png", noise(100, 100)); });
    }
    CHECK(message == (folder / "a.png").string() + ": cannot be written: File too large");
    CHECK(readPng(folder / "a.png") == old);
    CHECK(folder.count() == 1);
}

TEST_CASE("The caption strip covers its part of the picture and fades in", "[image]") {
    const Picture plain = studio(640, 360);
    const Caption caption{"Flag", "xpbd   15 substeps   1.84 %"};
    const auto with = [&](double fade) {
        Picture picture = plain;
        drawCaption(picture, {caption.title, caption.numbers, fade});
        return picture;
    };
    const Picture whole = with(1);
    CHECK(with(0) == plain);
    const std::size_t strip = 3 * 640 * (360 - 32);
    CHECK(std::equal(plain.rgb.begin(), plain.rgb.begin() + strip, whole.rgb.begin()));
    // The rule on top, in the look book's vermilion.
    for (int x = 0; x < 640; ++x)
        REQUIRE(std::equal(&whole.rgb[strip + 3 * x], &whole.rgb[strip + 3 * x] + 3,
                           std::array<std::uint8_t, 3>{0xc8, 0x32, 0x1f}.begin()));
    // Ink over 72 % of what was there.
    const std::size_t last = plain.rgb.size() - 3;
    CHECK(whole.rgb[last] == std::lround(0.28 * plain.rgb[last] + 0.72 * 0x16));
    CHECK(with(0.5).rgb[last] == std::lround(0.64 * plain.rgb[last] + 0.36 * 0x16));
}

TEST_CASE("A long caption stays between the margins", "[image]") {
    Picture picture = filled(360, 360, ink);
    drawCaption(picture, {"A title of a length that nobody expects", std::string(60, '8')});
    for (int y = 330; y < 360; ++y)
        for (const int x : {0, 10, 18, 341, 350, 359})
            REQUIRE(picture.rgb[3 * (y * 360 + x)] == ink.r);
}

TEST_CASE("Text is as wide as it is said to be, kerned, its digits alike", "[image]") {
    const TextStyle style{.size = 40}, tabular{.size = 40, .tabular = true};
    CHECK(textWidth("AVAVAV", style) < 3 * textWidth("A", style) + 3 * textWidth("V", style) - 5);
    CHECK(textWidth("1111", tabular) == Approx(textWidth("0987", tabular)));
    CHECK(textWidth("\u2212\u00d7\u00b5", style) > 40);
    CHECK(textWidth("\xff", style) > 0);
    CHECK(textWidth("", style) == 0);

    Picture picture = filled(300, 60, {0, 0, 0});
    drawText(picture, 20, 45, "Hm", {.size = 40, .color = {255, 255, 255}});
    int left = 300, right = 0, top = 60, bottom = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 300; ++x)
            if (picture.rgb[3 * (y * 300 + x)] > 127) {
                left = std::min(left, x), right = std::max(right, x + 1);
                top = std::min(top, y), bottom = std::max(bottom, y + 1);
            }
    CHECK(bottom == 45);
    CHECK(std::abs(45 - top - capHeight(style)) < 1);
    CHECK(left >= 20);
    CHECK(right <= 20 + textWidth("Hm", style));
    CHECK(right - left > 0.85 * textWidth("Hm", style));
    // Half outside, or wholly: what is inside is drawn.
    drawText(picture, -50, 5, "Hm, far outside, and longer than the picture is", style);
    drawText(picture, 1000, 1000, "Hm", style);
}

TEST_CASE("A legend of any range is drawn into its corner", "[image]") {
    for (const Legend& legend :
         {Legend{"Stretch", "%", -1.5f, 2.5f, Palette::diverging}, Legend{"Speed", "m/s", 0, 0},
          Legend{"Speed", "m/s", 0, 12.7f}, Legend{"Speed", "m/s", 0, 1e-7f},
          Legend{"Set", "", 0, 5, Palette::categories},
          Legend{"Broken", "", 0, std::numeric_limits<float>::infinity()}}) {
        Picture picture = studio(640, 360);
        const Picture before = picture;
        drawLegend(picture, legend);
        CHECK(picture != before);
        const std::size_t below = 3 * 640 * 70;
        CHECK(
            std::equal(picture.rgb.begin() + below, picture.rgb.end(), before.rgb.begin() + below));
    }
}

TEST_CASE("A contact sheet shows twelve frames from the first to the last", "[image]") {
    CHECK(sheetFrames(240) ==
          std::vector<int>{0, 22, 43, 65, 87, 109, 130, 152, 174, 196, 217, 239});
    CHECK(sheetFrames(3) == std::vector<int>{0, 1, 2});
    CHECK(sheetFrames(1) == std::vector<int>{0});
    CHECK(sheetFrames(0).empty());

    // One colour a frame: each is found in the order of reading.
    std::vector<SheetFrame> frames;
    for (int i = 0; i < 12; ++i)
        frames.push_back({filled(64, 36, {static_cast<std::uint8_t>(20 * i), 0, 255}), i / 24.0});
    const Picture sheet = contactSheet(frames, "Flag", 480);
    CHECK(sheet.width == 480);
    std::vector<int> seen;
    for (std::size_t i = 0; i < sheet.rgb.size(); i += 3)
        if (sheet.rgb[i + 1] == 0 && sheet.rgb[i + 2] == 255 &&
            std::find(seen.begin(), seen.end(), sheet.rgb[i] / 20) == seen.end())
            seen.push_back(sheet.rgb[i] / 20);
    CHECK(seen == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    CHECK_THROWS_AS(contactSheet({}, "nothing"), std::invalid_argument);
}
