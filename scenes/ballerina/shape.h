// The ballerina's shape: where her joints are at rest, and the field whose zero is her skin.
// Metres; y up, she faces z, x to her left. At rest her arms are held to the sides and her legs
// are apart, turned out, with feet half pointed: the middle of what she will do.
#pragma once

#include "math.h"

namespace plait::dancer {

// A limb at rest, of her left side: straight from root to end. Its frame has y upward along the
// limb; z is the side that a bent knee points to, or an elbow.
struct RestLimb {
    Point root;
    Axes axes;
    double upper, lower;  // lengths

    Point at(double s) const { return root - s * axes.y; }
};

RestLimb restArm();
RestLimb restLeg();

// The foot's frame at rest: origin at the ankle, z towards the toes along the sole, y upward.
Axes restFoot();
inline constexpr Point ball{0, -0.057, 0.108};  // in it
inline constexpr Point toeTip{0, -0.060, 0.172};
inline constexpr double toeRadius = 0.015;
inline constexpr double ankleHeight = 0.075;  // over the sole

// Heights of the spine's joints, all at x = 0.
inline constexpr double hipHeight = 0.905, waistHeight = 1.07, ribsHeight = 1.20,
                        neckHeight = 1.425, headHeight = 1.505;

// Less than 0 inside; about the distance to her skin close to it.
double field(const Point& point);

// Its gradient.
Point slope(const Point& p);

// More than 0 under the hair, below the neckline of a bodice, and in the shoes (of the left half);
// about the distance to where they end.
double hair(const Point& p);
double bodice(const Point& p);
double shoe(const Point& p);

}  // namespace plait::dancer
