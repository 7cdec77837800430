#include "air.h"

#include "../forces/noise.h"
#include "../world.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr int grain = 256;

void validate(const AirOptions& options) {
    const auto refuse = [](bool bad, const char* what) {
        if (bad) throw std::invalid_argument(std::string("air: ") + what);
    };
    const Wind& wind = options.wind;
    for (const double value : {options.density, options.drag, options.tangentialDrag, options.lift,
                               options.width, wind.noise, wind.noiseLength, wind.noiseTime,
                               wind.noiseDrift.x, wind.noiseDrift.y, wind.noiseDrift.z})
        refuse(!std::isfinite(value), "all numbers must be finite");
    for (const double value : {options.carried.mass, options.carried.reach})
        refuse(!(value >= 0) || !std::isfinite(value),
               "mass and reach of carried air must be finite and not negative");
    refuse(options.carried.mass > 0 && options.carried.reach == 0,
           "carried air must reach somewhere");
    refuse(options.width < 0, "width must not be negative");
    refuse(options.interval < 1, "interval must be at least 1");
    refuse(wind.noise < 0, "noise must not be negative");
    refuse(wind.noiseLength <= 0, "noise length must be positive");
    refuse(wind.noiseTime <= 0, "noise time must be positive");
}

RestFacets facetsOf(const World& world, const AirOptions& options) {
    validate(options);
    return restFacets(world, options.objects, options.width);
}

template <class Real>
std::array<AirSkin<Real>, 2> skinsOf(const RestFacets& facets, int vertices) {
    const std::vector<double> shares = areaShares(facets, vertices);
    return {AirSkin<Real>(2, facets[0], shares, vertices),
            AirSkin<Real>(3, facets[1], shares, vertices)};
}

}  // namespace

void actAir(World& world, const AirOptions& options) {
    validate(options);
    const double thinPlate = 6.2831853071795865;
    const bool legacy = options.form == AirForm::legacy;
    world.warnOutside("air density", options.density, 0, infinity);
    world.warnOutside("air drag", options.drag, 0, infinity);
    world.warnOutside("air tangential drag", options.tangentialDrag, 0, 1);
    world.warnOutside("air lift", options.lift, 0,
                      legacy ? std::max(options.drag, 0.0) : thinPlate);
    world.act<Air>(options);
    const auto offer = [&](const std::string& without, auto AirOptions::* part) {
        if (options.*part == 0) return;
        AirOptions less = options;
        less.*part = 0;
        world.forces.back().offer("without " + without, World::recipeOfForce<Air>(less));
    };
    if (options.carried.mass > 0) {
        AirOptions less = options;
        less.carried = {};
        world.forces.back().offer("without what it carries", World::recipeOfForce<Air>(less));
    }
    offer("drag along itself", &AirOptions::tangentialDrag);
    offer("lift", &AirOptions::lift);
    AirOptions calm = options, rare = options;
    calm.wind.noise = 0;
    rare.interval *= 2;
    if (options.wind.noise > 0)
        world.forces.back().offer("without gusts", World::recipeOfForce<Air>(calm));
    world.forces.back().offer("half as often", World::recipeOfForce<Air>(rare));
}

template <class Real>
Air<Real>::Air(const World& world, const AirOptions& options, KernelChoice kernels)
    : options_(options),
      kernels_(airKernels<Real>(kernels)),
      skins_(skinsOf<Real>(facetsOf(world, options), static_cast<int>(world.rest.size()))) {
    if (options.carried.mass > 0)
        carried_ = std::make_unique<CarriedAir<Real>>(
            restFacets(world, options.objects, options.width)[1],
            static_cast<int>(world.rest.size()), options.carried);
    if (options.wind.noise > 0)
        for (AirSkin<Real>& skin : skins_) skin.makeGusts();
}

template <class Real>
Vec<double> Air<Real>::gust(const Vec<double>& x, double t) const {
    const Wind& wind = options_.wind;
    const Vec<double> cells = (1 / wind.noiseLength) * (x - t * wind.noiseDrift);
    return wind.noise * coherentNoise(cells, t / wind.noiseTime, wind.seed);
}

template <class Real>
void Air<Real>::furnish(Drawer<Real>& kept) const {
    if (carried_) kept.numbers.assign(carried_->numbers(), Real(0));
}

template <class Real>
void Air<Real>::beginFrame(const State<Real>& state, double t0, double t1, Workers& workers) {
    if (options_.wind.noise == 0) return;
    from_ = t0, to_ = t1;
    for (AirSkin<Real>& skin : skins_)
        workers.forBlocks(skin.size(), grain, [&](int begin, int end) {
            for (int f = begin; f < end; ++f) {
                Vec<double> middle{0, 0, 0};
                for (int c = 0; c < skin.corners(); ++c)
                    middle += (1.0 / skin.corners()) * state.position(skin.vertex(f, c));
                const Vec<double> now = gust(middle, t0);
                skin.setGust(f, now, t1 > t0 ? gust(middle, t1) - now : Vec<double>{0, 0, 0});
            }
        });
}

template <class Real>
AirStep<Real> Air<Real>::stepOf(State<Real>& state, double t) const {
    AirStep<Real> step{};
    step.wind[0] = static_cast<Real>(wind_.x);
    step.wind[1] = static_cast<Real>(wind_.y);
    step.wind[2] = static_cast<Real>(wind_.z);
    step.gust = static_cast<Real>(divide(t - from_, to_ - from_));
    step.particles = &state.particles[0].x.x;
    step.velocity = &state.velocity[0].v.x;
    return step;
}

template <class Real>
void Air<Real>::prepare(State<Real>& state, Drawer<Real>& kept, double t, double h,
                        Workers& workers) {
    if (rests(state)) return;
    if (!(t >= from_ && t < to_)) beginFrame(state, t, t, workers);  // there are no frames
    wind_ = options_.wind.velocity ? options_.wind.velocity(t) : Vec<double>{};
    const AirStep<Real> step = stepOf(state, t);
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const FacetBlocks<Real> facets = skins_[kind].blocks();
        workers.forBlocks(skins_[kind].size(), grain, [&](int begin, int end) {
            kernels_.sides[kind](step, facets, begin, end);
        });
    }
    if (carried_)
        carried_->exchange(state, kept.numbers.data(), step, skins_[1], kernels_,
                           h * options_.interval, workers);
}

template <class Real>
void Air<Real>::apply(State<Real>& state, double t, double h, Workers& workers) {
    if (rests(state)) return;
    const bool legacy = options_.form == AirForm::legacy;
    const double force = h * options_.interval * options_.density * (legacy ? 1 : 0.5),
                 drag = force * options_.drag;
    AirStep<Real> step = stepOf(state, t);
    step.drag = static_cast<Real>(drag);
    step.tangential = static_cast<Real>(drag * options_.tangentialDrag);
    step.lift = static_cast<Real>(force * options_.lift);
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const FacetBlocks<Real> facets = skins_[kind].blocks();
        workers.forBlocks(skins_[kind].size(), grain, [&](int begin, int end) {
            kernels_.impulses[legacy][kind](step, facets, begin, end);
        });
    }
    for (const AirSkin<Real>& skin : skins_) {
        const AroundBlocks<Real> around = skin.around();
        workers.forBlocks(skin.vertices(), grain, [&](int begin, int end) {
            kernels_.velocities(step, around, &skin.impulses[0].v.x, begin, end);
        });
    }
}

template <class Real>
Vec<double> Air<Real>::impulse() const {
    Vec<double> sum = carried_ ? carried_->impulse() : Vec<double>{};
    for (const AirSkin<Real>& skin : skins_)
        for (const Padded<Real>& p : skin.impulses)
            sum +=
                double(skin.corners()) * Vec<double>{double(p.v.x), double(p.v.y), double(p.v.z)};
    return sum;
}

template class Air<float>;
template class Air<double>;

}  // namespace plait
