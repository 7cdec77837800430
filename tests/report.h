// Error figures, printed as they are measured: a test's verdict is one bit, its figure is the news.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace plait::test {

// Prints `what`, the error and its bound on one line; true if the error is a number within the
// bound.
inline bool report(const std::string& what, double error, double bound) {
    std::printf("    %-68s %11.3e  (<= %.1e)\n", what.c_str(), error, bound);
    return std::isfinite(error) && error <= bound;
}

// A figure worth knowing that no bound applies to.
inline void note(const std::string& what, double figure) {
    std::printf("    %-68s %11.5g\n", what.c_str(), figure);
}

}  // namespace plait::test
