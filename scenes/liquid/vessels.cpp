#include "vessels.h"

#include <plait/constraints/constants.h>

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr int slices = 400;

// A curve through corners (Catmull and Rom's), so many pieces between two.
Outline smooth(const Outline& corners, int pieces) {
    const int n = static_cast<int>(corners.size());
    const auto at = [&](int i, int axis) { return corners[std::clamp(i, 0, n - 1)][axis]; };
    Outline curve{corners.front()};
    for (int i = 0; i + 1 < n; ++i)
        for (int k = 1; k <= pieces; ++k) {
            const double f = static_cast<double>(k) / pieces, g = f * f, h = g * f;
            std::array<double, 2> p{};
            for (const int axis : {0, 1})
                p[axis] =
                    0.5 * ((-f + 2 * g - h) * at(i - 1, axis) + (2 - 5 * g + 3 * h) * at(i, axis) +
                           (f + 4 * g - 3 * h) * at(i + 1, axis) + (h - g) * at(i + 2, axis));
            curve.push_back({std::max(p[0], 0.0), p[1]});
        }
    return curve;
}

// Away from a cavity, which is to the left of its outline from the axis to the rim.
std::array<double, 2> outwardAt(const Outline& cavity, std::size_t i) {
    const auto& a = cavity[i > 0 ? i - 1 : 0];
    const auto& b = cavity[std::min(i + 1, cavity.size() - 1)];
    const double r = b[0] - a[0], y = b[1] - a[1], l = std::hypot(r, y);
    if (i == 0) return {0, -1};
    return {y / l, -r / l};
}

// Up the outside, from what it stands on, over the round rim and down into the cavity.
Outline wallOf(const Outline& base, const Outline& cavity, double thick) {
    Outline wall = base;
    for (std::size_t i = 1; i < cavity.size(); ++i) {
        const auto out = outwardAt(cavity, i);
        const double r = cavity[i][0] + thick * out[0], y = cavity[i][1] + thick * out[1];
        if (y > base.back()[1] && r > base.back()[0]) wall.push_back({r, y});
    }
    const auto out = outwardAt(cavity, cavity.size() - 1);
    const std::array<double, 2> up{-out[1], out[0]}, rim = cavity.back();
    for (const double a : {0.25 * pi, 0.5 * pi, 0.75 * pi}) {
        const double c = 0.5 * thick * (1 + std::cos(a)), s = 0.5 * thick * std::sin(a);
        wall.push_back({rim[0] + c * out[0] + s * up[0], rim[1] + c * out[1] + s * up[1]});
    }
    wall.insert(wall.end(), cavity.rbegin(), cavity.rend());
    return wall;
}

}  // namespace

double Vessel::radius(double height) const {
    for (std::size_t i = 0; i + 1 < cavity.size(); ++i) {
        const auto &a = cavity[i], &b = cavity[i + 1];
        if (height >= a[1] && height <= b[1] && b[1] > a[1])
            return a[0] + (height - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    }
    return 0;
}

bool Vessel::holds(double radius, double height) const { return radius < this->radius(height); }

double Vessel::volume(double level) const {
    const double low = cavity.front()[1], step = (level - low) / slices;
    double sum = 0;
    for (int i = 0; i < slices; ++i) {
        const double r = radius(low + (i + 0.5) * step);
        sum += pi * r * r * step;
    }
    return sum;
}

double Vessel::centre(double level) const {
    const double low = cavity.front()[1], step = (level - low) / slices;
    double sum = 0, moment = 0;
    for (int i = 0; i < slices; ++i) {
        const double y = low + (i + 0.5) * step, r = radius(y);
        sum += r * r;
        moment += r * r * y;
    }
    return sum > 0 ? moment / sum : low;
}

double Vessel::levelOf(double middle) const {
    double low = cavity.front()[1], high = rim();
    for (int i = 0; i < 40; ++i) {
        const double level = 0.5 * (low + high);
        (centre(level) < middle ? low : high) = level;
    }
    return 0.5 * (low + high);
}

Vessel wineGlass(double thick) {
    const Outline cavity = smooth({{0, 0.085},
                                   {0.014, 0.0875},
                                   {0.026, 0.096},
                                   {0.0345, 0.109},
                                   {0.039, 0.124},
                                   {0.0395, 0.140},
                                   {0.0375, 0.160},
                                   {0.034, 0.182}},
                                  3);
    const double stem = std::max(0.0042, 0.8 * thick);
    const Outline base = {{0, 0},           {0.036, 0},
                          {0.0366, 0.0016}, {0.034, 0.0036},
                          {0.018, 0.0066},  {0.009, 0.0105},
                          {stem, 0.019},    {0.9 * stem, 0.045},
                          {stem, 0.066},    {1.5 * stem, 0.0835 - thick}};
    return {cavity, wallOf(base, cavity, thick)};
}

Vessel carafe(double thick) {
    const Outline cavity = smooth({{0, 0},
                                   {0.036, 0.0015},
                                   {0.048, 0.010},
                                   {0.0535, 0.026},
                                   {0.053, 0.052},
                                   {0.047, 0.085},
                                   {0.036, 0.115},
                                   {0.0275, 0.140},
                                   {0.025, 0.160},
                                   {0.027, 0.178},
                                   {0.033, 0.192}},
                                  3);
    return {cavity, wallOf({{0, -1.3 * thick}, {0.036, -1.3 * thick}}, cavity, thick)};
}

Outline trayRim(double thick) {
    constexpr double radius = 0.13, height = 0.014;
    return {{radius, 0},
            {radius, height},
            {radius + 0.3 * thick, height + 0.4 * thick},
            {radius + 0.7 * thick, height + 0.4 * thick},
            {radius + thick, height},
            {radius + thick, 0}};
}

}  // namespace plait
