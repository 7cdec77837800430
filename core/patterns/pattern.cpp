#include "pattern.h"

#include "../numbers/elementary.h"
#include "../numbers/splitmix.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

constexpr double turn = 6.283185307179586;

// A convex polygon whose side i, from corner i to the next, lies on a cut with `with[i]`.
struct Outline {
    std::vector<PlanePoint> corners;
    std::vector<int> with;
};

double across(const PlanePoint& a, const PlanePoint& b) { return a.x * b.y - a.y * b.x; }
double distance(const PlanePoint& a, const PlanePoint& b) {
    const double x = a.x - b.x, y = a.y - b.y;
    return std::sqrt(x * x + y * y);
}

double areaOf(const std::vector<PlanePoint>& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += across(corners[i], corners[(i + 1) % corners.size()]) / 2;
    return sum;
}

// Leaves what is nearer to `site` than to `other`, by as much as `less` in addition.
void clip(Outline& outline, const PlanePoint& site, const PlanePoint& other, int name,
          double less) {
    const PlanePoint along{other.x - site.x, other.y - site.y};
    const double l = distance(site, other);
    const auto over = [&](const PlanePoint& p) {
        return ((p.x - site.x) * along.x + (p.y - site.y) * along.y) / l - l / 2 + less;
    };
    Outline left;
    const auto put = [&](const PlanePoint& p, int with) {
        left.corners.push_back(p);
        left.with.push_back(with);
    };
    const std::size_t count = outline.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const PlanePoint &a = outline.corners[i], &b = outline.corners[(i + 1) % count];
        const double da = over(a), db = over(b), part = da / (da - db);
        const PlanePoint between{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
        if (da <= 0) put(a, outline.with[i]);
        if (da <= 0 && db > 0) put(between, name);
        if (da > 0 && db <= 0) put(between, outline.with[i]);
    }
    outline = std::move(left);
}

Outline whole(const Pane& pane) {
    return {{{0, 0}, {pane.width, 0}, {pane.width, pane.height}, {0, pane.height}},
            {Seam::border - 1, Seam::border - 2, Seam::border - 3, Seam::border - 4}};
}

// The cell of a site; `order`: scratch.
Outline cellOf(const Pane& pane, std::span<const PlanePoint> sites, int cell,
               std::vector<std::pair<double, int>>& order) {
    const PlanePoint& site = sites[cell];
    order.clear();
    for (int j = 0; j < std::ssize(sites); ++j)
        if (j != cell) order.emplace_back(distance(site, sites[j]), j);
    std::ranges::sort(order);
    Outline outline = whole(pane);
    for (const auto& [away, j] : order) {
        double reach = 0;
        for (const PlanePoint& p : outline.corners) reach = std::max(reach, distance(site, p));
        if (away > 2 * reach) break;
        clip(outline, site, sites[j], j, 0);
    }
    return outline;
}

std::vector<Outline> cellsOf(const Pane& pane, std::span<const PlanePoint> sites) {
    std::vector<Outline> cells;
    std::vector<std::pair<double, int>> order;
    for (int i = 0; i < std::ssize(sites); ++i) cells.push_back(cellOf(pane, sites, i, order));
    return cells;
}

// Takes the sites of cells that are too small and smaller than their neighbours. Returns whether
// there were any.
bool merge(const Pane& pane, std::vector<PlanePoint>& sites, const std::vector<Outline>& cells) {
    std::vector<PlanePoint> left;
    std::vector<double> areas;
    for (const Outline& cell : cells) areas.push_back(areaOf(cell.corners));
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const auto smaller = [&](int j) {
            return j < 0 || std::pair(areas[i], static_cast<int>(i)) < std::pair(areas[j], j);
        };
        if (areas[i] >= pane.leastCell || !std::ranges::all_of(cells[i].with, smaller))
            left.push_back(sites[i]);
    }
    const bool any = left.size() < sites.size();
    sites = std::move(left);
    return any;
}

// The same outline less half the kerf at every cut, without sides that are shorter than the kerf.
std::vector<PlanePoint> sawn(const Pane& pane, std::span<const PlanePoint> sites, int cell,
                             const Outline& outline) {
    Outline left = whole(pane);
    for (const int j : outline.with)
        if (j >= 0) clip(left, sites[cell], sites[j], j, pane.kerf / 2);
    std::vector<PlanePoint> corners;
    for (const PlanePoint& p : left.corners)
        if (corners.empty() || distance(corners.back(), p) > pane.kerf) corners.push_back(p);
    while (corners.size() > 1 && distance(corners.back(), corners.front()) <= pane.kerf)
        corners.pop_back();
    return corners;
}

// m, from the site to the nearest side.
double withinOf(const Cell& cell) {
    double least = 1e30;
    for (std::size_t i = 0; i < cell.outline.size(); ++i) {
        const PlanePoint &a = cell.outline[i], &b = cell.outline[(i + 1) % cell.outline.size()];
        const PlanePoint from{a.x - cell.site.x, a.y - cell.site.y}, way{b.x - a.x, b.y - a.y};
        least = std::min(least, across(from, way) / distance(a, b));
    }
    return least;
}

void check(const Pane& pane, const std::vector<PlanePoint>& sites) {
    for (const double size : {pane.width, pane.height, pane.thickness})
        if (!(size > 0) || !std::isfinite(size))
            throw std::invalid_argument("a pane must have a size");
    if (!(pane.kerf >= 0)) throw std::invalid_argument("a kerf must not be negative");
    if (sites.empty()) throw std::invalid_argument("a pattern must have a site");
    for (const PlanePoint& p : sites)
        if (!(p.x >= 0 && p.x <= pane.width && p.y >= 0 && p.y <= pane.height))
            throw std::invalid_argument("a site must lie within the pane");
}

}  // namespace

Pattern cut(const Pane& pane, std::vector<PlanePoint> sites) {
    check(pane, sites);
    std::vector<Outline> cells = cellsOf(pane, sites);
    while (sites.size() > 1 && merge(pane, sites, cells)) cells = cellsOf(pane, sites);
    Pattern pattern{.pane = pane, .cells = {}, .seams = {}};
    for (int i = 0; i < std::ssize(cells); ++i) {
        const Outline& cell = cells[i];
        pattern.cells.push_back({sites[i], sawn(pane, sites, i, cell)});
        for (std::size_t k = 0; k < cell.corners.size(); ++k) {
            const PlanePoint &a = cell.corners[k], &b = cell.corners[(k + 1) % cell.corners.size()];
            const int other = cell.with[k];
            // A side that either has lost to rounding holds nothing.
            if (other >= 0 &&
                (other < i || std::ranges::find(cells[other].with, i) == cells[other].with.end()))
                continue;
            if (distance(a, b) > pane.kerf) pattern.seams.push_back({i, other, a, b});
        }
    }
    return pattern;
}

std::vector<PlanePoint> evenSites(const Pane& pane, int count, std::uint64_t seed) {
    Splitmix random(seed);
    std::vector<PlanePoint> sites;
    for (int i = 0; i < count; ++i) {
        const double x = random.next(), y = random.next();
        sites.push_back({x * pane.width, y * pane.height});
    }
    return sites;
}

std::vector<PlanePoint> starSites(const Pane& pane, const Star& star, int count,
                                  std::uint64_t seed) {
    Splitmix random(seed);
    double outer = 0;
    for (const PlanePoint& p : whole(pane).corners)
        outer = std::max(outer, distance(star.centre, p));
    const double decades = logarithm(outer / star.inner);
    // Of rings r that are rays' width apart, but for `slender`.
    const int rays =
        std::max(5, static_cast<int>(std::sqrt(count * turn * star.slender / decades)));
    const double step = star.slender * turn / rays;
    std::vector<PlanePoint> sites{star.centre};
    for (int ring = 0; ring * step < decades; ++ring)
        for (int ray = 0; ray < rays; ++ray) {
            const double r =
                star.inner * exponential(step * (ring + 0.5 + star.scatter * random.both()));
            const double angle = turn * (ray + star.scatter * random.both()) / rays;
            const PlanePoint p{star.centre.x + r * cosine(angle), star.centre.y + r * sine(angle)};
            if (p.x > 0 && p.y > 0 && p.x < pane.width && p.y < pane.height) sites.push_back(p);
        }
    return sites;
}

Shape prismOf(const Cell& cell, double thickness, double bevel) {
    const int n = static_cast<int>(cell.outline.size());
    const double narrow = 1 - std::min(0.25, bevel / withinOf(cell));
    const PlanePoint& c = cell.site;
    Shape shape;
    Simplices faces;
    const auto ring = [&](double z, double part) {
        for (const PlanePoint& p : cell.outline)
            shape.positions.push_back({c.x + part * (p.x - c.x), c.y + part * (p.y - c.y), z});
    };
    ring(-thickness / 2, narrow);
    if (bevel > 0) ring(0, 1);
    ring(thickness / 2, narrow);
    const int top = static_cast<int>(shape.positions.size()) - n;
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        for (int low = 0; low < top; low += n) {
            faces.triangles.push_back({low + i, low + j, low + n + j});
            faces.triangles.push_back({low + i, low + n + j, low + n + i});
        }
        if (i == 0 || j == 0) continue;
        faces.triangles.push_back({0, j, i});
        faces.triangles.push_back({top, top + i, top + j});
    }
    shape.complex = SimplicialComplex(top + n, faces);
    return shape;
}

}  // namespace plait
