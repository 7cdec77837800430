#include "expression.h"

#include "../numbers/convert.h"

#include <stdexcept>

namespace plait {
namespace {

template <class Real>
class ExpressionSet : public Constraint<Real> {
public:
    ExpressionSet(Range range, Expression expression)
        : range_(range), expression_(std::move(expression)) {}

    void project(const Sweep<Real>&, Direction, Workers&) override {}
    void settle(State<Real>& state, Drawer<Real>&, double t, double h) override {
        for (int v = range_.first; v < range_.last; ++v) {
            const auto i = static_cast<std::size_t>(v);
            Particle<Real>& p = state.particles[i];
            if (p.w == Real(0)) continue;
            const bool comes = !state.born.empty();
            const long birth = comes ? state.born[i] : 0;
            const Vec<double> x = state.position(v), was = as<double>(state.velocity[i].v);
            Point point{v, comes ? state.id[i] : 0,
                        static_cast<double>(state.substep + 1 - birth) * h, x, was};
            expression_(point, t);
            const Vec<Real> move = as<Real>(point.x - x), dv = as<Real>(point.v - was);
            p.d += move;
            state.velocity[i].v += dv;
            if (!state.last.empty()) state.last[i].v += move - static_cast<Real>(h) * dv;
            if (!state.lastVelocity.empty()) state.lastVelocity[i].v += dv;
        }
    }
    long size() const override { return 0; }

private:
    Range range_;
    Expression expression_;
};

}  // namespace

void express(World& world, Range range, Expression expression, const std::string& name) {
    if (range.first < 0 || range.first >= range.last ||
        range.last > static_cast<int>(world.start.size()))
        throw std::invalid_argument(name + ": its vertices are not in the world");
    const auto make = [range, expression]<class Real>(
                          const World&, KernelChoice) -> std::unique_ptr<Constraint<Real>> {
        return std::make_unique<ExpressionSet<Real>>(range, expression);
    };
    world.constrain(recipeOf<Constraint>(make), {.name = name});
}

}  // namespace plait
