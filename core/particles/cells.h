// Particles in the order of space: sorted by counting into cells as wide as they see, so that what
// is near a particle lies in nine rows of three cells, each row in one piece. Sorted anew for each
// evaluation: neighbours listed and kept would cost as much memory as all else.
#pragma once

#include "../kernels/workers.h"
#include "../numbers/math.h"

#include <span>
#include <vector>

namespace plait {

// Numbers by slot, the place in the order of space, have this many more behind the last, so that
// whole packs can be read there.
inline constexpr int slotPadding = 16;

template <class Real>
class Cells {
public:
    // Sorts particles 0 .. count - 1 by where position(i) (m, a Vec<Real>) says that they are;
    // position is called from all threads. Slots go by cell, x first, then y, then z, and in a cell
    // by particle, whatever the threads. Two that are less than `reach` (m, above 0) apart are in
    // the same cell or in neighbours. Where particles are strewn over more than eight cells each,
    // the outlying ones share cells at the edge: slower, and as right. Nothing is allocated but
    // what it takes to hold more than ever before.
    template <class Position>
    void sort(int count, Real reach, const Position& position, Workers& workers) {
        points_.resize(count);
        workers.forBlocks(count, 1024, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) points_[i] = position(i);
        });
        choose(reach, workers);
        place(workers);
    }

    int count() const { return static_cast<int>(points_.size()); }

    // By slot: the particle; where it is (m), padded.
    std::span<const int> order() const { return order_; }
    const Real* x() const { return x_.data(); }
    const Real* y() const { return y_.data(); }
    const Real* z() const { return z_.data(); }
    Vec<Real> point(int slot) const { return {x_[slot], y_[slot], z_[slot]}; }

    // Cells that hold a particle, in the order of slots. A cell's slots are from start()[cell] to
    // start()[cell + 1]; next along x is cell + 1, along y cell + row(), along z cell + layer().
    // All around lie cells that hold none.
    std::span<const int> occupied() const { return occupied_; }
    const int* start() const { return start_.data(); }
    int row() const { return size_[0]; }
    int layer() const { return size_[0] * size_[1]; }

    Real width() const { return width_; }  // m
    Vec<Real> middle(int cell) const;      // m
    // True: it is outermost, so that what it holds may lie outside of it.
    bool isAtEdge(int cell) const;

    // visit(slot) for all that may be less than `reach` from a point (m), in order of rows.
    template <class Visit>
    void around(const Vec<Real>& point, const Visit& visit) const {
        const int cell = cellOf(point);
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y) {
                const int middle = cell + y * row() + z * layer();
                for (int s = start_[middle - 1]; s < start_[middle + 2]; ++s) visit(s);
            }
    }

private:
    struct Extent {
        Vec<Real> low, high;
        Vec<double> sum;
    };
    Extent extentOfAll(Workers& workers);
    void choose(Real reach, Workers& workers);
    void place(Workers& workers);
    // Rises with x, and by no more than one over a cell's width. What is no number is in the first.
    int coordinate(Real x, int axis) const {
        const Real c = (x - low_[axis]) * perWidth_, most = static_cast<Real>(size_[axis] - 3);
        return 1 + static_cast<int>(c > 0 ? (c < most ? c : most) : Real(0));
    }
    int cellOf(const Vec<Real>& p) const {
        return coordinate(p.x, 0) + row() * coordinate(p.y, 1) + layer() * coordinate(p.z, 2);
    }

    Real width_ = 1, perWidth_ = 1;  // m, 1/m
    Real low_[3]{};                  // m, where the first cell with particles begins
    int size_[3]{3, 3, 3};           // cells along each axis, with an empty one at either end
    std::vector<Vec<Real>> points_;  // by particle
    std::vector<int> keys_;          // cell, by particle
    std::vector<int> order_, start_, occupied_;
    std::vector<Real> x_, y_, z_;
    std::vector<Extent> extents_;  // by block of particles
};

extern template class Cells<float>;
extern template class Cells<double>;

}  // namespace plait
