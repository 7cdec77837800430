#include "skin.h"

#include <span>

namespace plait::dancer {
namespace {

constexpr double spacing = 0.0125;  // m, of stations

// x -> turn x + shift.
struct Motion {
    Axes turn;
    Point shift;
};

// A joint of a chain: how far along it is at rest, and how far the bend reaches to either side.
struct Joint {
    double s, reach;
};

constexpr std::array<Joint, 6> spineJoints{{{0, 0},
                                            {waistHeight - hipHeight, 0.075},
                                            {ribsHeight - hipHeight, 0.05},
                                            {neckHeight - hipHeight, 0.04},
                                            {headHeight - hipHeight, 0.035},
                                            {0.80, 0}}};
// From where the collar bone starts to beyond the wrist; from within the pelvis to within the foot.
constexpr double inArm = 0.12, inLeg = 0.20, footLength = 0.06;
constexpr std::array<Joint, 5> armJoints{
    {{0, 0}, {inArm, 0.080}, {inArm + 0.28, 0.085}, {inArm + 0.52, 0.045}, {inArm + 0.72, 0}}};
constexpr std::array<Joint, 5> legJoints{{{0, 0},
                                          {inLeg, 0.150},
                                          {inLeg + 0.425, 0.145},
                                          {inLeg + 0.83, 0.045},
                                          {inLeg + 0.83 + footLength, 0}}};
constexpr double toeLength = 0.108 + 0.10;
constexpr std::array<Joint, 3> toeJoints{{{0, 0}, {0.108, 0.032}, {toeLength, 0}}};

int stationsOf(std::span<const Joint> joints) {
    return static_cast<int>(joints.back().s / spacing) + 2;
}

// The posed bones of a chain: where its joints are, and how each bone is turned at either end.
struct Bones {
    std::span<const Joint> joints;
    std::span<const Point> at;
    std::span<const std::array<Quaternion, 2>> turns;
    Point start, along;  // the straight line it is at rest

    Point place(std::size_t bone, double s) const {
        const double from = joints[bone].s, to = joints[bone + 1].s;
        return mix(at[bone], at[bone + 1], (s - from) / (to - from));
    }

    Quaternion turn(std::size_t bone, double s) const {
        return mix(turns[bone][0], turns[bone][1], step(s, joints[bone].s, joints[bone + 1].s));
    }

    Motion station(double s) const {
        std::size_t bone = 0;
        while (bone + 2 < joints.size() && s > joints[bone + 1].s) ++bone;
        for (std::size_t j = std::max<std::size_t>(bone, 1); j < bone + 2; ++j) {
            if (j + 1 >= joints.size()) break;
            const double reach = joints[j].reach, from = joints[j].s - reach;
            const double u = (s - from) / (2 * reach);
            if (u <= 0 || u >= 1) continue;
            const Point a = place(j - 1, from), b = place(j, joints[j].s + reach);
            const Point place = mix(mix(a, at[j], u), mix(at[j], b, u), u);
            const Quaternion turn = mix(this->turn(j - 1, from), this->turn(j, joints[j].s + reach),
                                        u * u * (3 - 2 * u));
            return motion(place, turn, s);
        }
        return motion(place(bone, s), turn(bone, s), s);
    }

    Motion motion(const Point& place, const Quaternion& turn, double s) const {
        const Axes axes = axesOf(turn);
        return {axes, place - axes * (start + s * along)};
    }

    void stations(std::vector<Motion>& all, bool inMirror) const {
        for (int i = 0; i < stationsOf(joints); ++i) {
            const Motion m = station(i * spacing);
            all.push_back(inMirror ? Motion{mirrored(m.turn), mirrored(m.shift)} : m);
        }
    }
};

void addSpine(std::vector<Motion>& all, const Posed& p) {
    const Quaternion pelvis = quaternion(p.pelvis), lumbar = quaternion(p.lumbar),
                     chest = quaternion(p.chest), nape = quaternion(p.nape),
                     skull = quaternion(p.skull);
    const std::array<Point, 6> at{p.hips, p.waist, p.ribs,
                                  p.neck, p.head,  p.head + p.skull * Point{0, 0.2, 0}};
    const std::array<std::array<Quaternion, 2>, 5> turns{
        {{pelvis, pelvis}, {lumbar, lumbar}, {chest, chest}, {nape, nape}, {skull, skull}}};
    Bones{spineJoints, at, turns, {0, hipHeight, 0}, {0, 1, 0}}.stations(all, false);
}

// Its first bone is that of the collar, or the pelvis.
void addLimb(std::vector<Motion>& all, const PosedLimb& limb, const RestLimb& rest,
             std::span<const Joint> joints, const Point& start, const Axes& parent, bool inMirror) {
    const Point down = -rest.axes.y;
    const double before = joints[1].s, after = joints.back().s - joints[joints.size() - 2].s;
    const Axes first = swing(parent * down, unit(limb.root - start)) * parent;
    const std::array<Point, 5> at{start, limb.root, limb.middle, limb.end,
                                  limb.end + after * (limb.last * down)};
    const Quaternion root = quaternion(first), lower = quaternion(limb.lower),
                     last = quaternion(limb.last);
    const Quaternion twisted = quaternion(swing(limb.last * down, limb.lower * down) * limb.last);
    const std::array<std::array<Quaternion, 2>, 4> turns{
        {{quaternion(parent), root},
         {quaternion(limb.top), quaternion(limb.upper)},
         {lower, twisted},
         {last, last}}};
    Bones{joints, at, turns, rest.at(-before), down}.stations(all, inMirror);
}

void addToes(std::vector<Motion>& all, const PosedLimb& leg, bool inMirror) {
    const Axes rest = restFoot();
    const RestLimb limb = restLeg();
    const Point ankle = limb.at(limb.upper + limb.lower);
    const Point start = ankle + rest * Point{0, ball.y, 0};
    const Point placed = leg.end + leg.last * (start - ankle);
    const Point joint = leg.end + leg.last * (rest * ball);
    const std::array<Point, 3> at{placed, joint, joint + leg.tip * (0.1 * rest.z)};
    const Quaternion foot = quaternion(leg.last), toes = quaternion(leg.tip);
    const std::array<std::array<Quaternion, 2>, 2> turns{{{foot, foot}, {toes, toes}}};
    Bones{toeJoints, at, turns, start, rest.z}.stations(all, inMirror);
}

Axes sided(const Axes& a, bool inMirror) { return inMirror ? mirrored(a) : a; }

std::vector<Motion> stations(const Posed& p) {
    std::vector<Motion> all;
    addSpine(all, p);
    const RestLimb arm = restArm(), leg = restLeg();
    for (std::size_t side = 0; side < 2; ++side) {
        const bool inMirror = side == 1;
        const Axes chest = sided(p.chest, inMirror), pelvis = sided(p.pelvis, inMirror);
        const Point ribs = inMirror ? mirrored(p.ribs) : p.ribs;
        const Point hips = inMirror ? mirrored(p.hips) : p.hips;
        addLimb(all, p.arms[side], arm, armJoints,
                ribs + chest * (arm.at(-inArm) - Point{0, ribsHeight, 0}), chest, inMirror);
        addLimb(all, p.legs[side], leg, legJoints,
                hips + pelvis * (leg.at(-inLeg) - Point{0, hipHeight, 0}), pelvis, inMirror);
        addToes(all, p.legs[side], inMirror);
    }
    return all;
}

// Where a vertex of the left half is along each chain, and how much it listens to it.
struct Place {
    double spine, arm, leg, toes;
    double ofArm, ofLeg, ofToes;
};

Place placeOf(const Point& p) {
    static const RestLimb arm = restArm(), leg = restLeg();
    static const Axes toFoot = transposed(restFoot());
    Place place{};
    // The head's first plane goes from the nape to under the chin.
    place.spine = p.y + 0.8 * step(p.y, 1.32, 1.50) * p.z - hipHeight;

    const double out = -dot(p - arm.root, arm.axes.y);
    const double off = length(p - arm.at(out));
    place.arm = inArm + out;
    const double beside = step(out, -0.11, -0.01) * (1 - step(off, 0.06, 0.16));
    place.ofArm = beside + (1 - beside) * step(p.x, 0.17, 0.22) * step(p.y, 1.10, 1.15);

    const double down = -dot(p - leg.root, leg.axes.y);
    const double aside = p.x - leg.at(down).x;
    place.leg = inLeg + down + 0.45 * aside * (1 - step(down, 0.05, 0.25));
    const double apart = step(p.x, -0.01, 0.06);
    place.ofLeg = (apart + (1 - apart) * (1 - step(p.y, 0.74, 0.80))) * (1 - step(p.y, 0.97, 1.05));

    const Point sole = toFoot * (p - leg.at(leg.upper + leg.lower));
    place.toes = sole.z;
    place.ofToes = p.y < 0.3 ? step(sole.z, 0.04, 0.07) : 0;
    return place;
}

}  // namespace

Skin::Skin(const std::vector<Point>& rest) : rest_(rest), influences_(rest.size()) {
    const int spine = stationsOf(spineJoints), arm = stationsOf(armJoints),
              leg = stationsOf(legJoints), toes = stationsOf(toeJoints);
    for (std::size_t v = 0; v < rest.size(); ++v) {
        const bool right = rest[v].x < 0;
        const Place place = placeOf(right ? mirrored(rest[v]) : rest[v]);
        const int first = spine + (right ? arm + leg + toes : 0);
        std::size_t n = 0;
        const auto listen = [&](int from, int count, double s, double weight) {
            const double i = std::clamp(s / spacing, 0.0, count - 1.001);
            const int station = static_cast<int>(i);
            influences_[v][n++] = {from + station, weight * (1 - (i - station))};
            influences_[v][n++] = {from + station + 1, weight * (i - station)};
        };
        const double body = (1 - place.ofArm) * (1 - place.ofLeg);
        listen(0, spine, place.spine, body);
        listen(first, arm, place.arm, place.ofArm);
        listen(first + arm, leg, place.leg, place.ofLeg * (1 - place.ofToes));
        listen(first + arm + leg, toes, place.toes, place.ofLeg * place.ofToes);
    }
}

std::vector<Point> Skin::positions(const Posed& posed) const {
    const std::vector<Motion> motions = stations(posed);
    std::vector<Point> x(rest_.size());
    for (std::size_t v = 0; v < rest_.size(); ++v) {
        Point sum{0, 0, 0};
        for (const auto& [station, weight] : influences_[v]) {
            if (weight == 0) continue;
            const Motion& m = motions[static_cast<std::size_t>(station)];
            sum += weight * (m.turn * rest_[v] + m.shift);
        }
        x[v] = sum;
    }
    return x;
}

}  // namespace plait::dancer
