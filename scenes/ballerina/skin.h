// How the ballerina's skin follows her skeleton. Each limb and the spine carry a row of stations
// from one joint to the next; where a joint bends, they lie on an arc (a parabola that the bones
// touch) and turn little by little, and so does a twist from one end of a bone to the other. So no
// section pinches, and inside a bend nothing folds while the arc is wider than the limb.
#pragma once

#include "skeleton.h"
#include "surface.h"

#include <array>
#include <vector>

namespace plait::dancer {

class Skin {
public:
    explicit Skin(const std::vector<Point>& rest);

    std::vector<Point> positions(const Posed& posed) const;

private:
    // Stations are rigid motions from rest.
    struct Influence {
        int station;
        double weight;
    };
    static constexpr std::size_t most = 8;

    std::vector<Point> rest_;
    std::vector<std::array<Influence, most>> influences_;  // weight 0 where unused
};

}  // namespace plait::dancer
