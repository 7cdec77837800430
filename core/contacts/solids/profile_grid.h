// Which edges of an outline may be nearest, by cell of a grid around it: an outline of fifty edges
// is asked for millions of times.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace plait {

class ProfileGrid {
public:
    ProfileGrid() = default;
    // Around these corners, as far beyond them as they are large. `squaredTo`: of an edge and a
    // point, the square of what is between them (m^2), infinite for what is no surface; `inside`:
    // whether a point is enclosed.
    ProfileGrid(const std::vector<std::array<double, 2>>& corners,
                const std::function<double(std::size_t, double, double)>& squaredTo,
                const std::function<bool(double, double)>& inside);

    enum class Within { no, yes, mixed };
    struct Cell {
        std::span<const int> nearest;   // edges, in order
        std::span<const int> crossing;  // edges at a height of the cell's row
        Within within;
    };
    // Nothing in `nearest` where the grid does not reach.
    Cell at(double radius, double height) const;

private:
    static constexpr int cells = 192;  // along each axis
    double low_ = 0, step_ = 1;
    int columns_ = 0, rows_ = 0;
    std::vector<int> nearestStart_, nearest_, crossingStart_, crossing_;
    std::vector<Within> within_;
};

}  // namespace plait
