#include "compare.h"

#include "flip.h"
#include "image.h"
#include "whole_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace plait {
namespace {

// Black over violet and orange to pale yellow: the way of the magma map, in nine steps.
constexpr std::array<std::array<double, 3>, 9> heat{{{0, 0, 4},
                                                     {28, 16, 68},
                                                     {79, 18, 123},
                                                     {129, 37, 129},
                                                     {181, 54, 122},
                                                     {229, 80, 100},
                                                     {251, 135, 97},
                                                     {254, 194, 135},
                                                     {252, 253, 191}}};

Picture drawFlip(const FlipMap& map) {
    Picture picture{map.width, map.height, {}};
    for (const double error : map.errors) {
        const double s = 8 * std::clamp(error, 0.0, 1.0);
        const int i = std::min(static_cast<int>(s), 7);
        for (int k = 0; k < 3; ++k) {
            const double v = std::lerp(heat[i][k], heat[i + 1][k], s - i);
            picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(v)));
        }
    }
    return picture;
}

Picture drawDifference(const Picture& a, const Picture& b) {
    Picture picture = a;
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        picture.rgb[i] =
            static_cast<std::uint8_t>(std::min(255, 8 * std::abs(a.rgb[i] - b.rgb[i])));
    return picture;
}

// A name that is one word of a file name and of a page.
std::string plain(std::string name) {
    for (char& c : name) {
        const bool good =
            (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        if (!good && c != '_' && c != '.') c = '-';
    }
    return name;
}

constexpr auto pageHead = R"(<!doctype html>
<meta charset="utf-8">
<title>Pictures and their goldens</title>
<style>
body { background: #16202c; color: #f1e6d4; font: 15px Inter, sans-serif; margin: 32px; }
h2 { font-weight: 600; margin: 32px 0 4px; border-top: 2px solid #c8321f; padding-top: 12px; }
p { color: #a9b2ba; margin: 0 0 12px; font-variant-numeric: tabular-nums; }
div { display: grid; grid-template-columns: repeat(4, 1fr); gap: 12px; }
figure { margin: 0; }
img { width: 100%; image-rendering: pixelated; }
figcaption { color: #a9b2ba; }
</style>
)";

}  // namespace

Comparison compare(const Picture& actual, const Picture& golden) {
    Comparison result;
    result.sameSize =
        actual.width == golden.width && actual.height == golden.height && !actual.rgb.empty();
    if (!result.sameSize) return result;
    const auto pixels = static_cast<int>(actual.rgb.size() / 3);
    int beyond3 = 0, beyond8 = 0;
    for (int i = 0; i < pixels; ++i) {
        int difference = 0;
        for (int k = 3 * i; k < 3 * i + 3; ++k)
            difference = std::max(difference, std::abs(actual.rgb[k] - golden.rgb[k]));
        beyond3 += difference > 3;
        beyond8 += difference > 8;
        result.largest = std::max(result.largest, difference);
    }
    result.beyond3 = beyond3 / static_cast<double>(pixels);
    result.beyond8 = beyond8 / static_cast<double>(pixels);
    result.meanFlip = flip(actual, golden).mean;
    return result;
}

bool passes(const Comparison& comparison, const PassRule& rule) {
    return comparison.sameSize && comparison.beyond3 <= rule.beyond3 &&
           comparison.beyond8 <= rule.beyond8 && comparison.meanFlip <= rule.meanFlip;
}

std::string describe(const Comparison& comparison) {
    if (!comparison.sameSize) return "different sizes or nothing to compare";
    char text[160];
    std::snprintf(text, sizeof text,
                  "%.3f %% of pixels beyond 3/255, %.3f %% beyond 8/255, largest %d/255, "
                  "mean FLIP %.5f",
                  100 * comparison.beyond3, 100 * comparison.beyond8, comparison.largest,
                  comparison.meanFlip);
    return text;
}

std::filesystem::path writeComparisonPage(const std::filesystem::path& folder,
                                          std::span<const ComparisonEntry> entries) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw FileError(folder.string() + ": cannot be made: " + error.message());
    std::string page = pageHead;
    for (const ComparisonEntry& entry : entries) {
        const auto& [name, actual, golden] = entry;
        const Comparison comparison = compare(actual, golden);
        page += "<h2>" + plain(name) + "</h2>\n<p>" + describe(comparison) + "</p>\n<div>\n";
        const auto add = [&](const char* what, const Picture& picture) {
            if (picture.rgb.empty()) return;  // a golden that is not there
            const std::string file = plain(entry.name) + "-" + what + ".png";
            writePng(folder / file, picture);
            page.append("<figure><img src=\"").append(file).append("\"><figcaption>");
            page.append(what).append("</figcaption></figure>\n");
        };
        add("actual", actual);
        add("golden", golden);
        if (comparison.sameSize) {
            add("difference", drawDifference(actual, golden));
            add("flip", drawFlip(flip(actual, golden)));
        }
        page += "</div>\n";
    }
    writeWhole(folder / "index.html", page);
    return folder / "index.html";
}

}  // namespace plait
