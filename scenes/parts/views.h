// How the small scenes are looked at.
#pragma once

#include "../view.h"

#include <vector>

namespace plait {

// Brass and steel in the colours of their metals, matte in slate, all else vermilion.
Look lookOf(const Range& object, Material material, double radius);

// A camera that looks `from` a side at the middle of the action, which is `size` (m) across, over
// a ground just below it; every object looks the same. Narrow pictures keep 0.85 of the width.
View viewOf(const std::vector<Range>& objects, const Vec<double>& middle, double size,
            Material material, const Vec<double>& from = {0.55, 0.3, 2.6});

// The camera travels at this velocity (m/s) from where it is at time 0, without end and without a
// ground, which would stay behind.
void travel(View& view, const Vec<double>& velocity);

// A dark hall with a spotlight on a subject of this size (m), over a floor that mirrors faintly.
Stage theatre(double size);

// A round bar with flat ends.
void addBar(View& view, const Vec<double>& from, const Vec<double>& to, double radius,
            Material material);

// A slate box between two corners, each coordinate of `low` the lesser.
void addBox(View& view, const Vec<double>& low, const Vec<double>& high);

// A round slate peg along z behind the point `front`.
void addPeg(View& view, const Vec<double>& front, double radius);

// A profile, radius and height (m) of each ring from below, turned around y; vertices ring by ring.
Shape turned(const std::vector<std::array<double, 2>>& profile, int sides = 48);

}  // namespace plait
