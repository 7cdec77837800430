// A turned outline against a search of all its edges.
#include "tests/catch.h"

#include <plait/contacts/solids/profile.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace plait;

namespace {

using Outline = std::vector<std::array<double, 2>>;

double toEdge(const std::array<double, 2>& a, const std::array<double, 2>& b, double r, double y) {
    const double dr = b[0] - a[0], dy = b[1] - a[1];
    const double t =
        std::clamp(((r - a[0]) * dr + (y - a[1]) * dy) / (dr * dr + dy * dy), 0.0, 1.0);
    return std::hypot(r - a[0] - t * dr, y - a[1] - t * dy);
}

// Whether an outline winds around a point.
bool encloses(const Outline& all, double r, double y) {
    double turned = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto &a = all[i], &b = all[(i + 1) % all.size()];
        const double u = a[0] - r, v = a[1] - y, p = b[0] - r, q = b[1] - y;
        turned += std::atan2(u * q - v * p, u * p + v * q);
    }
    return std::fabs(turned) > 1;
}

// A thin-walled jug with a waist, of so many edges a side.
Outline jug(int n) {
    Outline outline;
    const auto radius = [](double y) { return 0.04 + 0.015 * std::sin(40 * y); };
    outline.push_back({0, -0.002});
    for (int i = 0; i <= n; ++i) outline.push_back({0.002 + radius(0.2 * i / n), 0.2 * i / n});
    for (int i = n; i >= 0; --i) outline.push_back({radius(0.2 * i / n), 0.2 * i / n});
    outline.push_back({0, 0});
    return outline;
}

}  // namespace

TEST_CASE("profiles: the nearest edge and the side are those of a search of all", "[colliders]") {
    for (const Outline& outline : {jug(25), Outline{{0, 0}, {1, 0}, {0, 1}},
                                   Outline{{0.5, 0}, {0.7, 0}, {0.7, 3}, {0.5, 3}}}) {
        const Profile profile(outline);
        double size = 0;
        for (const auto& [r, y] : outline) size = std::max({size, r, std::fabs(y)});
        std::mt19937 random(1);
        const auto within = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
        };
        double off = 0;
        int sides = 0;
        for (int k = 0; k < 20000; ++k) {
            // Near it, around it, and beyond any table of it.
            const double far = k % 3 == 0 ? 0.1 : k % 3 == 1 ? 1 : 10;
            const auto& corner = outline[random() % outline.size()];
            const double r = std::max(0.0, corner[0] + far * size * within(-1, 1));
            const double y = corner[1] + far * size * within(-1, 1);
            double least = 1e30;
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
                if (a[0] > 0 || b[0] > 0) least = std::min(least, toEdge(a, b, r, y));
            }
            const double found = profile.nearest(r, y).distance;
            off = std::max(off, std::fabs(std::fabs(found) - least));
            sides += r > 0 && least > 1e-9 && (found < 0) != encloses(outline, r, y);
        }
        CHECK(off <= 1e-13 * size);
        CHECK(sides == 0);
    }
}
