#include "sink.h"

#include "../world.h"
#include "population.h"

#include <stdexcept>

namespace plait {

template <class Real>
Sink<Real>::Sink(const World& world, const SinkOptions& options) : options_(options) {
    const Range spare = options.spare;
    const auto refuse = [&](bool bad, const char* what) {
        if (bad) throw std::invalid_argument(options.name + ": " + what);
    };
    refuse(spare.first < 0 || spare.first >= spare.last ||
               spare.last > static_cast<int>(world.start.size()),
           "its vertices are not in the world");
    for (int v = spare.first; v < spare.last; ++v)
        refuse(!world.isSpare(v), "it takes spare vertices only");
    refuse(!(length(options.normal) > 0), "its plane has no direction");
    waiting_.assign(world.start.begin() + spare.first, world.start.begin() + spare.last);
}

template <class Real>
void Sink<Real>::prepare(State<Real>& state, Drawer<Real>&, double, double h, Workers&) {
    Population<Real> population(state, h);
    const Range spare = options_.spare;
    for (int v = spare.first; v < spare.last; ++v)
        if (population.isHere(v) && dot(state.position(v) - options_.point, options_.normal) < 0)
            population.take(v, waiting_[v - spare.first]);
}

template class Sink<float>;
template class Sink<double>;

}  // namespace plait
