// The ballerina's skeleton: what a moment of the dance asks for, and where that puts her joints.
// Her right limbs are computed as left ones in a mirror: x changes its sign.
#pragma once

#include "shape.h"

#include <array>

namespace plait::dancer {

// Where a wrist is to be, in the frame of the chest; x outward on either side.
struct ArmControl {
    Point reach;       // direction from the shoulder
    double extension;  // of the stretched arm's length
    Point elbow;       // where it points
    Point palm;        // where it looks
};

// A leg is free, or planted, or part of each. Free, in the frame of the pelvis, x outward:
struct LegControl {
    Point reach;       // direction of the ankle from the hip
    double extension;  // of the stretched leg's length
    Point knee;        // where it points
    double pointed;    // 0: foot across the shank, 1: in line with it
    // Planted, in the world; x of the right foot not mirrored.
    double planted;  // 0 to 1
    Point tip;       // where she is on its tip, x and z (m); y is its height over the floor
    double heading;  // rad, from z to x
    double rise;     // 0: on the sole, 1: on the tip
};

struct Controls {
    Axes pelvis, chest, head;  // in the world
    Point balance;  // m: the centre of mass over x and z; y is the pelvis' height, if the
                    // planted legs reach
    double flight;  // 0 to 1: the height of the centre of mass is `flightHeight` instead
    double flightHeight;
    std::array<ArmControl, 2> arms;  // left, right
    std::array<LegControl, 2> legs;
};

// Rotations are relative to the rest pose.
struct PosedLimb {  // of the left, or of the right in the mirror
    Point root, middle, end;
    Axes top, upper, lower, last;  // below the root, above the middle, below it; hand or foot
    Axes tip;                      // toes
};

struct Posed {
    Point hips;                     // between them
    Point waist, ribs, neck, head;  // joints
    Axes pelvis, lumbar, chest, nape, skull;
    std::array<PosedLimb, 2> arms, legs;
    Point balance;  // centre of mass
};

Posed pose(const Controls& controls);

}  // namespace plait::dancer
