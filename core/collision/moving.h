// Where a vertex goes in a step.
#pragma once

#include "../numbers/math.h"

namespace plait {

// From start to end along a straight line, steadily, while time goes from 0 to 1 (m).
template <class T>
struct Moving {
    Vec<T> start, end;
};
using MovingVertex = Moving<double>;

template <class T>
Vec<T> at(const Moving<T>& path, const T& t) {
    return (1 - t) * path.start + t * path.end;
}

}  // namespace plait
