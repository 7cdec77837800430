// What takes matter: all that goes beyond a plane (a kill plane).
#pragma once

#include "../complex/complex.h"
#include "../force.h"

#include <vector>

namespace plait {

struct World;

struct SinkOptions {
    std::string name = "sink";
    Range spare{};                                // vertices that it takes, all of them spare
    Vec<double> point{0, 0, 0}, normal{0, 1, 0};  // m; what is behind goes
};

template <class Real>
class Sink : public Force<Real> {
public:
    // Throws std::invalid_argument, naming the sink, for vertices that are not spare and for a
    // plane without a direction.
    Sink(const World& world, const SinkOptions& options);

    std::string name() const override { return options_.name; }
    void prepare(State<Real>& state, Drawer<Real>& kept, double t, double h,
                 Workers& workers) override;
    void apply(State<Real>&, double, double, Workers&) override {}

private:
    SinkOptions options_;
    std::vector<Vec<double>> waiting_;  // m
};

}  // namespace plait
