#include "source.h"

#include "../numbers/elementary.h"
#include "../numbers/splitmix.h"
#include "../world.h"
#include "population.h"

#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

enum { placeNumber = 0, velocityNumber = 16, lifespanNumber = 32 };

// Even in a ball of radius 1: a direction by Archimedes' hat box, a radius by its cube.
Vec<double> inBall(std::int32_t id, std::uint64_t seed, int which) {
    const double up = 2 * numberOf(id, seed, which) - 1;
    const double turn = 2 * pi * numberOf(id, seed, which + 1);
    const double r = power(numberOf(id, seed, which + 2), 1.0 / 3);
    const double out = squareRoot(1 - up * up);
    return r * Vec<double>{out * cosine(turn), up, out * sine(turn)};
}

}  // namespace

double numberOf(std::int32_t id, std::uint64_t seed, int which) {
    // Splitmix steps by a constant: ids a prime apart in another one do not run into each other.
    Splitmix chance(seed * 0xd1342543de82ef95 +
                    static_cast<std::uint64_t>(id) * 0x2545f4914f6cdd1d +
                    static_cast<std::uint64_t>(which) * 0x9e6c63d0876a9a99);
    chance.next();
    return chance.next();
}

double lifespanOf(const SourceOptions& options, std::int32_t id) {
    return options.lifespan +
           options.lifespanSpread * (2 * numberOf(id, options.seed, lifespanNumber) - 1);
}

template <class Real>
Source<Real>::Source(const World& world, const SourceOptions& options) : options_(options) {
    const auto refuse = [&](bool bad, const char* what) {
        if (bad) throw std::invalid_argument(options.name + ": " + what);
    };
    const auto vertices = static_cast<int>(world.start.size());
    const Range spare = options.spare;
    refuse(spare.first < 0 || spare.first >= spare.last || spare.last > vertices,
           "its vertices are not in the world");
    for (int v = spare.first; v < spare.last; ++v)
        refuse(!world.isSpare(v), "it brings spare vertices only");
    refuse(options.nozzle.empty(), "its nozzle has no point");
    refuse(!(options.every > 0) || !std::isfinite(options.every),
           "the time between volleys must be above 0");
    refuse(!std::isfinite(options.from) || std::isnan(options.until), "begins or ends at no time");
    refuse(!(options.lifespan > 0) || !(options.lifespanSpread >= 0) ||
               (options.lifespanSpread > 0 && !(options.lifespanSpread < options.lifespan)),
           "a lifespan must be above 0");
    refuse(!(options.hold >= 0), "it holds for no less than 0 s");
    for (const double number : {options.velocity.x, options.velocity.y, options.velocity.z,
                                options.scatter, options.scatterVelocity})
        refuse(!std::isfinite(number), "all numbers must be finite");
    waiting_.assign(world.start.begin() + spare.first, world.start.begin() + spare.last);
    mass_.assign(world.mass.begin() + spare.first, world.mass.begin() + spare.last);
}

template <class Real>
void Source<Real>::furnish(Drawer<Real>& kept) const {
    kept.integers.assign(numbers, 0);
}

template <class Real>
double Source<Real>::birth(std::int32_t id) const {
    const auto volley = id / static_cast<std::int32_t>(options_.nozzle.size());
    return options_.from + volley * options_.every;
}

// Straight on from where it was born, so that volleys are evenly spaced whatever h is.
template <class Real>
Arrival Source<Real>::at(int v, std::int32_t id, double t) const {
    Vec<double> place = options_.nozzle[id % std::ssize(options_.nozzle)] +
                        options_.scatter * inBall(id, options_.seed, placeNumber);
    Vec<double> velocity =
        options_.velocity + options_.scatterVelocity * inBall(id, options_.seed, velocityNumber);
    const double when = birth(id);
    if (options_.motion) {
        const Placement axes(options_.motion(when), options_.name);
        place = axes.world(place), velocity = axes.worldWay(velocity);
    }
    return {.id = id,
            .x = place + (t - when) * velocity,
            .v = velocity,
            .mass = mass_[v - options_.spare.first]};
}

template <class Real>
void Source<Real>::age(Population<Real>& population, const State<Real>& state, double t) const {
    const Range spare = options_.spare;
    for (int v = spare.first; v < spare.last; ++v) {
        if (!population.isHere(v)) continue;
        const std::int32_t id = state.id[v];
        if (options_.lifespan < infinity && population.age(v) >= lifespanOf(options_, id))
            population.take(v, waiting_[v - spare.first]);
        else if (t - birth(id) < options_.hold)
            population.move(v, at(v, id, t));
    }
}

template <class Real>
void Source<Real>::prepare(State<Real>& state, Drawer<Real>& kept, double t, double h, Workers&) {
    Population<Real> population(state, h);
    age(population, state, t);
    std::int32_t& next = kept.integers[births];
    for (int free = options_.spare.first;; ++next) {
        const double when = birth(next);
        if (when > t + 1e-9 * h || when >= options_.until) return;
        while (free < options_.spare.last && population.isHere(free)) ++free;
        if (free < options_.spare.last)
            population.bring(free, at(free, next, t));
        else
            ++kept.integers[misses];
    }
}

template class Source<float>;
template class Source<double>;

}  // namespace plait
