#include "walls.h"

#include "spline.h"

#include <cmath>

namespace plait {

Shades Walls::shadesOf(const std::vector<Collider>& colliders, double radius) {
    Shades shades;
    for (const Collider& c : colliders)
        shades.push_back(c.solid.profile
                             ? std::make_shared<const TurnedShade>(*c.solid.profile, radius)
                             : nullptr);
    return shades;
}

Walls::Walls(const std::vector<Collider>& colliders, double radius, const std::string& who,
             const Shades& shades)
    : radius_(radius), who_(who) {
    const Shades made = shades.size() == colliders.size() ? shades : shadesOf(colliders, radius);
    for (std::size_t i = 0; i < colliders.size(); ++i) {
        const Collider& c = colliders[i];
        const Placement at(c.motion ? c.motion(0) : c.frame, who);
        bodies_.push_back({c, at, at, {}, at, made[i]});
    }
}

void Walls::beginFrame(double t0, double t1) {
    for (Body& body : bodies_) {
        if (!body.collider.motion) continue;
        body.from = body.now = Placement(body.collider.motion(t0), who_);
        body.to = Placement(body.collider.motion(t1), who_);
        body.turn = turnBetween(body.from, body.to);
    }
}

void Walls::begin(const Substep& substep) {
    for (Body& body : bodies_)
        if (body.collider.motion)
            body.now = between(body.from, body.to, body.turn, substep.frameFraction);
}

// A box is where three slabs meet: the product of their parts. What is round counts as the plane
// that touches it where it is nearest, which is right for radii much larger than the kernel's.
Shade Walls::of(const Body& body, const Vec<double>& p) const {
    if (body.shade) {
        const double r = squareRoot(p.x * p.x + p.z * p.z);
        const TurnedShade::At at = body.shade->at(r, p.y);
        const double outward = divide(at.byRadius, r);
        return {at.part, {outward * p.x, at.byHeight, outward * p.z}};
    }
    const Solid& solid = body.collider.solid;
    const bool flat = !solid.halfSpace && solid.radius == 0;
    if (flat) return ofBox(solid.half, p);
    const Side side = sideOf(solid, p);
    const double s = side.distance / radius_;
    if (s >= 1) return {};
    return {CubicSpline::beyond(s), CubicSpline::beyondSlope(s) / radius_ * side.normal};
}

Shade Walls::ofBox(const Vec<double>& half, const Vec<double>& p) const {
    const auto slab = [&](double x, double h, double& slope) {
        const double near = (std::fabs(x) - h) / radius_, far = (std::fabs(x) + h) / radius_;
        const double rise = CubicSpline::beyondSlope(near) - CubicSpline::beyondSlope(far);
        slope = (x < 0 ? -rise : rise) / radius_;
        return CubicSpline::beyond(near) - CubicSpline::beyond(far);
    };
    Vec<double> slope;
    const double x = slab(p.x, half.x, slope.x), y = slab(p.y, half.y, slope.y),
                 z = slab(p.z, half.z, slope.z);
    return {x * y * z, {slope.x * y * z, x * slope.y * z, x * y * slope.z}};
}

Shade Walls::at(const Vec<double>& point) const {
    double open = 1;
    Vec<double> gradient{0, 0, 0};
    for (const Body& body : bodies_) {
        const Shade one = of(body, body.now.own(point));
        gradient = (1 - one.part) * gradient + open * body.now.worldWay(one.gradient);
        open *= 1 - one.part;
    }
    return {1 - open, gradient};
}

bool Walls::near(const Vec<double>& point, double reach) const {
    for (const Body& body : bodies_)
        if (sideOf(body.collider.solid, body.now.own(point)).distance < radius_ + reach)
            return true;
    return false;
}

}  // namespace plait
