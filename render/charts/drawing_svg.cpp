#include "drawing.h"

#include "chart.h"

#include <cstdio>

namespace plait {
namespace {

// Hundredths of a px, without the zeros that say nothing.
std::string number(double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%.2f", value);
    std::string result = text;
    while (result.back() == '0') result.pop_back();
    if (result.back() == '.') result.pop_back();
    return result == "-0" ? "0" : result;
}

std::string name(Color color) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", color.r, color.g, color.b);
    return text;
}

std::string attribute(std::string_view key, std::string_view value) {
    return " " + std::string(key) + "=\"" + std::string(value) + "\"";
}

std::string path(const std::vector<PagePoint>& points, bool closed) {
    std::string d;
    for (const PagePoint& p : points)
        d += (d.empty() ? "M" : "L") + number(p.x) + " " + number(p.y);
    return "<path" + attribute("d", closed ? d + "Z" : d);
}

struct Writer {
    std::string svg;

    void operator()(const Stroke& stroke) {
        svg += path(stroke.points, stroke.closed) + attribute("fill", "none") +
               attribute("stroke", name(stroke.color)) +
               attribute("stroke-width", number(stroke.width));
        std::string dash;
        for (const double length : stroke.dash) dash += (dash.empty() ? "" : " ") + number(length);
        if (!dash.empty()) svg += attribute("stroke-dasharray", dash);
        svg += "/>\n";
    }

    void operator()(const Area& area) {
        svg += path(area.points, true) + attribute("fill", name(area.color));
        if (area.alpha < 1) svg += attribute("fill-opacity", number(area.alpha));
        if (area.crisp) svg += attribute("shape-rendering", "crispEdges");
        svg += "/>\n";
    }

    void operator()(const Disc& disc) {
        svg += "<circle" + attribute("cx", number(disc.center.x)) +
               attribute("cy", number(disc.center.y)) + attribute("r", number(disc.radius)) +
               attribute("fill", name(disc.color)) + "/>\n";
    }

    // Its length is given, so that another typeface takes the same room.
    void operator()(const Word& word) {
        svg += "<text" + attribute("x", number(word.x)) + attribute("y", number(word.baseline)) +
               attribute("font-size", number(word.style.size)) +
               attribute("fill", name(word.style.color));
        if (word.style.weight == Weight::semibold) svg += attribute("font-weight", "600");
        svg += attribute("textLength", number(textWidth(word.text, word.style))) +
               attribute("lengthAdjust", "spacingAndGlyphs") + ">" + escaped(word.text) +
               "</text>\n";
    }
};

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text)
        result += c == '&'                              ? "&amp;"
                  : c == '<'                            ? "&lt;"
                  : c == '>'                            ? "&gt;"
                  : c == '"'                            ? "&quot;"
                  : static_cast<unsigned char>(c) < ' ' ? " "
                                                        : std::string(1, c);
    return result;
}

std::string drawingSvg(const Drawing& drawing) {
    const std::string width = std::to_string(drawing.width);
    const std::string height = std::to_string(drawing.height);
    Writer writer;
    writer.svg = "<svg" + attribute("xmlns", "http://www.w3.org/2000/svg") +
                 attribute("width", width) + attribute("height", height) +
                 attribute("viewBox", "0 0 " + width + " " + height) +
                 attribute("font-family", "Inter, DejaVu Sans, sans-serif") +
                 attribute("stroke-linejoin", "round") + ">\n<title>" + escaped(drawing.title) +
                 "</title>\n<rect" + attribute("width", "100%") + attribute("height", "100%") +
                 attribute("fill", name(drawing.ground)) + "/>\n";
    for (const auto& item : drawing.items) std::visit(writer, item);
    return writer.svg + "</svg>\n";
}

}  // namespace plait
