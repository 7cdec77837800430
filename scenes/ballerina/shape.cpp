#include "shape.h"

#include <array>
#include <span>

namespace plait::dancer {
namespace {

// Half widths of a cross section at `s` (m along an axis): to x, against x, to z and against z.
struct Section {
    double s;
    std::array<double, 4> half;
};

double spline(double p0, double p1, double p2, double p3, const std::array<double, 4>& at,
              double s) {
    const double h = at[2] - at[1], u = (s - at[1]) / h;
    const double m1 = h * (p2 - p0) / (at[2] - at[0]), m2 = h * (p3 - p1) / (at[3] - at[1]);
    return p1 + u * (m1 + u * (3 * (p2 - p1) - 2 * m1 - m2 + u * (2 * (p1 - p2) + m1 + m2)));
}

std::array<double, 4> halfWidths(std::span<const Section> sections, double s) {
    const int last = static_cast<int>(sections.size()) - 1;
    const auto at = [&](int i) -> const Section& {
        return sections[static_cast<std::size_t>(std::clamp(i, 0, last))];
    };
    if (s <= at(0).s) return at(0).half;
    if (s >= at(last).s) return at(last).half;
    int i = 0;
    while (s > at(i + 1).s) ++i;
    std::array<double, 4> half{};
    const double before = i > 0 ? at(i - 1).s : 2 * at(0).s - at(1).s;
    const double after = i + 2 <= last ? at(i + 2).s : 2 * at(last).s - at(last - 1).s;
    for (std::size_t k = 0; k < 4; ++k)
        half[k] = spline(at(i - 1).half[k], at(i).half[k], at(i + 1).half[k], at(i + 2).half[k],
                         {before, at(i).s, at(i + 1).s, after}, s);
    return half;
}

// A tube of changing section, a quarter of an ellipse between each two of its sides; `p` in its
// frame, s = -y. Closed by round ends.
double loft(std::span<const Section> sections, const Point& p) {
    const double s = -p.y, first = sections.front().s, last = sections.back().s;
    const auto half = halfWidths(sections, s);
    const double a = p.x > 0 ? half[0] : half[1], b = p.z > 0 ? half[2] : half[3];
    const double over = s < first ? s - first : s > last ? s - last : 0;
    const double cap = 0.14 * (half[0] + half[1] + half[2] + half[3]);
    const double u = p.x / a, v = p.z / b, c = over / cap;
    const double k = squareRoot(u * u + v * v + c * c) + 1e-9;
    const double g = length(Point{u / a, v / b, c / cap}) + 1e-9;
    return k * (k - 1) / g;
}

double ellipsoid(const Point& p, const Point& center, const Point& half) {
    const Point d = p - center;
    const Point u{d.x / half.x, d.y / half.y, d.z / half.z};
    const Point v{u.x / half.x, u.y / half.y, u.z / half.z};
    const double k = length(u) + 1e-9;
    return k * (k - 1) / (length(v) + 1e-9);
}

// The hull of two balls.
double cone(const Point& p, const Point& a, double ra, const Point& b, double rb) {
    const Point ba = b - a, pa = p - a;
    const double l2 = dot(ba, ba), rr = ra - rb, a2 = l2 - rr * rr, il2 = 1 / l2;
    const double y = dot(pa, ba), z = y - l2;
    const Point across = l2 * pa - y * ba;
    const double x2 = dot(across, across), y2 = y * y * l2, z2 = z * z * l2;
    const double k = (rr < 0 ? -1 : 1) * rr * rr * x2;
    if ((z < 0 ? -1 : 1) * a2 * z2 > k) return squareRoot(x2 + z2) * il2 - rb;
    if ((y < 0 ? -1 : 1) * a2 * y2 < k) return squareRoot(x2 + y2) * il2 - ra;
    return (squareRoot(x2 * a2 * il2) + y * rr) * il2 - ra;
}

constexpr std::array<Section, 15> torsoSections{{{-1.425, {0.040, 0.040, 0.030, 0.045}},
                                                 {-1.40, {0.080, 0.080, 0.042, 0.058}},
                                                 {-1.37, {0.118, 0.118, 0.058, 0.073}},
                                                 {-1.32, {0.134, 0.134, 0.076, 0.084}},
                                                 {-1.26, {0.131, 0.131, 0.088, 0.084}},
                                                 {-1.20, {0.122, 0.122, 0.087, 0.076}},
                                                 {-1.14, {0.111, 0.111, 0.080, 0.067}},
                                                 {-1.08, {0.105, 0.105, 0.074, 0.062}},
                                                 {-1.04, {0.111, 0.111, 0.076, 0.065}},
                                                 {-0.99, {0.133, 0.133, 0.082, 0.077}},
                                                 {-0.94, {0.150, 0.150, 0.084, 0.088}},
                                                 {-0.90, {0.154, 0.154, 0.080, 0.092}},
                                                 {-0.87, {0.142, 0.142, 0.070, 0.088}},
                                                 {-0.85, {0.118, 0.118, 0.055, 0.074}},
                                                 {-0.84, {0.095, 0.095, 0.045, 0.062}}}};

constexpr std::array<Section, 15> legSections{{{-0.03, {0.066, 0.060, 0.070, 0.076}},
                                               {0.05, {0.077, 0.068, 0.077, 0.082}},
                                               {0.12, {0.075, 0.068, 0.078, 0.078}},
                                               {0.20, {0.067, 0.062, 0.073, 0.068}},
                                               {0.29, {0.056, 0.053, 0.061, 0.057}},
                                               {0.37, {0.047, 0.047, 0.051, 0.048}},
                                               {0.425, {0.044, 0.046, 0.052, 0.042}},
                                               {0.47, {0.042, 0.043, 0.045, 0.044}},
                                               {0.53, {0.045, 0.046, 0.042, 0.054}},
                                               {0.58, {0.044, 0.046, 0.040, 0.056}},
                                               {0.64, {0.038, 0.040, 0.036, 0.048}},
                                               {0.71, {0.030, 0.031, 0.031, 0.035}},
                                               {0.77, {0.026, 0.026, 0.028, 0.028}},
                                               {0.81, {0.027, 0.028, 0.028, 0.029}},
                                               {0.84, {0.027, 0.027, 0.027, 0.028}}}};

constexpr std::array<Section, 11> armSections{{{-0.03, {0.034, 0.040, 0.036, 0.038}},
                                               {0.02, {0.040, 0.041, 0.042, 0.043}},
                                               {0.07, {0.039, 0.037, 0.041, 0.041}},
                                               {0.14, {0.034, 0.034, 0.036, 0.037}},
                                               {0.22, {0.029, 0.029, 0.031, 0.031}},
                                               {0.28, {0.027, 0.027, 0.031, 0.028}},
                                               {0.33, {0.029, 0.029, 0.030, 0.032}},
                                               {0.40, {0.025, 0.025, 0.026, 0.028}},
                                               {0.46, {0.019, 0.020, 0.023, 0.023}},
                                               {0.51, {0.0155, 0.0155, 0.022, 0.022}},
                                               {0.54, {0.014, 0.015, 0.024, 0.025}}}};

constexpr std::array<Section, 4> palmSections{{{0.00, {0.0145, 0.0145, 0.022, 0.022}},
                                               {0.03, {0.0140, 0.0130, 0.028, 0.030}},
                                               {0.06, {0.0125, 0.0115, 0.034, 0.034}},
                                               {0.075, {0.0105, 0.0100, 0.033, 0.033}}}};

constexpr std::array<Section, 7> shoeSections{{{-0.028, {0.019, 0.019, 0.026, 0.027}},
                                               {-0.015, {0.023, 0.023, 0.032, 0.029}},
                                               {0.01, {0.026, 0.026, 0.034, 0.029}},
                                               {0.05, {0.027, 0.028, 0.024, 0.027}},
                                               {0.09, {0.032, 0.031, 0.016, 0.028}},
                                               {0.12, {0.031, 0.031, 0.010, 0.029}},
                                               {0.15, {0.023, 0.024, 0.006, 0.029}}}};

double torso(const Point& p) {
    double d = loft(torsoSections, p);
    d = smoothMin(d, ellipsoid(p, {0.062, 1.225, 0.062}, {0.052, 0.052, 0.047}), 0.05);
    d = smoothMin(d, ellipsoid(p, {0.068, 0.868, -0.050}, {0.072, 0.080, 0.062}), 0.06);
    // From the neck to the shoulder, and the collar bone.
    d = smoothMin(d, cone(p, {0.020, 1.445, -0.022}, 0.030, {0.135, 1.375, -0.015}, 0.034), 0.06);
    d = smoothMin(d, cone(p, {0.016, 1.388, 0.036}, 0.009, {0.125, 1.403, 0.006}, 0.009), 0.02);
    return smoothMin(d, cone(p, {0, 1.385, -0.018}, 0.045, {0, 1.52, -0.002}, 0.041), 0.05);
}

// Relative to the hairline, a plane from the forehead to the nape.
double overHairline(const Point& p) {
    constexpr Point normal{0, 0.78, -0.625};
    return dot(p - Point{0, 1.632, 0.082}, normal);
}

double skull(const Point& p) { return ellipsoid(p, {0, 1.598, -0.008}, {0.071, 0.084, 0.090}); }

double head(const Point& p) {
    double d = skull(p);
    d = smoothMin(d, ellipsoid(p, {0, 1.542, 0.026}, {0.049, 0.064, 0.056}), 0.05);
    d = smoothMin(d, ellipsoid(p, {0, 1.490, 0.061}, {0.016, 0.015, 0.015}), 0.04);
    // Cheek, brow, nose, lips; sockets.
    d = smoothMin(d, ellipsoid(p, {0.034, 1.553, 0.060}, {0.020, 0.020, 0.020}), 0.03);
    d = smoothMax(d, -ellipsoid(p, {0.030, 1.582, 0.106}, {0.020, 0.012, 0.020}), 0.014);
    d = smoothMin(d, cone(p, {0, 1.592, 0.080}, 0.0065, {0, 1.553, 0.0955}, 0.0085), 0.014);
    d = smoothMin(d, ellipsoid(p, {0, 1.5185, 0.0730}, {0.017, 0.0075, 0.011}), 0.014);
    // Ears.
    d = smoothMin(d, ellipsoid(p, {0.072, 1.565, -0.004}, {0.008, 0.027, 0.016}), 0.014);
    const double cap = smoothMax(skull(p) - 0.007, -overHairline(p), 0.010);
    d = smoothMin(d, cap, 0.004);
    return smoothMin(d, ellipsoid(p, {0, 1.682, -0.052}, {0.044, 0.036, 0.044}), 0.012);
}

double hand(const Point& p) {
    // From the wrist towards the fingers -y, the palm x, the thumb against z.
    double d = loft(palmSections, p);
    struct Finger {
        Point root, middle, tip;
        double radius;
    };
    constexpr std::array<Finger, 4> fingers{
        {{{0.000, -0.075, -0.0215}, {0.005, -0.112, -0.0225}, {0.009, -0.145, -0.0215}, 0.0092},
         {{0.001, -0.080, -0.0075}, {0.009, -0.118, -0.0080}, {0.016, -0.154, -0.0080}, 0.0094},
         {{0.001, -0.078, 0.0075}, {0.009, -0.114, 0.0075}, {0.016, -0.148, 0.0065}, 0.0092},
         {{0.001, -0.072, 0.0200}, {0.007, -0.102, 0.0210}, {0.012, -0.128, 0.0200}, 0.0084}}};
    for (const Finger& f : fingers) {
        const double finger = smoothMin(cone(p, f.root, f.radius, f.middle, 0.92 * f.radius),
                                        cone(p, f.middle, 0.92 * f.radius, f.tip, 0.008), 0.004);
        d = smoothMin(d, finger, 0.022);
    }
    const Point knuckle{0.014, -0.062, -0.050};
    const double thumb = smoothMin(cone(p, {0.002, -0.025, -0.020}, 0.013, knuckle, 0.0095),
                                   cone(p, knuckle, 0.0095, {0.024, -0.092, -0.057}, 0.008), 0.006);
    return smoothMin(d, thumb, 0.020);
}

// In its frame, in a pointe shoe.
double foot(const Point& p) {
    double d = loft(shoeSections, {p.x, -p.z, p.y + 0.045});
    d = smoothMin(d, cone(p, {0, 0.0, 0.000}, 0.027, {0, -0.040, 0.075}, 0.024), 0.03);
    d = smoothMin(d, cone(p, {0, -0.052, 0.115}, 0.022, toeTip, toeRadius), 0.025);
    return smoothMax(d, -ankleHeight - p.y, 0.005);
}

}  // namespace

RestLimb restArm() {
    return {.root = {0.150, 1.372, -0.012},
            .axes = axesOf(unit({0.97, -0.243, 0}), {0, 0, -1}),
            .upper = 0.28,
            .lower = 0.24};
}

RestLimb restLeg() {
    return {.root = {0.085, hipHeight, 0},
            .axes = axesOf(unit({0.105, -0.994, 0}), {0.7, 0, 0.7}),
            .upper = 0.425,
            .lower = 0.405};
}

Axes restFoot() {
    const Axes leg = restLeg().axes;
    const double c = 0.8660254037844386, s = 0.5;  // 30 degrees
    return {leg.x, c * leg.y + s * leg.z, c * leg.z - s * leg.y};
}

double field(const Point& point) {
    const Point p{point.x < 0 ? -point.x : point.x, point.y, point.z};
    static const RestLimb arm = restArm(), leg = restLeg();
    static const Axes toArm = transposed(arm.axes), toLeg = transposed(leg.axes),
                      toFoot = transposed(restFoot());
    static const Point wrist = arm.at(arm.upper + arm.lower), ankle = leg.at(leg.upper + leg.lower);
    double d = torso(p);
    if (p.y > 1.40) d = smoothMin(d, head(p), 0.022);
    if (p.y > 1.0) {
        double limb = loft(armSections, toArm * (p - arm.root));
        if (p.x > 0.6) limb = smoothMin(limb, hand(toArm * (p - wrist)), 0.014);
        return smoothMin(d, limb, 0.05);
    }
    double limb = loft(legSections, toLeg * (p - leg.root));
    if (p.y < 0.25) limb = smoothMin(limb, foot(toFoot * (p - ankle)), 0.03);
    return smoothMin(d, limb, 0.05);
}

Point slope(const Point& p) {
    // Four corners of a small cube.
    constexpr double h = 1e-5;
    Point sum{0, 0, 0};
    for (const Point& d : {Point{1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {1, 1, 1}})
        sum += field(p + h * d) * d;
    return (0.25 / h) * sum;
}

double hair(const Point& p) {
    const double bun = -ellipsoid(p, {0, 1.682, -0.052}, {0.048, 0.040, 0.048});
    return std::max(bun, overHairline(p));
}

double bodice(const Point& p) {
    // Heart-shaped in front, lower at the back.
    const double s = p.x * p.x / (0.066 * 0.066);
    const double heart = 0.030 * std::max(s * (2 - s), 0.0) * step(p.z, -0.02, 0.05);
    return 1.280 + heart - 0.035 * step(-p.z, 0.0, 0.06) - p.y;
}

double shoe(const Point& p) {
    static const RestLimb leg = restLeg();
    static const Axes toFoot = transposed(restFoot());
    const Point q = toFoot * (p - leg.at(leg.upper + leg.lower));
    // Open over the instep.
    return smoothMax(-0.008 - q.y - 0.30 * q.z, q.z - 0.088, 0.02);
}

}  // namespace plait::dancer
