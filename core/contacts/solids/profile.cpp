#include "profile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {

Profile::Profile(std::vector<std::array<double, 2>> corners) : corners_(std::move(corners)) {
    const std::size_t n = corners_.size();
    double area = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [r, y] = corners_[i];
        const auto [r2, y2] = corners_[(i + 1) % n];
        if (!(r >= 0) || !std::isfinite(r) || !std::isfinite(y))
            throw std::invalid_argument("profile: radii are at least 0, and all is finite");
        area += 0.5 * (r * y2 - r2 * y);
    }
    if (n < 3 || area == 0) throw std::invalid_argument("profile: it encloses nothing");
    reversed_ = area < 0;
    grid_ = ProfileGrid(
        corners_,
        [this](std::size_t edge, double radius, double height) {
            if (!isSurface(edge)) return infinity;
            const auto off = offEdge(edge, radius, height);
            return off[0] * off[0] + off[1] * off[1];
        },
        [this](double radius, double height) { return contains(radius, height); });
}

bool Profile::isSurface(std::size_t edge) const {
    return corners_[edge][0] > 0 || corners_[(edge + 1) % corners_.size()][0] > 0;
}

// A way outward along the radius meets it.
bool Profile::crosses(std::size_t edge, double radius, double height) const {
    const auto& a = corners_[edge];
    const auto& b = corners_[(edge + 1) % corners_.size()];
    if ((a[1] > height) == (b[1] > height)) return false;
    return a[0] + (height - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > radius;
}

bool Profile::contains(double radius, double height) const {
    bool in = false;
    for (std::size_t i = 0; i < corners_.size(); ++i)
        if (crosses(i, radius, height)) in = !in;
    return in;
}

// From the nearest point of an edge.
std::array<double, 2> Profile::offEdge(std::size_t edge, double radius, double height) const {
    const auto& a = corners_[edge];
    const auto& b = corners_[(edge + 1) % corners_.size()];
    const double r = b[0] - a[0], y = b[1] - a[1];
    const double along = (radius - a[0]) * r + (height - a[1]) * y;
    const double t = std::clamp(divide(along, r * r + y * y), 0.0, 1.0);
    return {radius - a[0] - t * r, height - a[1] - t * y};
}

// Where two edges are as near, at a corner, the way out is the way from it.
Profile::Nearest Profile::nearest(double radius, double height) const {
    double least = infinity;
    std::array<double, 2> away{};
    std::size_t edge = 0;
    const auto look = [&](std::size_t i) {
        const auto off = offEdge(i, radius, height);
        const double squared = off[0] * off[0] + off[1] * off[1];
        if (squared >= least) return;
        least = squared;
        away = off;
        edge = i;
    };
    const ProfileGrid::Cell cell = grid_.at(radius, height);
    for (const int i : cell.nearest) look(static_cast<std::size_t>(i));
    for (std::size_t i = 0; cell.nearest.empty() && i < corners_.size(); ++i)
        if (isSurface(i)) look(i);
    bool in = cell.within == ProfileGrid::Within::yes;
    if (cell.nearest.empty()) {
        in = contains(radius, height);
    } else if (cell.within == ProfileGrid::Within::mixed) {
        for (const int i : cell.crossing)
            if (crosses(static_cast<std::size_t>(i), radius, height)) in = !in;
    }
    const double distance = squareRoot(least), sign = in ? -1 : 1;
    if (distance > 1e-12)
        return {sign * distance, {sign / distance * away[0], sign / distance * away[1]}};
    const auto& a = corners_[edge];
    const auto& b = corners_[(edge + 1) % corners_.size()];
    const double r = b[0] - a[0], y = b[1] - a[1];
    const double l = squareRoot(r * r + y * y), turn = reversed_ ? -1 : 1;
    return {sign * distance, {turn * y / l, -turn * r / l}};
}

std::vector<std::size_t> Profile::edgesNear(double radius, double height, double distance) const {
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        if (!isSurface(i)) continue;
        const auto off = offEdge(i, radius, height);
        if (off[0] * off[0] + off[1] * off[1] < distance * distance) near.push_back(i);
    }
    return near;
}

// An edge is a part of a cone: with r = r0 + s (y - y0) on it, r^2 = x^2 + z^2 is a quadratic
// equation in the way; of a flat one, whose y is everywhere the same, it is where y is met.
double Profile::met(const Vec<double>& from, const Vec<double>& direction,
                    std::span<const std::size_t> which, double most) const {
    double first = most;
    for (const std::size_t i : which) {
        const auto& a = corners_[i];
        const auto& b = corners_[(i + 1) % corners_.size()];
        const double rise = b[1] - a[1], run = b[0] - a[0];
        const double s = divide(run, std::fabs(rise)) * (rise < 0 ? -1 : 1);
        const double base = a[0] + s * (from.y - a[1]), slope = s * direction.y;
        const auto take = [&](double t) {
            // The cone goes on behind its tip.
            if (!(t >= 0 && t < first) || (rise != 0 && base + slope * t < 0)) return;
            const Vec<double> at = from + t * direction;
            const double r = squareRoot(at.x * at.x + at.z * at.z);
            const bool flat = std::fabs(rise) < std::fabs(run);
            const double part = flat ? (r - a[0]) / run : (at.y - a[1]) / rise;
            if (part >= 0 && part <= 1) first = t;
        };
        if (rise == 0) {
            take(direction.y == 0 ? -1 : (a[1] - from.y) / direction.y);
            continue;
        }
        const double p = direction.x * direction.x + direction.z * direction.z - slope * slope;
        const double q = from.x * direction.x + from.z * direction.z - base * slope;
        const double c = from.x * from.x + from.z * from.z - base * base;
        const double root = q * q - p * c;
        if (root < 0) continue;
        // Of the two forms of each solution that in which nothing cancels.
        const double u = -q - (q < 0 ? -squareRoot(root) : squareRoot(root));
        if (p != 0) take(u / p);
        if (u != 0) take(c / u);
    }
    return first;
}

}  // namespace plait
