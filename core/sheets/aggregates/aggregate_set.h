// The coarse levels of a sheet of stretch links, as a set of the schedule like any other: it says
// in one evaluation what the links would need a sweep for each vertex that lies between to say. Put
// it after the sets whose links it speeds up.
//
// Forward goes down the levels: each takes the means of the finer one, its links (upper bounds, so
// that cloth may fold) are swept forward, and what they change is handed back to all members alike.
// Backward goes up them and sweeps backward, the exact adjoint, so a palindrome stays one. What is
// handed down is the transpose of the mean in the metric of the masses: momentum is exact, and no
// sweep adds energy (variational aggregates; multigrid after Ruge and Stüben 1987, constraints
// after Müller, "Hierarchical position based dynamics", 2008, which injects instead and gains
// energy).
#pragma once

#include "../../complex/csr.h"
#include "../../sets/constraint_set.h"
#include "../../world.h"
#include "aggregates.h"

#include <memory>

namespace plait {

template <class Real>
class AggregateSet : public Constraint<Real> {
public:
    AggregateSet(const std::vector<AggregateLevel>& levels, KernelChoice choice) {
        for (const AggregateLevel& level : levels) levels_.emplace_back(level, choice);
    }

    void begin(const Substep& substep, Workers& workers) override {
        for (Level& level : levels_) level.set->begin(substep, workers);
        fresh_ = true;
    }

    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override {
        if (levels_.empty()) return;
        auto* const vertices = reinterpret_cast<Particle<Real>*>(sweep.particles);
        const auto finer = [&](std::size_t l) {
            return l ? levels_[l - 1].particles.data() : vertices;
        };
        for (std::size_t l = 0; l < levels_.size() && fresh_; ++l) levels_[l].place(finer(l));
        fresh_ = false;
        const bool back = direction == Direction::backward;
        for (std::size_t l = 0; l < levels_.size(); ++l) {
            levels_[l].average(finer(l), workers);
            if (!back) levels_[l].sweep(sweep, direction, workers);
        }
        for (std::size_t l = levels_.size(); l-- > 0;) {
            if (back) levels_[l].sweep(sweep, direction, workers);
            levels_[l].handDown(finer(l), workers);
        }
    }

    // Coarse levels speed up what other sets say.
    bool termsOf(std::span<const int>, const State<Real>&, bool, Terms<Real>& out) const override {
        out.resize(0, 2, false);
        return true;
    }

    long size() const override {
        long links = 0;
        for (const Level& level : levels_) links += level.set->size();
        return links;
    }

private:
    static constexpr int grain = 256;

    struct Level {
        Level(const AggregateLevel& level, KernelChoice choice)
            : particles(level.mass.size() + 1), before(level.mass.size() + 1) {
            members.start.assign(level.mass.size() + 1, 0);
            for (const int p : level.parent)
                if (p >= 0) ++members.start[p + 1];
            for (std::size_t a = 1; a < members.start.size(); ++a)
                members.start[a] += members.start[a - 1];
            members.item.resize(members.start.back());
            share.resize(members.item.size());
            std::vector<int> end(members.start.begin(), members.start.end() - 1);
            for (std::size_t n = 0; n < level.parent.size(); ++n) {
                if (level.parent[n] < 0) continue;
                const int at = end[level.parent[n]]++;
                members.item[at] = static_cast<int>(n);
                share[at] = static_cast<Real>(level.share[n]);
            }
            for (std::size_t a = 0; a < level.mass.size(); ++a)
                particles[a].w = static_cast<Real>(1 / level.mass[a]);
            Rows<Stretch> rows;
            for (const Link& link : level.links) {
                rows.ids.insert(rows.ids.end(), {link.a, link.b});
                rows.rows.push_back({link.length, 0, slack});
            }
            set = std::make_unique<ConstraintSet<Stretch, Real>>(
                std::move(rows), static_cast<int>(level.mass.size()), choice);
        }

        // x, once a substep: near where d will be measured from.
        void place(const Particle<Real>* finer) {
            for (int a = 0; a < members.size(); ++a) {
                Vec<Real> x{0, 0, 0};
                for (int m = members.start[a]; m < members.start[a + 1]; ++m)
                    x += share[m] * finer[members.item[m]].x;
                particles[a].x = x;
            }
        }

        void average(const Particle<Real>* finer, Workers& workers) {
            workers.forBlocks(members.size(), grain, [&](int begin, int end) {
                for (int a = begin; a < end; ++a) {
                    Particle<Real>& p = particles[a];
                    p.d = {0, 0, 0};
                    for (int m = members.start[a]; m < members.start[a + 1]; ++m) {
                        const Particle<Real>& q = finer[members.item[m]];
                        p.d += share[m] * ((q.x - p.x) + q.d);
                    }
                    before[a] = p.d;
                }
            });
        }

        void sweep(Sweep<Real> fine, Direction direction, Workers& workers) {
            fine.particles = &particles[0].x.x;
            fine.keep = 0;
            set->project(fine, direction, workers);
        }

        void handDown(Particle<Real>* finer, Workers& workers) {
            workers.forBlocks(members.size(), grain, [&](int begin, int end) {
                for (int a = begin; a < end; ++a) {
                    const Vec<Real> change = particles[a].d - before[a];
                    if (change == Vec<Real>{0, 0, 0}) continue;
                    for (int m = members.start[a]; m < members.start[a + 1]; ++m)
                        finer[members.item[m]].d += change;
                }
            });
        }

        Csr members;                            // by aggregate: nodes of the finer level
        std::vector<Real> share;                // by place in members.item
        std::vector<Particle<Real>> particles;  // the last one is for padding
        std::vector<Vec<Real>> before;          // d when the level was averaged
        std::unique_ptr<ConstraintSet<Stretch, Real>> set;
    };

    std::vector<Level> levels_;
    bool fresh_ = true;  // no evaluation yet in this substep
};

// Coarse levels of these links, down to `fewest` aggregates that move. Links count as rigid,
// whatever their compliance.
void aggregate(World& world, const Rows<Stretch>& set, SetOptions options, int fewest = 16);
void aggregate(World& world, std::vector<AggregateLevel> levels, SetOptions options);

}  // namespace plait
