// Lines, areas and words on a page, before anyone decides whether they become SVG or pixels.
#pragma once

#include "render/pictures/text.h"

#include <string>
#include <variant>
#include <vector>

namespace plait {

// Lengths in px from the upper left corner, y down.
struct PagePoint {
    double x, y;
};

struct PageBox {
    double left, top, right, bottom;
};

inline std::vector<PagePoint> corners(const PageBox& box) {
    return {
        {box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}};
}

struct Stroke {
    std::vector<PagePoint> points;
    bool closed = false;
    Color color = ink;
    double width = 1;
    std::vector<double> dash;  // lengths on, off, on ...; empty: solid
};

struct Area {
    std::vector<PagePoint> points;
    Color color = ink;
    double alpha = 1;
    bool crisp = false;  // to whole pixels, so that neighbours leave no seam
};

struct Disc {
    PagePoint center;
    double radius;
    Color color = ink;
};

struct Word {
    double x, baseline;  // of its left end
    std::string text;
    TextStyle style;
};

struct Drawing {
    int width = 0, height = 0;
    std::string title;  // for those who cannot see it
    Color ground = ivory;
    std::vector<std::variant<Stroke, Area, Disc, Word>> items;  // later ones cover earlier ones
};

// Around the capitals, digits and descenders.
PageBox boxOf(const Word& word);

std::string drawingSvg(const Drawing& drawing);
// `scale` pixels to a px.
Picture drawingPicture(const Drawing& drawing, double scale);
// Over a picture, from its pixel (x, y) on: all but the ground.
void paintDrawing(Picture& picture, double x, double y, const Drawing& drawing, double scale);

}  // namespace plait
