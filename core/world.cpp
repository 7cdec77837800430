#include "world.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <utility>

namespace plait {
namespace {

// Length, area or volume of a simplex; 1 for a point.
double measure(int k, std::span<const int> v, const std::vector<Vec<double>>& x) {
    const auto at = [&](std::size_t i) { return x[static_cast<std::size_t>(v[i])]; };
    if (k == 0) return 1;
    const Vec<double> a = at(1) - at(0);
    if (k == 1) return length(a);
    const Vec<double> n = cross(a, at(2) - at(0));
    return k == 2 ? length(n) / 2 : std::fabs(dot(n, at(3) - at(0))) / 6;
}

// A vertex takes part in the simplices of highest dimension around it: a cloth's edges weigh
// nothing, a curve's do.
std::vector<double> lumpedMass(const Shape& shape, double density) {
    std::vector<double> mass(shape.positions.size(), 0);
    for (int k = SimplicialComplex::maxDimension; k >= 0; --k) {
        const std::vector<int> parents =
            k < SimplicialComplex::maxDimension
                ? shape.complex.valences(k)
                : std::vector<int>(static_cast<std::size_t>(shape.complex.count(k)), 0);
        for (int i = 0; i < shape.complex.count(k); ++i) {
            if (parents[static_cast<std::size_t>(i)] > 0) continue;
            const auto vertices = shape.complex.vertices(k, i);
            const double share = density * measure(k, vertices, shape.positions) / (k + 1);
            for (const int v : vertices) mass[static_cast<std::size_t>(v)] += share;
        }
    }
    return mass;
}

}  // namespace

Range World::add(const Shape& shape, const Matter& matter) {
    const std::size_t n = shape.positions.size();
    if (!(matter.density > 0) || !std::isfinite(matter.density))
        throw std::invalid_argument("density must be positive, not " +
                                    std::to_string(matter.density));
    if (!matter.start.empty() && matter.start.size() != n)
        throw std::invalid_argument("start must have one position a vertex");
    if (!matter.velocity.empty() && matter.velocity.size() != n)
        throw std::invalid_argument("velocity must have one entry a vertex");
    if (matter.spare < 0)
        throw std::invalid_argument("there are no fewer spare vertices than none");
    const auto extend = [](auto& all, const auto& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    extend(rest, shape.positions);
    extend(start, matter.start.empty() ? shape.positions : matter.start);
    extend(velocity, matter.velocity.empty() ? std::vector<Vec<double>>(n) : matter.velocity);
    extend(mass, lumpedMass(shape, matter.density));
    Range range = complex.append(shape.complex);
    if (matter.spare > 0) {
        const auto m = static_cast<std::size_t>(matter.spare);
        const Vec<double> place = n ? start[start.size() - n] : Vec<double>{};
        extend(rest, std::vector(m, place));
        extend(start, std::vector(m, place));
        extend(velocity, std::vector<Vec<double>>(m));
        extend(mass, std::vector(m, matter.density));
        spare.push_back(complex.append(SimplicialComplex(matter.spare)));
        range.last = spare.back().last;
    }
    pinned.resize(mass.size(), 0);
    return range;
}

void World::pin(std::vector<int> vertices, Motion motion) {
    if (!motion) return pin(std::move(vertices), Animation{});
    pin(std::move(vertices),
        Animation([at = std::move(motion)](double t, std::span<Vec<double>> positions) {
            for (Vec<double>& x : positions) x = at(x, t);
        }));
}

void World::pin(std::vector<int> vertices, Animation animation) {
    for (const int v : vertices)
        if (v < 0 || static_cast<std::size_t>(v) >= pinned.size())
            throw std::invalid_argument("pin: there is no vertex " + std::to_string(v));
    for (const int v : vertices) pinned[static_cast<std::size_t>(v)] = 1;
    pins.push_back({std::move(vertices), std::move(animation)});
}

void World::letGo(std::vector<int> vertices, double time) {
    for (const int v : vertices)
        if (v < 0 || static_cast<std::size_t>(v) >= pinned.size() || !pinned[v])
            throw std::invalid_argument("let go: vertex " + std::to_string(v) + " is not pinned");
    if (std::isnan(time)) throw std::invalid_argument("let go: at no time");
    releases.push_back({std::move(vertices), time});
}

int World::releasesBy(double time) const {
    return static_cast<int>(
        std::ranges::count_if(releases, [&](const Release& r) { return r.time <= time; }));
}

World World::releasedBy(double time) const {
    World free = *this;
    for (const Release& release : releases)
        for (const int v : release.vertices)
            if (release.time <= time) free.pinned[v] = 0;
    return free;
}

std::vector<int> World::wholes() const {
    std::vector<int> names;
    if (tearable.empty()) return names;
    for (int v = 0; v < complex.count(0); ++v)
        names.push_back(torn && !torn->isParted(v) ? torn->original(v) : v);
    for (const auto& [matter, copies] : tearable)
        for (int v = copies.first; v < copies.last; ++v)
            if (!torn || torn->original(v) == v) names[v] = -1;
    return names;
}

Cuts World::uncut() const {
    std::vector<unsigned char> held = pinned;
    for (const Release& release : releases)
        for (const int v : release.vertices) held[v] = 1;
    return Cuts(complex, tearable, held);
}

World World::tornBy(std::span<const std::int32_t> entries) const {
    World now = *this;
    if (entries.empty()) return now;
    const auto cuts = std::make_shared<Cuts>(uncut());
    for (const std::int32_t entry : entries) cuts->take(entry);
    now.complex = cuts->torn();
    for (const auto& [vertex, copy, cut] : cuts->splits()) {
        now.rest[copy] = rest[cuts->original(copy)];
        now.start[copy] = start[cuts->original(copy)];
        now.velocity[copy] = velocity[cuts->original(copy)];
        now.mass[copy] = 0;
    }
    for (const auto& [vertex, copy, cut] : cuts->splits()) {
        const int whole = cuts->original(copy);
        double all = 0, own = 0, kept = 0;
        for (const int t : cuts->around(whole)) {
            const double area = measure(2, complex.vertices(2, t), rest);
            const int name = cuts->nameIn(t, whole);
            all += area;
            own += name == copy ? area : 0;
            kept += name == whole ? area : 0;
        }
        now.mass[copy] = mass[whole] * own / all;
        now.mass[whole] = mass[whole] * kept / all;
    }
    now.torn = cuts;
    return now;
}

std::vector<int> World::select(Range range,
                               const std::function<bool(const Vec<double>&)>& where) const {
    std::vector<int> chosen;
    for (int v = range.first; v < range.last; ++v)
        if (where(start[static_cast<std::size_t>(v)])) chosen.push_back(v);
    return chosen;
}

std::vector<double> World::effectiveMass() const {
    std::vector<double> masses = mass;
    for (std::size_t i = 0; i < masses.size(); ++i)
        if (pinned[i]) masses[i] = std::numeric_limits<double>::infinity();
    return masses;
}

void World::constrain(Recipe<Constraint> recipe, SetOptions options, bool contact) {
    if (!(options.damping >= 0 && options.damping <= 1))
        throw std::invalid_argument(options.name + ": damping must be in [0, 1]");
    sets.push_back({std::move(options), contact, std::move(recipe)});
}

void checkNumbers(const std::string& set, std::span<const double> numbers) {
    for (const double number : numbers)
        if (std::isnan(number)) throw std::invalid_argument(set + ": a row holds no number");
}

void checkStencils(const std::string& set, std::span<const int> ids, int arity, std::size_t rows,
                   std::span<const int> colors, std::size_t vertices) {
    const auto size = static_cast<std::size_t>(arity);
    if (ids.size() != size * rows)
        throw std::invalid_argument(set + ": " + std::to_string(rows) + " rows need " +
                                    std::to_string(size * rows) + " vertices, not " +
                                    std::to_string(ids.size()));
    for (const int v : ids)
        if (v < 0 || static_cast<std::size_t>(v) >= vertices)
            throw std::invalid_argument(set + ": there is no vertex " + std::to_string(v));
    if (colors.empty()) return;
    if (colors.size() != rows)
        throw std::invalid_argument(set + ": there must be one colour a row");
    std::vector<std::pair<int, int>> uses;
    for (std::size_t i = 0; i < ids.size(); ++i) uses.emplace_back(colors[i / size], ids[i]);
    std::sort(uses.begin(), uses.end());
    const auto twice = std::adjacent_find(uses.begin(), uses.end());
    if (uses.front().first < 0) throw std::invalid_argument(set + ": a colour is negative");
    if (twice != uses.end())
        throw std::invalid_argument(set + ": a colour has vertex " + std::to_string(twice->second) +
                                    " twice");
}

void World::checkThere(const std::string& set, std::span<const int> vertices) const {
    if (spare.empty()) return;
    for (const int v : vertices)
        if (isSpare(v))
            throw std::invalid_argument(set + ": vertex " + std::to_string(v) +
                                        " is not there from the start");
}

void World::checkWhole(const std::string& set, std::span<const int> vertices) const {
    for (const auto& [matter, ignored] : tearable)
        for (const int v : vertices)
            if (matter.first <= v && v < matter.last)
                throw std::invalid_argument(set + ": vertex " + std::to_string(v) +
                                            " may come apart, which this set cannot follow");
}

void World::sweepOut() {
    int at = -1, kept = 0;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        if (!sets[s].recipe.single) continue;
        if (static_cast<int>(s) == clusters) at = kept;
        ++kept;
    }
    clusters = at;
    std::erase_if(sets, [](const Set& set) { return !set.recipe.single; });
    std::erase_if(forces, [](const Recipe<Force>& force) { return !force.single; });
}

void World::warnOutside(const std::string& name, double value, double low, double high) {
    if (value >= low && value <= high) return;
    char text[160];
    std::snprintf(text, sizeof text, "%s = %g is outside [%g, %g]", name.c_str(), value, low, high);
    warnings.push_back(text);
}

}  // namespace plait
