// A direction that keeps two simplices apart for a while.
#pragma once

#include "difference.h"

namespace plait {

// What march answers where there is no such time.
inline constexpr double beyond = 2;

// True if a direction of the axes parts them all the time.
template <int k>
bool apartAlongAxis(const Difference<k>& d);

// The first time in [from, to] from which the simplices cannot be shown to be more than the
// thickness apart, by directions held for ever shorter times, 1,024 roundoffs at least; `beyond` if
// they are apart throughout. Never after they touch. `budget` is how many directions are left to
// try: with none left the answer is where it has got to.
template <int k, class T>
T march(const Difference<k, T>& d, T from, T to, int& budget);

}  // namespace plait
