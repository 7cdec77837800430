#include "membrane_set.h"

#include "../numbers/convert.h"
#include "../numbers/symmetric.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace plait {
namespace {

Vec<double> between(std::span<const Four> x, int a, int b) { return three(x[b] - x[a]); }

}  // namespace

// Each gas that leaks, with what is kept of it.
template <class Real>
template <class Numbers, class Visit>
void MembraneSet<Real>::forLeaks(Numbers* kept, const Visit& visit) {
    for (Enclosed& gas : gases_)
        if (gas.leaves()) visit(gas, std::exchange(kept, kept + Leak::numbers));
}

template <class Real>
void MembraneSet<Real>::furnish(Drawer<Real>& kept) const {
    for (const Enclosed& gas : gases_) {
        if (!gas.leaves()) continue;
        kept.numbers.resize(kept.numbers.size() + Leak::numbers);
        Leak::keep(kept.numbers.data() + kept.numbers.size() - Leak::numbers, gas.gas.amount);
    }
    // Force, not known yet, and how far they have opened.
    for (const Range& spare : spare_)
        for (int v = spare.first; v < spare.last; ++v)
            kept.numbers.insert(kept.numbers.end(), {Real(-1), Real(0)});
}

template <class Real>
void MembraneSet<Real>::settle(State<Real>& state, Drawer<Real>& kept, double t, double h) {
    forLeaks(kept.numbers.data(), [&](Enclosed& gas, Real* numbers) {
        if (gas.leak) gas.leak->settle(state, numbers, gas.given, t, h);
        if (gas.burst) gas.burst->settle(state, numbers, gas.given, h);
    });
    for (std::size_t n = 0; n < lips_.size(); ++n) {
        kept.numbers[lipsAt_[n]] = static_cast<Real>(lips_[n].force);
        Real& opened = kept.numbers[lipsAt_[n] + 1];
        opened = std::max(opened, static_cast<Real>(openingOf(state, static_cast<int>(n))));
    }
}

template <class Real>
double MembraneSet<Real>::openingOf(const State<Real>& state, int lips) const {
    const auto& ends = ends_[springs_.size() + lips];
    return length(state.position(ids_[ends[1]]) - state.position(ids_[ends[0]]));
}

template <class Real>
double MembraneSet<Real>::taken(const State<Real>& state, const Drawer<Real>& kept) const {
    double sum = 0;
    for (int n = 0; n < std::ssize(lips_); ++n) {
        Lips lips = lips_[n];
        lips.force = double(kept.numbers[lipsAt_[n]]);
        lips.opened = double(kept.numbers[lipsAt_[n] + 1]);
        const double opening = openingOf(state, n);
        sum += lips.taken() + lips.energy({opening, 0, 0});
    }
    return sum;
}

// Those that have come apart just now begin with half of what pulls one of them against the other,
// or more where that would not do.
template <class Real>
void MembraneSet<Real>::readLips(const Sweep<Real>& sweep, Workers& workers) {
    bool fresh = false;
    for (std::size_t n = 0; n < lips_.size(); ++n) {
        const Real force = sweep.kept[lipsAt_[n]];
        if (force >= 0) lips_[n].force = double(force);
        lips_[n].opened = double(sweep.kept[lipsAt_[n] + 1]);
        fresh = fresh || lips_[n].force < 0;
    }
    if (fresh) evaluate(workers);
    for (std::size_t n = 0; fresh && n < lips_.size(); ++n) {
        if (lips_[n].force >= 0) continue;
        const auto& ends = ends_[springs_.size() + n];
        const Vec<double> apart = system_->forceOn(ends[1], springForces_, patchForces_) -
                                  system_->forceOn(ends[0], springForces_, patchForces_);
        const double force = std::max(0.5 * length(apart), lips_[n].forceFor(longest_[n]));
        lips_[n].force = double(static_cast<Real>(force));
    }
    const auto paid = std::ranges::count_if(lips_, [](const Lips& lips) { return lips.paid(); });
    if (std::exchange(paid_, paid) != paid) findIslands();
}

template <class Real>
void MembraneSet<Real>::beginFrame(double t0, double t1) {
    for (Enclosed& gas : gases_)
        if (gas.amount) {
            gas.from = gas.amount(t0);
            gas.to = gas.amount(t1);
        }
}

template <class Real>
void MembraneSet<Real>::begin(const Substep& substep, Workers&) {
    std::ranges::fill(kept_, Four{});
    for (Lips& lips : lips_) lips.force = -1;
    for (Enclosed& gas : gases_)
        gas.gas.amount = gas.given = gas.from + substep.frameFraction * (gas.to - gas.from);
}

template <class Real>
void MembraneSet<Real>::project(const Sweep<Real>& sweep, Direction, Workers& workers) {
    if (ids_.empty()) return;
    forLeaks(sweep.kept,
             [](Enclosed& gas, const Real* numbers) { gas.gas.amount = Leak::left(numbers); });
    gather(sweep, workers);
    readLips(sweep, workers);
    evaluate(workers);
    system_->assemble(inertia_, springBlocks_, patchBlocks_, workers);
    terms_.clear();
    for (const Enclosed& gas : gases_)
        if (!gas.open()) terms_.push_back({gas.gas.stiffness(gas.volume), gas.gradient});
    system_->solve(right_, terms_, iterations_, tolerance_, step_, workers);
    const double step = search(workers);
    conserve(step);
    scatter(sweep, workers);
}

// Where the vertices are, from the first of them, and what their inertia is.
template <class Real>
void MembraneSet<Real>::gather(const Sweep<Real>& sweep, Workers& workers) {
    const Real* const first = sweep.particles + 8L * ids_[0];
    workers.forBlocks(static_cast<int>(ids_.size()), blockSize, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            const Real* const p = sweep.particles + 8L * ids_[v];
            x_[v] = four((three(p) - three(first)) + (three(p + 4) - three(first + 4)));
            start_[v] = four((three(p) - three(first)) +
                             (three(sweep.before + 4L * ids_[v]) - three(first + 4)));
            mass_[v] = p[3] > 0 ? 1 / double(p[3]) : 0;
            inertia_[v] = mass_[v] * double(sweep.inverseH2);
        }
    });
}

// Forces and second derivatives where the vertices are, and what the step of Newton has to bring
// to zero.
template <class Real>
void MembraneSet<Real>::evaluate(Workers& workers) {
    const auto springs = static_cast<int>(springs_.size()), lines = static_cast<int>(ends_.size());
    workers.forBlocks(lines, blockSize, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) {
            const Vec<double> d = between(x_, ends_[n][0], ends_[n][1]);
            springForces_[n] = n < springs ? springs_[n].force(d, springBlocks_[n])
                                           : lips_[n - springs].pull(d, springBlocks_[n]);
        }
    });
    workers.forBlocks(static_cast<int>(patches_.size()), blockSize, [&](int begin, int end) {
        for (int n = begin; n < end; ++n) {
            const auto& c = corners_[n];
            const Law& law = laws_[patches_[n].law];
            patches_[n].patch.forces(law.ogden, law.relaxed, between(x_, c[0], c[1]),
                                     between(x_, c[0], c[2]), patchForces_[n], patchBlocks_[n]);
        }
    });
    for (Enclosed& gas : gases_) fill(gas, workers);
    workers.forBlocks(static_cast<int>(ids_.size()), blockSize, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            right_[v] = Four{};
            if (mass_[v] == 0) continue;
            Four f = four(system_->forceOn(v, springForces_, patchForces_));
            for (const Enclosed& gas : gases_) f += gas.pressure * gas.gradient[v];
            right_[v] = f - inertia_[v] * kept_[v];
        }
    });
}

// Volume and its gradient, of a closed surface the same from wherever it is measured.
template <class Real>
void MembraneSet<Real>::fill(Enclosed& gas, Workers& workers) {
    gas.volume = volumeOf(gas, x_);
    gas.pressure = gas.volume > 0 ? gas.gas.gauge(gas.volume) : 0;
    if (gas.open()) gas.pressure = std::max(0.0, gas.pressure);
    workers.forBlocks(static_cast<int>(ids_.size()), blockSize, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            Vec<double> sum{0, 0, 0};
            for (int i = gas.start[v]; i < gas.start[v + 1] && mass_[v] > 0; ++i) {
                const auto& t = gas.triangles[gas.corners[i] / 3];
                const int c = gas.corners[i] % 3;
                const int a = t[(c + 1) % 3], b = t[(c + 2) % 3];
                sum += cross(between(x_, v, a), between(x_, v, b));
            }
            gas.gradient[v] = four(1.0 / 6 * sum);
        }
    });
}

template <class Real>
double MembraneSet<Real>::volumeOf(const Enclosed& gas, std::span<const Four> x) const {
    double sum = 0;
    const int o = gas.triangles[0][0];
    for (const auto& t : gas.triangles)
        sum += dot(between(x, o, t[0]), cross(between(x, o, t[1]), between(x, o, t[2])));
    return sum / 6;
}

// What implicit Euler minimises, `step` of the way along (J).
template <class Real>
double MembraneSet<Real>::energyAt(double step, Workers& workers) {
    const auto n = static_cast<int>(ids_.size());
    workers.forBlocks(n, blockSize, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) trial_[v] = x_[v] + step * step_[v];
    });
    const auto springs = static_cast<int>(springs_.size()), lines = static_cast<int>(ends_.size());
    workers.forBlocks(lines, blockSize, [&](int begin, int end) {
        for (int e = begin; e < end; ++e) {
            const Vec<double> d = between(trial_, ends_[e][0], ends_[e][1]);
            energies_[e] = e < springs ? springs_[e].energy(d) : lips_[e - springs].energy(d);
        }
    });
    workers.forBlocks(static_cast<int>(patches_.size()), blockSize, [&](int begin, int end) {
        for (int e = begin; e < end; ++e) {
            const auto& c = corners_[e];
            const Law& law = laws_[patches_[e].law];
            energies_[lines + e] = patches_[e].patch.energy(
                law.ogden, law.relaxed, between(trial_, c[0], c[1]), between(trial_, c[0], c[2]));
        }
    });
    double energy = std::accumulate(energies_.begin(), energies_.end(), 0.0);
    for (const Enclosed& gas : gases_) {
        if (gas.open()) {
            // Of what has openings the pressure stays as it is in an evaluation.
            energy -= gas.pressure * step * system_->sum(workers, [&](int v) {
                return dot(three(gas.gradient[v]), three(step_[v]));
            });
            continue;
        }
        const double volume = volumeOf(gas, trial_);
        if (!(volume > 0)) return INFINITY;
        energy += gas.gas.energy(volume) - gas.gas.energy(gas.volume);
    }
    return energy + system_->sum(workers, [&](int v) {
        const Vec<double> moved = three(kept_[v] + step * step_[v]);
        return 0.5 * dot(moved, inertia_[v] * moved);
    });
}

// How much of the step lowers the energy enough (Armijo), halved until it does.
template <class Real>
double MembraneSet<Real>::search(Workers& workers) {
    const double slope =
        -system_->sum(workers, [&](int v) { return dot(three(right_[v]), three(step_[v])); });
    const double before = energyAt(0, workers);
    double step = 1;
    for (int halved = 0; halved < 30; ++halved, step *= 0.5)
        if (energyAt(step, workers) <= before + 1e-4 * step * slope + 1e-12 * std::abs(before))
            return step;
    return 0;
}

// The impulses of this set on what is free neither move it as a whole nor turn it: what early ends
// of iterations left of that is taken back, as a rigid motion. Torque counts about where vertices
// stood when the substep began: with x1 = x0 + h v1 and v1 = v0 + w p, the sum of m x1 x v1 less
// that of m x0 x v0 is the sum of x0 x p. Implicit Euler's own, about x1, would brake what spins.
template <class Real>
void MembraneSet<Real>::conserve(double step) {
    for (Four& moved : step_) moved = step * moved;
    for (const std::vector<int>& island : islands_) {
        if (std::ranges::any_of(island, [&](int v) { return mass_[v] == 0; })) continue;
        double mass = 0, about = 0;
        Vec<double> center{0, 0, 0}, momentum{0, 0, 0}, angular{0, 0, 0};
        for (const int v : island) {
            mass += mass_[v];
            center += mass_[v] * three(start_[v]);
            momentum += mass_[v] * three(kept_[v] + step_[v]);
        }
        center = (1 / mass) * center;
        Symmetric<double> spread{};
        for (const int v : island) {
            const Vec<double> r = three(start_[v]) - center;
            angular += mass_[v] * cross(r, three(kept_[v] + step_[v]));
            about += mass_[v] * dot(r, r);
            spread.addOuter(-mass_[v], r);
        }
        spread += Symmetric<double>::diagonal(about);
        const Vec<double> back = (1 / mass) * momentum, turn = spread.solve(angular);
        for (const int v : island) step_[v] -= four(back + cross(turn, three(start_[v]) - center));
    }
}

template <class Real>
void MembraneSet<Real>::scatter(const Sweep<Real>& sweep, Workers& workers) {
    workers.forBlocks(static_cast<int>(ids_.size()), blockSize, [&](int begin, int end) {
        for (int v = begin; v < end; ++v) {
            if (mass_[v] == 0) continue;
            Real* const d = sweep.particles + 8L * ids_[v] + 4;
            const Vec<double> was = three(d);
            put(d, was + three(step_[v]));
            kept_[v] += four(three(d) - was);
        }
    });
}

template class MembraneSet<float>;
template class MembraneSet<double>;

}  // namespace plait
