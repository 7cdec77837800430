// A function of a program's own, evaluated after the solve (M 12.1.2) [PA3].
#pragma once

#include "../world.h"

#include <functional>

namespace plait {

// A vertex as an expression sees it, in double whatever the run's precision.
struct Point {
    int vertex;
    std::int32_t id;   // of its source; 0 where nothing comes or goes
    double age;        // s
    Vec<double> x, v;  // m, m/s: may be changed
};

// Called at the end of every substep, at time t (s), for all vertices of the range that are there
// and not pinned, by vertex, when sets, contacts and velocities have had their say. It must be a
// function of its arguments alone, or a run cannot be resumed. A place that it changes is not
// looked at by contacts on the way.
using Expression = std::function<void(Point& point, double t)>;

// Throws std::invalid_argument, naming it, for vertices that are not in the world.
void express(World& world, Range range, Expression expression,
             const std::string& name = "expression");

}  // namespace plait
