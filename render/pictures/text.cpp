#include "text.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace plait {
namespace {

struct Font {
    std::vector<unsigned char> bytes;
    stbtt_fontinfo info;
    int digitAdvance = 0, capHeight = 0;  // font units
};

// Debian, Fedora, Arch.
constexpr const char* folders[] = {"/usr/share/fonts/opentype/inter/",
                                   "/usr/share/fonts/rsms-inter-fonts/",
                                   "/usr/share/fonts/inter/",
                                   "/usr/share/fonts/truetype/dejavu/",
                                   "/usr/share/fonts/dejavu-sans-fonts/",
                                   "/usr/share/fonts/TTF/"};
constexpr const char* regularFiles[] = {"Inter-Regular.otf", "Inter-Regular.ttf", "DejaVuSans.ttf"};
constexpr const char* semiboldFiles[] = {"Inter-SemiBold.otf", "Inter-SemiBold.ttf",
                                         "DejaVuSans-Bold.ttf"};

bool read(const std::string& path, Font& font) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return false;
    font.bytes.assign(std::istreambuf_iterator<char>(file), {});
    if (!stbtt_InitFont(&font.info, font.bytes.data(), 0)) return false;
    int unused = 0;
    for (int digit = '0'; digit <= '9'; ++digit) {
        int advance = 0;
        stbtt_GetCodepointHMetrics(&font.info, digit, &advance, &unused);
        font.digitAdvance = std::max(font.digitAdvance, advance);
    }
    stbtt_GetCodepointBox(&font.info, 'H', &unused, &unused, &unused, &font.capHeight);
    return true;
}

Font load(Weight weight) {
    Font font;
    for (const char* file : weight == Weight::regular ? regularFiles : semiboldFiles)
        for (const char* folder : folders)
            if (read(std::string(folder) + file, font)) return font;
    throw std::runtime_error("no font to write with: install fonts-inter or fonts-dejavu-core");
}

const Font& fontOf(Weight weight) {
    if (weight == Weight::regular) {
        static const Font regular = load(Weight::regular);
        return regular;
    }
    static const Font semibold = load(Weight::semibold);
    return semibold;
}

// UTF-8; a byte that fits nowhere stands for itself.
std::vector<int> codepoints(std::string_view text) {
    std::vector<int> result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t more = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc0 ? 1 : 0;
        if (more == 0 || i + more >= text.size()) {
            result.push_back(lead);
            continue;
        }
        int code = lead & (0x3f >> more);
        for (std::size_t k = 0; k < more; ++k)
            code = (code << 6) | (static_cast<unsigned char>(text[++i]) & 0x3f);
        result.push_back(code);
    }
    return result;
}

// Calls place(glyph, x) for each glyph, x in font units from the start; returns the width.
template <class Place>
int layOut(const Font& font, std::string_view text, bool tabular, Place place) {
    int x = 0, before = -1;
    for (const int code : codepoints(text)) {
        const int glyph = stbtt_FindGlyphIndex(&font.info, code);
        int advance = 0, bearing = 0;
        stbtt_GetGlyphHMetrics(&font.info, glyph, &advance, &bearing);
        const bool cell = tabular && code >= '0' && code <= '9';
        if (before >= 0 && !cell) x += stbtt_GetGlyphKernAdvance(&font.info, before, glyph);
        place(glyph, cell ? x + (font.digitAdvance - advance) / 2 : x);
        x += cell ? font.digitAdvance : advance;
        before = cell ? -1 : glyph;
    }
    return x;
}

void drawGlyph(Picture& picture, const Font& font, int glyph, double x, double baseline,
               const TextStyle& style) {
    const float scale = stbtt_ScaleForMappingEmToPixels(&font.info, static_cast<float>(style.size));
    const double left = std::floor(x), top = std::floor(baseline);
    const auto shiftX = static_cast<float>(x - left), shiftY = static_cast<float>(baseline - top);
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&font.info, glyph, scale, scale, shiftX, shiftY, &x0, &y0, &x1,
                                    &y1);
    const int width = x1 - x0, height = y1 - y0;
    if (width <= 0 || height <= 0) return;
    std::vector<unsigned char> coverage(static_cast<std::size_t>(width * height));
    stbtt_MakeGlyphBitmapSubpixel(&font.info, coverage.data(), width, height, width, scale, scale,
                                  shiftX, shiftY, glyph);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const int px = static_cast<int>(left) + x0 + column;
            const int py = static_cast<int>(top) + y0 + row;
            if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
            paint(picture, px, py, style.color,
                  style.alpha * coverage[row * width + column] / 255.0);
        }
}

double pixels(const Font& font, int units, const TextStyle& style) {
    return units * static_cast<double>(
                       stbtt_ScaleForMappingEmToPixels(&font.info, static_cast<float>(style.size)));
}

}  // namespace

double textWidth(std::string_view text, const TextStyle& style) {
    const Font& font = fontOf(style.weight);
    return pixels(font, layOut(font, text, style.tabular, [](int, int) {}), style);
}

double capHeight(const TextStyle& style) {
    const Font& font = fontOf(style.weight);
    return pixels(font, font.capHeight, style);
}

void drawText(Picture& picture, double x, double baseline, std::string_view text,
              const TextStyle& style) {
    const Font& font = fontOf(style.weight);
    layOut(font, text, style.tabular, [&](int glyph, int units) {
        drawGlyph(picture, font, glyph, x + pixels(font, units, style), baseline, style);
    });
}

}  // namespace plait
