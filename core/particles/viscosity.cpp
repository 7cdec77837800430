#include "viscosity.h"

#include "../numbers/convert.h"
#include "liquid_set.h"
#include "spline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

constexpr int someSlots = 256, wallSteps = 64;
// A particle is no nearer to a wall than this part of a spacing, as far as drag goes.
constexpr double nearest = 0.25;

// Of a pair at q radii: |dW/dr| r / (r^2 + 0.01 R^2), in 1/R^5 of a kernel whose value is 1 at 0.
double pairDrag(double q) { return -CubicSpline::slope(q) * q / (q * q + 0.01); }

// Behind a plane s radii away the liquid goes on with speeds that differ from ours as much more as
// it is farther away: the integral of pairDrag n n^T z / s over all that is there, along the plane
// and across it. Simpson's rule along r; over the directions of a shell in closed form.
struct WallDrag {
    double along, across;
};
WallDrag wallDrag(double s) {
    constexpr int steps = 64;
    WallDrag sum{0, 0};
    for (int i = 0; i <= steps; ++i) {
        const double q = s + (1 - s) * i / steps, c = s / q, cc = c * c;
        const double weight = (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * (1 - s) / (3 * steps);
        const double shell = weight * pairDrag(q) * q * q * q / s;
        sum.along += shell * pi / 4 * (1 - cc) * (1 - cc);
        sum.across += shell * pi / 2 * (1 - cc * cc);
    }
    return sum;
}

}  // namespace

template <class Real>
Viscosity<Real>::Viscosity(const World& world, const Liquid& liquid,
                           const ViscosityOptions& options)
    : options_(options),
      particles_(liquid.particles),
      spacing_(liquid.spacing),
      radius_(kernelRadius(liquid)),
      walls_(liquid.walls, radius_, options.name, Shades(liquid.walls.size())) {
    const auto refuse = [&](bool bad, const std::string& what) {
        if (bad) throw std::invalid_argument(options.name + ": " + what);
    };
    checkLiquid(world, liquid, options.name);
    for (const double number : {options.viscosity, options.wall})
        refuse(!(number >= 0) || !std::isfinite(number), "no number may be below 0");
    refuse(!(options.tolerance > 0), "the tolerance must be above 0");
    refuse(options.mostIterations < 1, "there must be an iteration");
    refuse(!options.factors.empty() && std::ssize(options.factors) != particles_.size(),
           "there must be one factor a particle");
    for (const double factor : options.factors)
        refuse(!(factor >= 0) || !std::isfinite(factor), "no factor may be below 0");
    origin_ = world.start[particles_.first];
    const double scale = viscousWalls * options.viscosity * radius_ / restSum;
    for (int i = 0; i <= wallSteps; ++i) {
        const double s = std::max(double(i) / wallSteps, nearest * spacing_ / radius_);
        const WallDrag drag = wallDrag(s);
        atWall_.push_back(scale * options.wall * drag.along);
        atWall_.push_back(scale * options.wall * drag.across);
    }
}

template <class Real>
void Viscosity<Real>::furnish(Drawer<Real>& kept) const {
    kept.integers.assign(numbers, 0);
    kept.numbers.assign(3 * static_cast<std::size_t>(particles_.size()), Real(0));
}

template <class Real>
void Viscosity<Real>::prepare(State<Real>& state, Drawer<Real>& kept, double t, double h,
                              Workers& workers) {
    sort(state, kept, workers);
    findLinks(workers);
    findWalls(t, h, workers);
    const int taken = solve(h, workers);
    kept.integers[last] = taken;
    kept.integers[all] += taken;
    kept.integers[tired] += options_.implicit && worst_ > options_.tolerance;
    const bool past = !state.lastVelocity.empty();
    workers.forBlocks(cells_.count(), someSlots, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            const int v = vertices_[s];
            const Vec<Real> change = v_[s] - right_[s];
            put(&kept.numbers[3 * (v - particles_.first)], as<double>(change));
            state.velocity[v].v += change;
            if (past) state.lastVelocity[v].v += change;
        }
    });
}

// What is not there, or is held, takes no part.
template <class Real>
void Viscosity<Real>::sort(const State<Real>& state, Drawer<Real>& kept, Workers& workers) {
    present_.clear();
    for (int v = particles_.first; v < particles_.last; ++v)
        if (state.particles[v].w > 0)
            present_.push_back(v);
        else
            put(&kept.numbers[3 * (v - particles_.first)], Vec<double>{});
    const auto n = present_.size();
    const auto position = [&](int i) { return as<Real>(state.position(present_[i]) - origin_); };
    cells_.sort(static_cast<int>(n), static_cast<Real>(radius_), position, workers);
    vertices_.resize(n), mass_.resize(n), factor_.resize(n);
    for (auto* vectors : {&right_, &v_, &next_, &before_, &residual_, &push_}) vectors->resize(n);
    wall_.resize(n), block_.resize(n);
    workers.forBlocks(cells_.count(), someSlots, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            const int v = vertices_[s] = present_[cells_.order()[s]];
            mass_[s] = 1 / state.particles[v].w;
            factor_[s] = options_.factors.empty()
                             ? Real(1)
                             : static_cast<Real>(options_.factors[v - particles_.first]);
            right_[s] = v_[s] = state.velocity[v].v;
            const Real* const change = &kept.numbers[3 * (v - particles_.first)];
            if (options_.implicit) v_[s] += Vec<Real>{change[0], change[1], change[2]};
        }
    });
}

template <class Real>
void Viscosity<Real>::findLinks(Workers& workers) {
    const Real squared = static_cast<Real>(radius_ * radius_);
    const auto eachNear = [&](int slot, const auto& visit) {
        const Vec<Real> at = cells_.point(slot);
        cells_.around(at, [&](int other) {
            const Vec<Real> to = cells_.point(other) - at;
            const Real d = dot(to, to);
            if (d < squared && other != slot) visit(other, to, d);
        });
    };
    start_.assign(static_cast<std::size_t>(cells_.count()) + 1, 0);
    workers.forBlocks(cells_.count(), someSlots, [&](int begin, int end) {
        for (int s = begin; s < end; ++s)
            eachNear(s, [&](int, const Vec<Real>&, Real) { ++start_[s + 1]; });
    });
    for (std::size_t s = 1; s < start_.size(); ++s) start_[s] += start_[s - 1];
    links_.resize(static_cast<std::size_t>(start_.back()));
    const double scale = viscousPairs * options_.viscosity * spacing_ * spacing_ * spacing_ /
                         (restSum * radius_ * radius_);
    workers.forBlocks(cells_.count(), someSlots, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            int l = start_[s];
            eachNear(s, [&](int other, const Vec<Real>& to, Real d) {
                const double drag = scale * pairDrag(squareRoot(double(d)) / radius_) *
                                    double(factor_[s] + factor_[other]) / 2;
                links_[l++] = {static_cast<Real>(squareRoot(divide(drag, double(d)))) * to, other};
            });
        }
    });
}

template <class Real>
void Viscosity<Real>::findWalls(double t, double h, Workers& workers) {
    walls_.beginFrame(t, t + h);
    walls_.begin({.h = h, .frameFraction = 0});
    workers.forBlocks(cells_.count(), someSlots, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            wall_[s] = {}, push_[s] = {};
            walls_.eachNear(origin_ + as<double>(cells_.point(s)), [&](const Side& side,
                                                                       const Vec<double>& way) {
                const auto at = static_cast<std::size_t>(
                    2 * std::lround(std::max(side.distance, 0.0) / radius_ * wallSteps));
                const double factor = double(factor_[s]);
                const Real along = static_cast<Real>(factor * atWall_[at]),
                           across = static_cast<Real>(factor * atWall_[at + 1]);
                Symmetric<Real> drag = Symmetric<Real>::diagonal(along);
                drag.addOuter(across - along, as<Real>(side.normal));
                wall_[s] += drag;
                push_[s] += drag * as<Real>(1 / h * way);
            });
        }
    });
}

// The blocks of the diagonal, and the greatest of their numbers over mass.
template <class Real>
double Viscosity<Real>::findBlocks(double h, Workers& workers) {
    const Real step = static_cast<Real>(h);
    workers.forBlocks(cells_.count(), someSlots, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            Symmetric<Real>& block = block_[s] = Symmetric<Real>::diagonal(mass_[s]);
            block.add(step, wall_[s]);
            for (int l = start_[s]; l < start_[s + 1]; ++l) block.addOuter(step, links_[l].u);
        }
    });
    double most = 1;
    for (int s = 0; s < cells_.count(); ++s) {
        const Symmetric<Real>& b = block_[s];
        const Real rows[] = {std::abs(b.xx) + std::abs(b.xy) + std::abs(b.xz),
                             std::abs(b.xy) + std::abs(b.yy) + std::abs(b.yz),
                             std::abs(b.xz) + std::abs(b.yz) + std::abs(b.zz)};
        most = std::max(most, double(*std::ranges::max_element(rows) / mass_[s]));
    }
    return most;
}

// residual_ <- M^-1 (M v - (M + h V) v'), in m/s: how much each would still change.
template <class Real>
void Viscosity<Real>::findResidual(double h, Workers& workers) {
    const Real step = static_cast<Real>(h);
    workers.forBlocks(cells_.count(), someSlots, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            const Vec<Real> v = v_[s];
            Vec<Real> force = push_[s] - wall_[s] * v;
            for (int l = start_[s]; l < start_[s + 1]; ++l) {
                const Link& link = links_[l];
                force += dot(link.u, v_[link.slot] - v) * link.u;
            }
            residual_[s] = right_[s] - v + step / mass_[s] * force;
        }
    });
    Real squared = 0;
    for (const Vec<Real>& r : residual_) squared = std::max(squared, dot(r, r));
    worst_ = squareRoot(double(squared));
}

// D the blocks: the eigenvalues of D^-1 (M + h V) lie between m and 2 - m, m the least mass over a
// block, whatever the links; so Chebyshev's weights are known. The last step is an explicit one,
// in which each link gives one what it takes from the other: small, where the tolerance is met.
template <class Real>
int Viscosity<Real>::solve(double h, Workers& workers) {
    findResidual(h, workers);
    if (options_.implicit && worst_ > options_.tolerance) {
        const double begun = worst_;  // with the change of the last substep
        v_.swap(next_), v_ = right_;
        findResidual(h, workers);
        if (worst_ > begun) {
            v_.swap(next_);
            findResidual(h, workers);
        }
    }
    int taken = 0;
    if (options_.implicit && worst_ > options_.tolerance) {
        const double radius = 1 - 1 / findBlocks(h, workers), squared = radius * radius;
        double weight = 1;
        before_ = v_;
        while (worst_ > options_.tolerance && taken < options_.mostIterations) {
            const Real by = static_cast<Real>(weight);
            workers.forBlocks(cells_.count(), someSlots, [&](int begin, int end) {
                for (int s = begin; s < end; ++s) {
                    const Vec<Real> jacobi = v_[s] + block_[s].solve(mass_[s] * residual_[s]);
                    next_[s] = before_[s] + by * (jacobi - before_[s]);
                }
            });
            before_.swap(v_), v_.swap(next_);
            weight = taken++ == 0 ? 2 / (2 - squared) : 4 / (4 - squared * weight);
            findResidual(h, workers);
        }
    }
    if (!options_.implicit || worst_ <= options_.tolerance)
        workers.forBlocks(cells_.count(), someSlots, [&](int begin, int end) {
            for (int s = begin; s < end; ++s) v_[s] += residual_[s];
        });
    return taken;
}

void actViscosity(World& world, const Liquid& liquid, const ViscosityOptions& options) {
    const auto make = [liquid, options]<class Real>(const World& made,
                                                    KernelChoice) -> std::unique_ptr<Force<Real>> {
        return std::make_unique<Viscosity<Real>>(made, liquid, options);
    };
    const Viscosity<double> refusesWhatIsWrong(world, liquid, options);
    world.forces.push_back(recipeOf<Force>(make));
}

template class Viscosity<float>;
template class Viscosity<double>;

}  // namespace plait
