// LDR-FLIP: how different two pictures look when they alternate on one screen.
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: "FLIP: A Difference Evaluator
// for Alternating Images", HPG 2020. Section and equation numbers in flip.cpp are its own.
#pragma once

#include "picture.h"

#include <vector>

namespace plait {

// The paper's viewer: 0.7 m before a screen 0.7 m and 3840 pixels wide.
inline constexpr double flipPixelsPerDegree = 67.02064327658226;

struct FlipMap {
    int width = 0, height = 0;
    std::vector<double> errors = {};  // by pixel, top row first, 0 (the same) to 1
    double mean = 0;
};

// Symmetric. Beyond the border a picture goes on with its border pixels. Throws
// std::invalid_argument for pictures of different or no size.
FlipMap flip(const Picture& a, const Picture& b, double pixelsPerDegree = flipPixelsPerDegree);

}  // namespace plait
