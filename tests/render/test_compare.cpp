#include "render/pictures/compare.h"
#include "render/pictures/image.h"
#include "render/pictures/paint.h"
#include "studio.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/scratch_folder.h"
#include "video_reader.h"

#include <cstdio>

using namespace plait;
using namespace plait::test;

namespace {

// Size of the goldens.
constexpr int width = 480, height = 270;

Picture withPixels(Picture picture, int count, int change) {
    for (int i = 0; i < count; ++i) {
        auto& c = picture.rgb[3 * (37 * i % (width * height)) + i % 3];
        c = static_cast<std::uint8_t>(c < 128 ? c + change : c - change);
    }
    return picture;
}

}  // namespace

TEST_CASE("A comparison counts what differs", "[compare]") {
    const Picture golden = studio(width, height);
    CHECK(passes(compare(golden, golden), tightRule));
    const Comparison three = compare(withPixels(golden, 1000, 3), golden);
    CHECK(three.beyond3 == 0);
    CHECK(three.largest == 3);
    const Comparison four = compare(withPixels(golden, 1000, 4), golden);
    CHECK(four.beyond3 == Approx(1000.0 / (width * height)));
    CHECK(four.beyond8 == 0);
    CHECK(compare(withPixels(golden, 1000, 8), golden).beyond8 == 0);
    const Comparison nine = compare(withPixels(golden, 1000, 9), golden);
    CHECK(nine.beyond3 == nine.beyond8);
    CHECK(nine.beyond8 == Approx(1000.0 / (width * height)));
    CHECK(nine.largest == 9);
    CHECK(nine.meanFlip > four.meanFlip);
}

TEST_CASE("The rules stand where they say", "[compare]") {
    const Picture golden = studio(width, height);
    // 0.05 % of 129,600 pixels are 64.8; 2 % are 2592.
    CHECK(passes(compare(withPixels(golden, 64, 4), golden), tightRule));
    CHECK_FALSE(passes(compare(withPixels(golden, 65, 4), golden), tightRule));
    CHECK(passes(compare(withPixels(golden, 2592, 9), golden), looseRule));
    CHECK_FALSE(passes(compare(withPixels(golden, 2593, 9), golden), looseRule));
    // A tint that no single pixel betrays.
    Picture tinted = golden;
    for (std::size_t i = 0; i < tinted.rgb.size(); i += 3)
        tinted.rgb[i] = static_cast<std::uint8_t>(std::min(255, tinted.rgb[i] + 3));
    const Comparison tint = compare(tinted, golden);
    CHECK(tint.beyond3 == 0);
    CHECK_FALSE(passes(tint, tightRule));
    // Nothing passes for something.
    CHECK_FALSE(passes(compare({}, golden), looseRule));
    CHECK_FALSE(passes(compare(golden, {}), looseRule));
    CHECK_FALSE(passes(compare({}, {}), looseRule));
    CHECK_FALSE(passes(compare(studio(height, width), golden), looseRule));
}

TEST_CASE("A doctored picture does not pass for its golden", "[compare]") {
    const Studio original;
    const Picture golden = studio(width, height);
    const auto rejected = [&](const char* what, const Picture& doctored, const PassRule& rule) {
        const Comparison c = compare(doctored, golden);
        std::printf("    %-24s %s\n", what, describe(c).c_str());
        return !passes(c, rule) && (rule.beyond3 == 1 || c.beyond3 > rule.beyond3) &&
               (rule.meanFlip > 1 || c.meanFlip > rule.meanFlip);
    };
    const Picture moved = studio(width, height, {.shift = 1});
    const Picture swapped =
        studio(width, height, {.cloth = original.stripe, .stripe = original.cloth});
    const Picture blank = filled(width, height, ink);
    // Both halves of the tight rule reject each of them.
    CHECK(rejected("moved by one pixel", moved, tightRule));
    CHECK(rejected("moved by a quarter", studio(width, height, {.shift = 0.25}), tightRule));
    CHECK(rejected("colours swapped", swapped, tightRule));
    CHECK(rejected("blank", blank, tightRule));
    CHECK(rejected("mirrored", mirrored(golden), tightRule));
    // So does the loose one.
    for (const Picture& doctored : {moved, swapped, blank, mirrored(golden)})
        CHECK_FALSE(passes(compare(doctored, golden), looseRule));
}

TEST_CASE("A failure stands on a page beside its golden", "[compare]") {
    const ScratchFolder folder;
    const Picture golden = studio(96, 54), actual = studio(96, 54, {.shift = 4});
    const auto page = writeComparisonPage(
        folder / "failed",
        std::vector<ComparisonEntry>{{"flag <1>", actual, golden}, {"no golden", actual, {}}});
    CHECK(page == folder / "failed/index.html");
    const auto bytes = readBytes(page);
    const std::string text(bytes.begin(), bytes.end());
    for (const char* what : {"actual", "golden", "difference", "flip"}) {
        const std::string file = std::string("flag--1--") + what + ".png";
        CHECK(text.find("<img src=\"" + file + "\">") != std::string::npos);
        CHECK(readPng(folder / ("failed/" + file)).width == 96);
    }
    CHECK(text.find("<1>") == std::string::npos);
    CHECK(text.find(describe(compare(actual, golden))) != std::string::npos);
    CHECK(readPng(folder / "failed/flag--1--actual.png") == actual);
    CHECK(readPng(folder / "failed/flag--1--golden.png") == golden);
    // Black where nothing differs: the upper left corner is backdrop in both.
    const Picture difference = readPng(folder / "failed/flag--1--difference.png");
    CHECK(difference.rgb[0] + difference.rgb[1] + difference.rgb[2] == 0);
    CHECK(text.find("no-golden-actual.png") != std::string::npos);
    CHECK(text.find("no-golden-golden.png") == std::string::npos);
    CHECK_THROWS_AS(writeComparisonPage("/dev/null/x", {}), std::runtime_error);
}
