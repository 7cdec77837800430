// Islands of matter that nothing outside holds or touches: their mean and their spin, the angular
// momentum about it.
//
// Inner forces have no torque, but velocity rules lose spin all the same: steps of 1/60 s 3 % of a
// crumpling sheet's angular momentum in 2 s at first order, 3e-4 under BDF2, most of it at once
// where the sheet snaps. What is missing turns the island as a whole, which changes no length (Dahl
// and Bargteil, "Global momentum preservation for position-based dynamics", 2019), and what
// rounding moved its mean by is taken back. Forces keep the torque they had.
#pragma once

#include "../../whole_step.h"
#include "set_roles.h"

#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace plait {

template <class Real>
class FreeIslands {
public:
    explicit FreeIslands(const State<Real>& state)
        : root_(state.particles.size()), held_(root_.size(), false) {
        std::iota(root_.begin(), root_.end(), 0);
    }
    // What a set joins; a set of single vertices holds them.
    void join(const Terms<Real>& terms) {
        const auto arity = static_cast<std::size_t>(terms.arity);
        for (std::size_t i = 0; i < terms.ids.size(); ++i) {
            root_[islandOf(terms.ids[i])] = islandOf(terms.ids[i - i % arity]);
            if (arity == 1) held_[terms.ids[i]] = true;
        }
    }
    // After the last set.
    void find(const State<Real>& state) {
        std::map<int, std::vector<int>> all;
        for (int v = 0; v < static_cast<int>(root_.size()); ++v) {
            all[islandOf(v)].push_back(v);
            if (held_[v] || state.particles[v].w == Real(0)) held_[islandOf(v)] = true;
        }
        for (auto& [root, vertices] : all)
            if (!held_[root] && vertices.size() > 1)
                islands_.push_back({std::move(vertices), {}, {}});
    }

    // Before forces change velocities.
    void noteVelocities(const State<Real>& state) {
        for (Island& island : islands_)
            island.unpushed = spinOf(island, state, [&](int v) {
                return std::pair(state.particles[v].d, as<double>(state.velocity[v].v));
            });
    }

    // Where constraints have not moved anything.
    void noteMeans(const State<Real>& state) {
        for (Island& island : islands_)
            island.mean = meanOf(island, state, [&](int v) { return state.position(v); });
    }

    // Where the step is all done.
    void keepMomentum(WholeSubstep<Real>& s) {
        State<Real>& state = s.state;
        const bool second = s.implied != s.h;
        for (const Island& island : islands_) {
            const auto before = [&](const std::vector<Padded<Real>>& velocity) {
                return spinOf(island, state, [&](int v) {
                    return std::pair(state.before[v].v, as<double>(velocity[v].v));
                });
            };
            const Vec<double> kept = before(state.lastVelocity);
            const Vec<double> torque = (1 / s.implied) * (before(state.velocity) - island.unpushed);
            const auto after = [&](int v) {
                const Vec<double> d1 = as<double>(state.before[v].v);
                const Vec<double> step = as<double>(state.particles[v].d) - d1;
                const Vec<double> earlier = second ? d1 - as<double>(state.last[v].v) : step;
                return std::pair(state.particles[v].d, (1 / s.h) * (step + 0.5 * (step - earlier)));
            };
            // Twice, since arms turn as well.
            for (int pass = 0; pass < 2; ++pass)
                turn(island, state, s.implied, kept + s.h * torque - spinOf(island, state, after));
        }
    }

    // A vertex that stands for all that sets join with this one.
    int islandOf(int v) {
        while (root_[v] != v) v = root_[v] = root_[root_[v]];
        return v;
    }

private:
    struct Island {
        std::vector<int> vertices;
        Vec<double> unpushed;  // spin, kg m^2/s
        Vec<double> mean;      // m
    };

    static double massOf(const State<Real>& state, int v) {
        return 1 / double(state.particles[v].w);
    }
    static Vec<double> meanOf(const Island& island, const State<Real>& state, const auto& placeOf) {
        Vec<double> sum{};
        double mass = 0;
        for (const int v : island.vertices) {
            sum += massOf(state, v) * placeOf(v);
            mass += massOf(state, v);
        }
        return (1 / mass) * sum;
    }
    // `dOf`: d and velocity of a vertex.
    static Vec<double> spinOf(const Island& island, const State<Real>& state, const auto& dOf) {
        const auto placeOf = [&](int v) {
            return as<double>(state.particles[v].x) + as<double>(dOf(v).first);
        };
        const Vec<double> mean = meanOf(island, state, placeOf);
        Vec<double> sum{};
        for (const int v : island.vertices)
            sum += massOf(state, v) * cross(placeOf(v) - mean, dOf(v).second);
        return sum;
    }
    // By an angle that changes the velocities of the step, (x - ...) / implied, by so much spin.
    static void turn(const Island& island, State<Real>& state, double implied,
                     const Vec<double>& missing) {
        const auto placeOf = [&](int v) { return state.position(v); };
        const Vec<double> mean = meanOf(island, state, placeOf);
        Symmetric<double> inertia{};
        for (const int v : island.vertices) {
            const Vec<double> arm = placeOf(v) - mean;
            inertia += Symmetric<double>::diagonal(massOf(state, v) * dot(arm, arm));
            inertia.addOuter(-massOf(state, v), arm);
        }
        // A straight island has no inertia about itself.
        const double some = 1e-9 * (inertia.xx + inertia.yy + inertia.zz);
        inertia += Symmetric<double>::diagonal(some);
        const Vec<double> angle = implied * inertia.solve(missing);
        for (const int v : island.vertices)
            state.particles[v].d += as<Real>(cross(angle, placeOf(v) - mean) + island.mean - mean);
    }

    std::vector<int> root_;
    std::vector<bool> held_;
    std::vector<Island> islands_;
};

}  // namespace plait
