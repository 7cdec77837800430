#include "goblet.h"

#include <plait/numbers/elementary.h>
#include <plait/numbers/splitmix.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plait {
namespace {

constexpr double turn = 2 * std::numbers::pi;
// m, heights of the middle of the foot, of the lowest point of the bowl's middle surface, of where
// the bowl is the widest, of its rim.
constexpr double low = 0.0016, bottom = 0.078, waist = 0.112, rim = 0.155;
constexpr double wide = 0.038, mouth = 0.031;       // m, radii of the bowl
constexpr double footRadius = 0.034, stem = 0.004;  // m
constexpr double thick = 0.0024, thin = 0.0014;     // m, of the bowl, below and at its rim
constexpr double scatter = 0.2;                     // of a site, in parts of the spacing

// The bowl's middle surface at z = 0, by how far along it from below, 0 to 1.
Vec<double> bowl(double u) {
    constexpr double round = 0.58;
    if (u < round) {
        const double angle = turn / 4 * u / round;
        return {wide * sine(angle), waist - (waist - bottom) * cosine(angle), 0};
    }
    const double s = (u - round) / (1 - round);
    return {wide - (wide - mouth) * s * s, waist + (rim - waist) * s, 0};
}

Vec<double> around(double radius, double height, double angle) {
    return {radius * cosine(angle), height, radius * sine(angle)};
}

HalfSpace facing(const Vec<double>& normal, const Vec<double>& at) {
    return {normal, dot(normal, at)};
}

Lump plate(const Vec<double>& site, const Vec<double>& normal, double thickness) {
    return {site,
            {facing(normal, site + (thickness / 2) * normal),
             facing(-normal, site - (thickness / 2) * normal)}};
}

class Maker {
public:
    explicit Maker(const Goblet& goblet) : goblet_(goblet), random_(goblet.seed) {}

    std::vector<Lump> make() {
        addFoot();
        addStem();
        addBowl();
        for (Lump& lump : lumps_) {
            for (HalfSpace& plane : lump.within) plane.offset += dot(plane.normal, goblet_.foot);
            lump.site += goblet_.foot;
        }
        return std::move(lumps_);
    }

private:
    double off() { return scatter * random_.both(); }

    // Calls place(angle) for each site of a ring of this radius.
    template <class Place>
    void ring(double radius, const Place& place) {
        const int count =
            std::max(5, static_cast<int>(std::lround(turn * radius / goblet_.spacing)));
        const double first = random_.next();
        for (int i = 0; i < count; ++i) place(turn * (i + first + off()) / count);
    }

    void addFoot() {
        const Vec<double> up{0, 1, 0}, middle{0, low, 0};
        lumps_.push_back({middle, {facing(-up, {0, 0, 0})}});
        const int rings = static_cast<int>(footRadius / goblet_.spacing);
        for (int k = 1; k <= rings; ++k)
            ring(footRadius * (k - 0.1) / (rings + 0.4), [&](double angle) {
                const double r = (k - 0.1 + off()) / (rings + 0.4);
                lumps_.push_back(plate(around(footRadius * r, low, angle), up, 2 * low));
                const Vec<double> out = around(1, 0, angle);
                lumps_.back().within.push_back(facing(out, footRadius * out));
            });
    }

    // Between the middles of foot and bowl, which reach to half-way to its ends.
    void addStem() {
        const int count = std::max(2, static_cast<int>((bottom - low) / goblet_.spacing) - 1);
        constexpr int sides = 8;
        for (int i = 1; i <= count; ++i) {
            Lump lump{{0, low + (bottom - low) * i / (count + 1), 0}, {}};
            for (int k = 0; k < sides; ++k) {
                const Vec<double> out = around(1, 0, turn * (k + 0.5) / sides);
                lump.within.push_back(facing(out, stem * out));
            }
            lumps_.push_back(lump);
        }
    }

    void addBowl() {
        const Vec<double> up{0, 1, 0};
        lumps_.push_back({{0, bottom, 0}, {facing(up, {0, bottom + thick / 2, 0})}});
        double way = 0;
        constexpr int pieces = 256;
        for (int k = 0; k < pieces; ++k)
            way += length(bowl((k + 1.0) / pieces) - bowl(1.0 * k / pieces));
        const int rings = static_cast<int>(way / goblet_.spacing);
        for (int k = 1; k <= rings; ++k)
            ring(bowl(k / (rings + 0.4)).x,
                 [&](double angle) { addPane((k + off()) / (rings + 0.4), angle); });
    }

    void addPane(double u, double angle) {
        constexpr double step = 1e-4;
        u = std::min(u, 1 - step);
        const Vec<double> at = bowl(u), way = bowl(u + step) - at;
        const Vec<double> normal = (1 / length(way)) * around(way.y, -way.x, angle);
        lumps_.push_back(plate(around(at.x, at.y, angle), normal, thick + (thin - thick) * u));
        lumps_.back().within.push_back(facing({0, 1, 0}, {0, rim, 0}));
    }

    Goblet goblet_;
    Splitmix random_;
    std::vector<Lump> lumps_;
};

}  // namespace

std::vector<Lump> lumpsOf(const Goblet& goblet) { return Maker(goblet).make(); }

}  // namespace plait
