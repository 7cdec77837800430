#include "skeleton.h"

#include <plait/numbers/elementary.h>

namespace plait::dancer {
namespace {

constexpr double fullPoint = 1.08, fullRise = 1.5707963267948966;  // rad: of foot and toes

Point sided(const Point& p, std::size_t side) { return side == 0 ? p : mirrored(p); }
Axes sided(const Axes& a, std::size_t side) { return side == 0 ? a : mirrored(a); }

// Turned about x, toes down.
Axes pitched(const Axes& a, double angle) {
    const double c = cosine(angle), s = sine(angle);
    return {a.x, c * a.y + s * a.z, c * a.z - s * a.y};
}

// Two bones from `limb.root` to its end, bent towards `pole`. They give a little where the end is
// out of reach.
void bend(PosedLimb& limb, const RestLimb& rest, const Point& pole, const Axes& parent) {
    const Point d = limb.end - limb.root;
    const double reach = length(d), whole = rest.upper + rest.lower;
    const double give = smoothMax(1, reach / (0.9988 * whole), 0.0012);
    const double a = give * rest.upper, b = give * rest.lower;
    const double along = (a * a - b * b + reach * reach) / (2 * reach);
    const double across = squareRoot(std::max(a * a - along * along, 0.0));
    const Axes plane = axesOf(d, pole);
    limb.middle = limb.root - along * plane.y + across * plane.z;
    const auto bone = [&](const Point& down) {
        const Point y = -unit(down);
        return Axes{plane.x, y, cross(plane.x, y)};
    };
    const Axes back = transposed(rest.axes);
    limb.upper = bone(limb.middle - limb.root) * back;
    limb.lower = bone(limb.end - limb.middle) * back;
    limb.top = swing(-(parent * rest.axes.y), unit(limb.middle - limb.root)) * parent;
}

struct PlantedFoot {
    Axes foot, toes;
    Point ankle;
};

// Heel first, then over the ball onto the tip, which rolls.
PlantedFoot plant(const LegControl& leg, std::size_t side) {
    const double heading = side == 0 ? leg.heading : -leg.heading;
    const Point forward{sine(heading), 0, cosine(heading)};
    const Axes flat{cross(Point{0, 1, 0}, forward), {0, 1, 0}, forward};
    const double roll = fullRise * step(leg.rise, 0.3, 1.0);
    PlantedFoot planted{pitched(flat, fullPoint * leg.rise), pitched(flat, roll), {}};
    const Point tip =
        sided(leg.tip + Point{0, toeRadius, 0}, side) + toeRadius * (roll - fullRise) * forward;
    const Point joint = tip - planted.toes * (toeTip - ball);
    planted.ankle = joint - planted.foot * ball;
    return planted;
}

PosedLimb poseLeg(const Controls& controls, const Posed& posed, std::size_t side) {
    static const RestLimb rest = restLeg();
    static const Axes restToes = transposed(restFoot());
    const LegControl& leg = controls.legs[side];
    const Axes pelvis = sided(controls.pelvis, side);
    const PlantedFoot planted = plant(leg, side);
    PosedLimb limb;
    limb.root = sided(posed.hips, side) + pelvis * Point{rest.root.x, 0, 0};
    const double whole = rest.upper + rest.lower;
    const Point free = limb.root + leg.extension * whole * (pelvis * unit(leg.reach));
    limb.end = mix(free, planted.ankle, leg.planted);
    // A foot that comes or goes does not stretch its leg.
    const double reach = length(limb.end - limb.root);
    const double held = whole * smoothMin(reach / whole, 0.985, 0.03);
    limb.end = limb.root +
               (1 + (held / reach - 1) * (1 - step(leg.planted, 0.9, 1))) * (limb.end - limb.root);
    const Point knee =
        mix(unit(pelvis * leg.knee), planted.foot.z + 0.6 * planted.foot.y, leg.planted);
    bend(limb, rest, {knee.x, knee.y, knee.z}, pelvis);
    const Axes shank = limb.lower * rest.axes;
    const Axes foot = pitched(shank, fullPoint * 1.25 * leg.pointed);
    const Axes toes = pitched(foot, 0.3 * leg.pointed);
    limb.last = axesOf(mix(quaternion(foot), quaternion(planted.foot), leg.planted)) * restToes;
    limb.tip = axesOf(mix(quaternion(toes), quaternion(planted.toes), leg.planted)) * restToes;
    return limb;
}

PosedLimb poseArm(const Controls& controls, const Posed& posed, std::size_t side) {
    static const RestLimb rest = restArm();
    const ArmControl& arm = controls.arms[side];
    const Axes chest = sided(controls.chest, side);
    const Point reach = unit(arm.reach);
    PosedLimb limb;
    // The shoulder rises with the arm and goes with it to the front.
    const Point shoulder = rest.root - Point{0, ribsHeight, 0} +
                           Point{-0.012 * step(reach.y, 0.2, 1), 0.045 * step(reach.y, 0, 1.2),
                                 0.025 * step(reach.z, 0.2, 1.1)} -
                           Point{0, 0.012, 0};
    limb.root = sided(posed.ribs, side) + chest * shoulder;
    limb.end = limb.root + arm.extension * (rest.upper + rest.lower) * (chest * reach);
    bend(limb, rest, chest * arm.elbow, chest);
    // The hand, which gives in to its palm a little. The palm looks along x of the limb's frame.
    const Point forearm = unit(limb.end - limb.middle), palm = unit(chest * arm.palm);
    const Point y = -unit(forearm + 0.25 * (palm - dot(palm, forearm) * forearm));
    const Point z = unit(cross(palm, y));
    limb.last = Axes{cross(y, z), y, z} * transposed(rest.axes);
    limb.tip = limb.last;
    return limb;
}

Point centerOfMass(const Posed& p) {
    // Parts of the whole and their centres: de Leva 1996, women.
    Point sum = 0.067 * (p.head + p.skull * Point{0, 0.085, 0.01}) +
                0.125 * (p.hips + p.pelvis * Point{0, 0.04, -0.01}) +
                0.147 * mix(p.waist, p.ribs, 0.4) + 0.154 * (p.ribs + p.chest * Point{0, 0.09, 0});
    for (std::size_t side = 0; side < 2; ++side) {
        const PosedLimb &arm = p.arms[side], &leg = p.legs[side];
        const Point hand = arm.end - arm.last * (0.08 * restArm().axes.y);
        const Point foot = leg.end + leg.last * (restFoot() * Point{0, -0.04, 0.06});
        const Point limbs = 0.0255 * mix(arm.root, arm.middle, 0.575) +
                            0.0138 * mix(arm.middle, arm.end, 0.456) + 0.0056 * hand +
                            0.1478 * mix(leg.root, leg.middle, 0.361) +
                            0.0481 * mix(leg.middle, leg.end, 0.442) + 0.0129 * foot;
        sum += sided(limbs, side);
    }
    return sum;
}

// How high the hips may be for the planted legs to reach.
double greatestLift(const Controls& controls, const Posed& posed) {
    double limit = 10;
    const RestLimb rest = restLeg();
    const double whole = 0.9988 * (rest.upper + rest.lower);
    for (std::size_t side = 0; side < 2; ++side) {
        const LegControl& leg = controls.legs[side];
        const Point hip =
            sided(posed.hips, side) + sided(controls.pelvis, side) * Point{rest.root.x, 0, 0};
        const Point d = plant(leg, side).ankle - hip;
        const double up = squareRoot(std::max(whole * whole - d.x * d.x - d.z * d.z, 1e-4));
        const double reach = posed.hips.y + d.y + up;
        limit = smoothMin(limit, reach + (1 - leg.planted), 0.02);
    }
    return limit;
}

void placeSpine(Posed& p) {
    p.waist = p.hips + p.pelvis * Point{0, waistHeight - hipHeight, 0};
    p.ribs = p.waist + p.lumbar * Point{0, ribsHeight - waistHeight, 0};
    p.neck = p.ribs + p.chest * Point{0, neckHeight - ribsHeight, 0};
    p.head = p.neck + p.nape * Point{0, headHeight - neckHeight, 0};
}

}  // namespace

Posed pose(const Controls& controls) {
    Posed p;
    p.pelvis = controls.pelvis;
    p.chest = controls.chest;
    p.skull = controls.head;
    const Quaternion pelvis = quaternion(p.pelvis), chest = quaternion(p.chest);
    p.lumbar = axesOf(mix(pelvis, chest, 0.5));
    p.nape = axesOf(mix(chest, quaternion(p.skull), 0.45));
    p.hips = {controls.balance.x, hipHeight, controls.balance.z};
    // The hips go where the centre of mass asks for; the legs on the floor lag, so again.
    for (int i = 0; i < 8; ++i) {
        placeSpine(p);
        for (std::size_t side = 0; side < 2; ++side) {
            p.arms[side] = poseArm(controls, p, side);
            p.legs[side] = poseLeg(controls, p, side);
        }
        p.balance = centerOfMass(p);
        if (i == 7) break;
        const Point off = controls.balance - p.balance;
        p.hips += Point{off.x, 0, off.z};
        const double stood = smoothMin(controls.balance.y, greatestLift(controls, p), 0.02);
        const double flown = p.hips.y + controls.flightHeight - p.balance.y;
        p.hips.y = stood + controls.flight * (flown - stood);
    }
    return p;
}

}  // namespace plait::dancer
