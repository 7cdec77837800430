// The set of all pairs of grains that may meet in a substep.
#pragma once

#include "../constraint.h"
#include "../particles/cells.h"
#include "grains.h"
#include "pair_memory.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace plait {

template <class Real>
class GrainSet : public Constraint<Real> {
public:
    GrainSet(const World& world, const Grains& grains);

    void furnish(Drawer<Real>& kept) const override {
        PairMemories<Real>::furnish(kept, radii_.size());
    }
    void begin(const Substep& substep, Workers&) override {
        parts_ = static_cast<Real>(grains_.recovery * substep.h);
        perSquare_ = static_cast<Real>(1 / (substep.h * substep.h));
        looked_ = evaluated_ = false;
    }
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override;
    void settle(State<Real>& state, Drawer<Real>& kept, double t, double h) override;
    void markTouched(std::vector<std::uint8_t>& touched) const override;
    // Pairs, each counted once.
    long size() const override { return static_cast<long>(neighbors_.size()) / 2; }

private:
    // Where one is against another, m.
    struct Near {
        Vec<Real> normal;
        Real gap;     // between their skins
        Real wanted;  // gap: 0, or less where they began the substep nearer
    };

    // In a substep, of a pair as one of both sees it, m.
    struct Touch {
        Real pushed = 0;
        Vec<Real> rubbed{};
        Vec<Real> back{};  // what it slipped in former substeps and should slip back in this one
    };

    static constexpr int mostColors = 64;  // the last takes what is left over, and runs singly

    // m, from where the first one began.
    Vec<Real> at(const Sweep<Real>& sweep, int i) const {
        const Real* const p = sweep.particles + 8L * (grains_.vertices.first + i);
        return {(p[0] - origin_.x) + p[4], (p[1] - origin_.y) + p[5], (p[2] - origin_.z) + p[6]};
    }
    void look(const Sweep<Real>& sweep, Workers& workers);
    void recall(const Sweep<Real>& sweep, Workers& workers);
    void color();
    void moveAtOnce(const Sweep<Real>& sweep, Workers& workers);
    void sweepPairs(const Sweep<Real>& sweep, Direction direction, Workers& workers);
    void pushPair(const Sweep<Real>& sweep, int i, int k);
    void move(const Sweep<Real>& sweep, Workers& workers);
    PairMemory<Real> memoryOf(const Sweep<Real>& sweep, int i, int k,
                              const std::optional<PairMemory<Real>>& old) const;
    Real partOf(const Sweep<Real>& sweep, int i, int j, const Vec<Real>& normal) const;
    void keepNearest(int i, std::vector<int>& found, const Sweep<Real>& sweep) const;
    bool mayMeet(int i, int j) const;
    Near near(const Sweep<Real>& sweep, int i, int j) const;
    bool acts(const Near& near, int k) const;
    Real share(int i, int j) const;
    Vec<Real> exchange(const Sweep<Real>& sweep, int i, int k, const Near& near, Real share);

    Grains grains_;
    std::vector<Real> radii_;
    std::vector<std::uint8_t> spare_;
    Real largest_ = 0;  // m
    Vec<Real> origin_;
    Cells<Real> cells_;
    std::vector<int> present_;             // grains that are there; cells_ counts these
    std::vector<int> start_, neighbors_;   // by grain, of the substep
    std::vector<std::vector<int>> found_;  // by grain, before they stand in one row
    std::vector<Touch> touch_;             // by neighbour
    // Of pairs, by colour: neighbours of grains that come first, and these; where each colour ends.
    std::vector<std::array<int, 2>> pairs_;
    std::vector<int> colors_, colorOf_;
    std::vector<std::uint64_t> taken_;  // by grain, a bit a colour
    std::vector<int> touching_;         // by grain, of the evaluation
    std::vector<Vec<Real>> moves_;      // m, by grain
    Real parts_ = 0;          // m, by which pairs may part in a substep that begin it too near
    Real perSquare_ = 0;      // 1/s^2
    bool looked_ = false;     // in this substep
    bool evaluated_ = false;  // forward, and not yet backward
};

extern template class GrainSet<float>;
extern template class GrainSet<double>;

}  // namespace plait
