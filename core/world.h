// What is simulated, before anyone decides how: matter, pins, and recipes of sets of constraints
// and of forces, in double. Solvers of either precision are made from it, any number of them. It
// knows no set by name: what adds one is a function in the header of that set, as meet, holdSheet
// and actAir.
#pragma once

#include "complex/cuts.h"
#include "complex/shapes.h"
#include "constraint.h"
#include "constraints/rows.h"
#include "force.h"
#include "schedule.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace plait {

// How a shape becomes matter.
struct Matter {
    double density = 1;                   // kg/m^3, kg/m^2, kg/m or kg: by its simplices of highest
                                          // dimension; mass is lumped equally on their vertices
    std::vector<Vec<double>> start = {};  // m; empty: the shape itself, which is the rest shape
    std::vector<Vec<double>> velocity = {};  // m/s; empty: at rest
    // Vertices behind the shape's, not there until a source brings them (sources/): points of the
    // density's mass, which wait where the shape's first vertex starts, or at the origin.
    int spare = 0;
};

// Where a pinned vertex is at time t (s), given where it started (m).
using Motion = std::function<Vec<double>(const Vec<double>& start, double t)>;

// Where pinned vertices are at time t (s), all at once, as a character's surface is: `positions`
// (m) has one a vertex, in the order in which they were pinned, and holds where they started.
using Animation = std::function<void(double t, std::span<Vec<double>> positions)>;

struct SetOptions {
    std::string name;
    int order = 0;              // place in a column, later wins
    int importance = 24;        // evaluations in 1/24 s
    int secondaryInterval = 0;  // N: in every N-th pass only (Vellum's secondary pass)
    double damping = 0;         // part of the rate of C that is lost in 1/24 s, 0 to 1
    bool direct = false;        // solved at once in O(N); for links that form chains and trees
};

struct World;

// Anything that can be made in either precision.
template <template <class> class Base>
struct Recipe {
    std::function<std::unique_ptr<Base<float>>(const World&, KernelChoice)> single;
    std::function<std::unique_ptr<Base<double>>(const World&, KernelChoice)> full;
    // What may be made in its place, and of each what is less of it: so whoever wants to know
    // whether a world needs as much can try.
    std::vector<Recipe> lesser = {};
    std::string less = {};

    void offer(std::string how, Recipe recipe) {
        recipe.less = std::move(how);
        lesser.push_back(std::move(recipe));
    }

    template <class Real>
    std::unique_ptr<Base<Real>> make(const World& world, KernelChoice kernels) const {
        if constexpr (std::is_same_v<Real, float>)
            return single(world, kernels);
        else
            return full(world, kernels);
    }
};

// That of a generic lambda, make<Real>(world, kernels).
template <template <class> class Base, class Make>
Recipe<Base> recipeOf(const Make& make) {
    return {
        [make](const World& w, KernelChoice k) { return make.template operator()<float>(w, k); },
        [make](const World& w, KernelChoice k) { return make.template operator()<double>(w, k); }};
}

struct World {
    SimplicialComplex complex;
    std::vector<Vec<double>> rest, start, velocity;  // m, m, m/s, by vertex
    std::vector<double> mass;                        // kg, by vertex
    std::vector<unsigned char> pinned;               // 1: moves only as told
    std::vector<Range> spare;                        // not there as a run begins, ascending

    struct Pins {
        std::vector<int> vertices;
        Animation animation;  // none: they stay
    };
    struct Release {
        std::vector<int> vertices;
        double time;  // s
    };
    struct Set {
        SetOptions options;
        bool contact;
        Recipe<Constraint> recipe;
    };
    std::vector<Range> pieces;  // what moves as one (pieces/piece.h)
    int clusters = -1;  // the set whose drawer has, first of its integers, a piece each that says
                        // with which it moves as one (fracture/welds.h); -1: none
    std::vector<Tearable> tearable;    // what may come apart (tearing/)
    std::shared_ptr<const Cuts> torn;  // how it has; null: it has not. `complex` is as it is now
    std::vector<Pins> pins;
    std::vector<Release> releases;
    std::vector<Set> sets;
    std::vector<Recipe<Force>> forces;
    double gravity = 0;  // m/s^2, the strongest that acts: how fast what rests comes to approach
    std::vector<std::string> warnings;  // values outside their sensible range, one line each [FH15]

    // Adds a shape and returns its vertices. Throws std::invalid_argument for a density that is not
    // positive and finite, fewer spare vertices than none, or for a start or velocity of another
    // length than the shape.
    Range add(const Shape& shape, const Matter& matter = {});

    // Pinned vertices have no inverse mass: nothing but `motion` or `animation` moves them. These
    // must be functions of t alone, and are asked at both ends of a frame, or of each of
    // SolverOptions::baseSteps; between them a vertex goes straight and steadily (M 2.4) [IN27].
    // Throws std::invalid_argument for a vertex that is not there.
    void pin(std::vector<int> vertices, Motion motion = {});
    void pin(std::vector<int> vertices, Animation animation);
    // These are pinned no more from the first frame on that begins at `time` (s) or later: they go
    // on as they went. Throws std::invalid_argument for a vertex that is not pinned and for a time
    // that is no number.
    void letGo(std::vector<int> vertices, double time);
    // How many releases have come by `time`, and the world with these.
    int releasesBy(double time) const;
    World releasedBy(double time) const;
    // The world where this has come apart (State::cuts), in this order: copies lie where
    // their vertices do, and have their part of the mass, by rest area. What is made from it knows
    // by `torn` what its vertices are called now.
    World tornBy(std::span<const std::int32_t> entries) const;
    // By vertex: which vertex it is a copy of, until it has parted from that, or itself; -1 of a
    // spare one of what may come apart that is not there yet. Empty where nothing may.
    std::vector<int> wholes() const;
    // How it comes apart, from the first on; what is pinned, now or until a release, does not.
    Cuts uncut() const;
    // The vertices of `range` whose start satisfies `where`.
    std::vector<int> select(Range range,
                            const std::function<bool(const Vec<double>&)>& where) const;

    // Of a kind that is not the core's own, a program includes sets/constrain.h as well.
    template <class Kind>
    void constrain(Rows<Kind> rows, SetOptions options);
    // A set of the user's own; `make` is called once for each solver.
    void constrain(Recipe<Constraint> recipe, SetOptions options, bool contact = false);

    // By vertex, kg; infinite where pinned.
    std::vector<double> effectiveMass() const;

    // F<Real> is a Force<Real> made from (World, options), or, where it has kernels of its own,
    // from (World, options, KernelChoice).
    template <template <class> class F, class Options>
    void act(Options options);
    template <template <class> class F, class Options>
    static Recipe<Force> recipeOfForce(Options options);

    bool isSpare(int v) const {
        return std::ranges::any_of(
            spare, [&](const Range& range) { return range.first <= v && v < range.last; });
    }

    // Throws std::invalid_argument, naming the set, for a vertex that is spare: constraints are for
    // what is there from the start (M 3.1.3) [AT21].
    void checkThere(const std::string& set, std::span<const int> vertices) const;
    // The same for a vertex that may come apart: of sets that cannot follow.
    void checkWhole(const std::string& set, std::span<const int> vertices) const;

    // Takes out sets and forces whose recipe has become empty, {}.
    void sweepOut();

    // Notes a value outside [low, high] by name.
    void warnOutside(const std::string& name, double value, double low, double high);
};

// Throws std::invalid_argument, naming the set, unless there are `arity` vertices a row, all of
// them below `vertices`, and no vertex twice in a colour (where colours are given).
void checkStencils(const std::string& set, std::span<const int> ids, int arity, std::size_t rows,
                   std::span<const int> colors, std::size_t vertices);
// Throws std::invalid_argument, naming the set, if one of its rows' numbers is NaN, which guarded
// divisions would pass over.
void checkNumbers(const std::string& set, std::span<const double> numbers);
// Both, of rows for a world of as many vertices.
template <class Kind>
void checkRows(const std::string& set, const Rows<Kind>& rows, std::size_t vertices) {
    checkStencils(set, rows.ids, Kind::arity, rows.rows.size(), rows.colors, vertices);
    checkNumbers(set, numbersOf(rows));
}

template <template <class> class F, class Options>
Recipe<Force> World::recipeOfForce(Options options) {
    const auto make = [options]<class Real>(const World& world,
                                            KernelChoice kernels) -> std::unique_ptr<Force<Real>> {
        if constexpr (std::is_constructible_v<F<Real>, const World&, const Options&, KernelChoice>)
            return std::make_unique<F<Real>>(world, options, kernels);
        else
            return std::make_unique<F<Real>>(world, options);
    };
    return recipeOf<Force>(make);
}

template <template <class> class F, class Options>
void World::act(Options options) {
    if constexpr (requires { options.strength(); }) gravity = std::max(gravity, options.strength());
    forces.push_back(recipeOfForce<F>(std::move(options)));
}

}  // namespace plait
