// What brings matter: particles from a nozzle, volley by volley [PA1, PA2, PA4].
#pragma once

#include "../contacts/solids/placement.h"
#include "../force.h"

#include <cstdint>
#include <vector>

namespace plait {

struct World;
struct Arrival;
template <class Real>
class Population;

// Of what a source has brought, a number that stays with it for life: 0 to 1, without 1, from its
// id and the source's seed alone; `which` tells several from each other.
double numberOf(std::int32_t id, std::uint64_t seed, int which);

struct SourceOptions {
    std::string name = "source";
    Range spare{};                         // vertices that it brings, all of them spare
    std::vector<Vec<double>> nozzle = {};  // m, in its own axes: a volley is a vertex at each
    Vec<double> velocity{0, 0, 0};         // m/s, in its own axes
    Posing motion = {};                    // where its axes are; none: those of the world
    double every = 1;                      // s from one volley to the next
    double from = 0, until = infinity;     // s: the first volley; none at `until` or later
    // How far off place and velocity may be: even in a ball of this radius, m, and m/s.
    double scatter = 0, scatterVelocity = 0;
    // s that what comes still goes as it came, whatever pushes or pulls, as what is in a nozzle
    // does.
    double hold = 0;
    double lifespan = infinity;  // s
    double lifespanSpread = 0;   // s, more or less, evenly
    std::uint64_t seed = 1;
};

// s, of what has this id.
double lifespanOf(const SourceOptions& options, std::int32_t id);

template <class Real>
class Source : public Force<Real> {
public:
    // Throws std::invalid_argument, naming the source, for vertices that are not spare, a nozzle
    // without a point, a time between volleys that is not above 0, and numbers that are none.
    Source(const World& world, const SourceOptions& options);

    std::string name() const override { return options_.name; }
    void furnish(Drawer<Real>& kept) const override;
    void prepare(State<Real>& state, Drawer<Real>& kept, double t, double h,
                 Workers& workers) override;
    void apply(State<Real>&, double, double, Workers&) override {}

    // Of its drawer: how many it has brought, and how many births found no spare vertex.
    static int brought(const Drawer<Real>& kept) { return kept.integers[births] - missed(kept); }
    static int missed(const Drawer<Real>& kept) { return kept.integers[misses]; }

private:
    enum { births, misses, numbers };

    double birth(std::int32_t id) const;                 // s
    Arrival at(int v, std::int32_t id, double t) const;  // at a time
    void age(Population<Real>& population, const State<Real>& state, double t) const;

    SourceOptions options_;
    std::vector<Vec<double>> waiting_;  // m
    std::vector<double> mass_;          // kg
};

}  // namespace plait
