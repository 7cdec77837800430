#include "gravity.h"

#include "../world.h"

#include <cmath>

namespace plait {

template <class Real>
Gravity<Real>::Gravity(const World& world, const GravityOptions& options)
    : acceleration_((1 / options.spaceScale) * options.acceleration),
      ignored_(markObjects(static_cast<int>(world.start.size()), options.ignore, "gravity")) {
    if (!(options.spaceScale > 0) || !std::isfinite(options.spaceScale))
        throw std::invalid_argument("gravity: space scale must be positive");
    if (!std::isfinite(length(acceleration_)))
        throw std::invalid_argument("gravity: acceleration must be finite");
}

template <class Real>
void Gravity<Real>::apply(State<Real>& state, double /*t*/, double h, Workers& workers) {
    const Vec<double> g = h * acceleration_;
    const Vec<Real> dv{static_cast<Real>(g.x), static_cast<Real>(g.y), static_cast<Real>(g.z)};
    workers.forBlocks(state.count(), 1024, [&](int begin, int end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
            if (!ignored_[i]) accelerate(state, i, dv);
    });
}

template class Gravity<float>;
template class Gravity<double>;

}  // namespace plait
