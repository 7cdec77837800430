// Gravity: v <- v + h g, whatever the mass (M 5.2) [AW9, AW10].
#pragma once

#include "../force.h"
#include "body.h"

namespace plait {

struct World;

struct GravityOptions {
    Vec<double> acceleration{0, -9.81, 0};  // m/s^2
    double spaceScale = 1;                  // metres a unit: 0.01 makes gravity 100 times as strong
                                            // (M 5.1), and scales nothing else [UN1]
    std::vector<Range> ignore = {};         // objects that gravity does not move

    double strength() const { return length(acceleration) / spaceScale; }  // m/s^2
};

template <class Real>
class Gravity : public Force<Real> {
public:
    // Throws std::invalid_argument for an acceleration that is not finite, a space scale that is
    // not positive and finite, and objects that the world has not.
    Gravity(const World& world, const GravityOptions& options);

    std::string name() const override { return "gravity"; }
    Vec<double> fall() const override { return acceleration_; }
    void apply(State<Real>& state, double t, double h, Workers& workers) override;

private:
    Vec<double> acceleration_;
    std::vector<std::uint8_t> ignored_;
};

}  // namespace plait
