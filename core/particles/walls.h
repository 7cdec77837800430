// What of a particle's kernel lies in the shadow of walls: there a wall stands for the liquid that
// would be there, so that none is missing beside it, and its gradient is how the wall pushes.
#pragma once

#include "../constraint.h"
#include "../contacts/solids/collider.h"
#include "turned_shade.h"

#include <memory>
#include <string>
#include <vector>

namespace plait {

struct Shade {
    double part = 0;                // of the kernel, 0 to 1
    Vec<double> gradient{0, 0, 0};  // 1/m, of the part
};

using Shades = std::vector<std::shared_ptr<const TurnedShade>>;

// Parts of several walls are taken together as if each cut the kernel by itself, 1 - prod(1 - f):
// exact for planes at right angles to 1.7 % of the whole; their sum would be 3 % too much at an
// edge and 10 % in a corner.
class Walls {
public:
    // `radius` (m) is that of the kernel; `shades` are those of turned walls, by collider, and made
    // where there are none. Throws std::invalid_argument, naming `who`, for what is no frame.
    Walls(const std::vector<Collider>& colliders, double radius, const std::string& who,
          const Shades& shades = {});
    static Shades shadesOf(const std::vector<Collider>& colliders, double radius);

    // As those of a Constraint: walls move with their colliders.
    void beginFrame(double t0, double t1);
    void begin(const Substep& substep);

    // At a point of the world (m), which may be inside of a wall.
    Shade at(const Vec<double>& point) const;
    // False: within `reach` (m) of the point no kernel meets a wall.
    bool near(const Vec<double>& point, double reach) const;
    // visit(side, way) for each wall within the kernel's radius of a point (m): where it is
    // nearest, in the world's axes, and the way (m) that it goes there in the base step.
    template <class Visit>
    void eachNear(const Vec<double>& point, const Visit& visit) const {
        for (const Body& body : bodies_) {
            const Vec<double> own = body.now.own(point);
            const Side side = sideOf(body.collider.solid, own);
            if (side.distance >= radius_) continue;
            const Vec<double> at = own - side.distance * side.normal;
            visit(Side{side.distance, body.now.worldWay(side.normal)},
                  body.collider.motion ? body.to.world(at) - body.from.world(at) : Vec<double>{});
        }
    }
    bool empty() const { return bodies_.empty(); }

private:
    struct Body {
        Collider collider;
        Placement from, to;  // at the ends of the base step
        Vec<double> turn;    // rad, in it
        Placement now;       // at the end of the substep
        std::shared_ptr<const TurnedShade> shade;
    };
    Shade of(const Body& body, const Vec<double>& p) const;
    Shade ofBox(const Vec<double>& half, const Vec<double>& p) const;

    double radius_;
    std::string who_;
    std::vector<Body> bodies_;
};

}  // namespace plait
