#include "tension.h"

#include "../constraints/constants.h"
#include "../numbers/convert.h"
#include "../numbers/elementary.h"
#include "spline.h"

#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

constexpr int slotsATime = 256;
constexpr double seen = 4;  // spacings: R
// The sum of the kernel over settled water.
constexpr double settledSum = 0.998 * pi / 8 * seen * seen * seen;
// b: more would pull deeper down, where water cannot follow; less leaves more pressure.
constexpr double blend = 0.06;
// What a surface of particles costs of what a surface of a continuum would, since the first of them
// lie less than half a spacing under it: so that drops of 6 to 9 spacings swing as Rayleigh's.
constexpr double sampled = 0.66;

// From 0 to 1, by Simpson's rule.
template <class Function>
double integral(const Function& f) {
    constexpr int steps = 200;
    double sum = 0;
    for (int i = 0; i <= steps; ++i)
        sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * f(double(i) / steps);
    return sum / (3 * steps);
}

// E of an area of flat surface over a R: at a depth of s radii 1 - c is what lies beyond.
double flatEnergy() {
    return integral([](double s) {
        const double lack = CubicSpline::beyond(s), slope = CubicSpline::beyondSlope(s);
        return (lack * lack + blend * slope * slope) / 2;
    });
}

// The kernel at q < 1 radii, and its derivatives by q.
template <class Real>
struct WideKernel {
    Real value, slope, curve;
};
template <class Real>
WideKernel<Real> kernelAt(Real q) {
    const Real t = 1 - q, u = std::max(Real(0.5) - q, Real(0));
    return {2 * t * t * t - 8 * u * u * u, 24 * u * u - 6 * t * t, 12 * t - 48 * u};
}

// visit(other, apart over R, q) of all others within R.
template <class Real, class Visit>
void eachNear(const Cells<Real>& cells, int slot, double radius, const Visit& visit) {
    const Real per = static_cast<Real>(1 / radius);
    const Vec<Real> at = cells.point(slot);
    cells.around(at, [&](int other) {
        const Vec<Real> apart = per * (at - cells.point(other));
        const Real squared = dot(apart, apart);
        if (squared < 1 && squared > 0) visit(other, apart, squareRoot(squared));
    });
}

}  // namespace

template <class Real>
Tension<Real>::Tension(const World& world, const Liquid& liquid, const TensionOptions& options)
    : options_(options),
      particles_(liquid.particles),
      volume_(std::pow(liquid.spacing, 3)),
      radius_(seen * liquid.spacing),
      walls_(liquid.walls, radius_, options.name) {
    const auto refuse = [&](bool bad, const std::string& what) {
        if (bad) throw std::invalid_argument(options.name + ": " + what);
    };
    checkLiquid(world, liquid, options.name);
    refuse(!(options.tension >= 0) || !std::isfinite(options.tension),
           "the tension may not be below 0");
    refuse(!(options.angle >= 0 && options.angle <= 180),
           "the angle must be from 0 to 180 degrees");
    refuse(options.interval < 1, "the interval must be at least 1");
    origin_ = world.start[particles_.first];
    stiffness_ = options.tension / (sampled * radius_ * flatEnergy());
    drawn_ = volume_ * options.tension * cosine(pi / 180 * options.angle) /
             (radius_ * integral(CubicSpline::beyond));
}

template <class Real>
void Tension<Real>::apply(State<Real>& state, double t, double h, Workers& workers) {
    if (state.substep % options_.interval != 0) return;
    sort(state, workers);
    walls_.beginFrame(t, t + h);
    walls_.begin({.h = h, .frameFraction = 0});
    sum(workers);
    const Real duration = static_cast<Real>(h * options_.interval);
    workers.forBlocks(cells_.count(), slotsATime, [&](int begin, int end) {
        for (int s = begin; s < end; ++s)
            push(state, static_cast<std::size_t>(present_[cells_.order()[s]]),
                 duration * forceOn(s));
    });
}

template <class Real>
double Tension<Real>::energy() const {
    double sum = 0;
    for (int s = 0; s < cells_.count(); ++s) {
        const double lack = double(lack_[s]);
        const Vec<double> slope = radius_ * as<double>(slope_[s]);
        sum += lack * lack + blend * dot(slope, slope);
    }
    return volume_ * stiffness_ / 2 * sum;
}

template <class Real>
void Tension<Real>::sort(const State<Real>& state, Workers& workers) {
    present_.clear();
    for (int v = particles_.first; v < particles_.last; ++v)
        if (state.particles[v].w > 0) present_.push_back(v);
    const auto position = [&](int i) { return as<Real>(state.position(present_[i]) - origin_); };
    cells_.sort(static_cast<int>(present_.size()), static_cast<Real>(radius_), position, workers);
    lack_.resize(present_.size());
    slope_.resize(present_.size()), wall_.resize(present_.size());
}

template <class Real>
void Tension<Real>::sum(Workers& workers) {
    const Real per = static_cast<Real>(1 / settledSum);
    workers.forBlocks(cells_.count(), slotsATime, [&](int begin, int end) {
        for (int s = begin; s < end; ++s) {
            Real sum = kernelAt(Real(0)).value;
            Vec<Real> slope{};
            eachNear(cells_, s, radius_, [&](int, const Vec<Real>& apart, Real q) {
                const WideKernel<Real> kernel = kernelAt(q);
                sum += kernel.value;
                slope += (kernel.slope / q) * apart;
            });
            lack_[s] = 1 - per * sum;
            slope_[s] = static_cast<Real>(1 / (settledSum * radius_)) * slope;
            wall_[s] = {};
            if (walls_.empty()) continue;
            const Shade shade = walls_.at(origin_ + as<double>(cells_.point(s)));
            lack_[s] -= static_cast<Real>(shade.part);
            wall_[s] = as<Real>(shade.gradient);
        }
    });
}

// N. Of pairs both get the same and opposite.
template <class Real>
Vec<Real> Tension<Real>::forceOn(int slot) const {
    Vec<Real> in{}, out{};
    eachNear(cells_, slot, radius_, [&](int other, const Vec<Real>& apart, Real q) {
        const WideKernel<Real> kernel = kernelAt(q);
        const Real slope = kernel.slope / q;
        in += ((lack_[slot] + lack_[other]) * slope) * apart;
        const Vec<Real> differ = slope_[slot] - slope_[other];
        out += slope * differ + ((kernel.curve - slope) / (q * q) * dot(differ, apart)) * apart;
    });
    const double pull = volume_ * stiffness_;
    return static_cast<Real>(pull / (settledSum * radius_)) * in -
           static_cast<Real>(blend * pull / settledSum) * out +
           static_cast<Real>(pull * double(lack_[slot]) + drawn_) * wall_[slot];
}

void actTension(World& world, const Liquid& liquid, const TensionOptions& options) {
    const auto make = [liquid, options]<class Real>(const World& made,
                                                    KernelChoice) -> std::unique_ptr<Force<Real>> {
        return std::make_unique<Tension<Real>>(made, liquid, options);
    };
    const Tension<double> refusesWhatIsWrong(world, liquid, options);
    world.forces.push_back(recipeOf<Force>(make));
}

template class Tension<float>;
template class Tension<double>;

}  // namespace plait
