// Where a slinky on stairs sets down its ends.
#pragma once

#include "slinky.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

struct Landing {
    bool upper;   // the end that began above
    int tread;    // from 0, where it began
    double time;  // s
};

// An end lands as its outermost turn first touches a tread below its last one, by 1.5 mm.
class Landings {
public:
    // `rise` and `tread` of the stairs, m.
    Landings(const Slinky& slinky, double rise, double tread);

    // To be shown each frame of a world whose first vertices are the slinky's. True: an end has
    // landed.
    bool see(std::span<const Vec<double>> positions, double time);

    const std::vector<Landing>& all() const { return all_; }

private:
    Slinky slinky_;
    double rise_, tread_;
    std::array<int, 2> on_{0, 0};  // the tread of the lower end, and of the upper one
    std::vector<Landing> all_;
};

}  // namespace plait
