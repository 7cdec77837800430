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

template <class Real>
MembraneSet<Real>::MembraneSet(const World& world, const Membrane& membrane)
    : iterations_(membrane.iterations),
      tolerance_(membrane.tolerance),
      places_(world.start.size(), -1) {
    for (int n = 0; n < membrane.springs.size(); ++n) {
        const auto& row = membrane.springs.rows[n];
        std::array<int, 2> ends{membrane.springs.ids[2 * n], membrane.springs.ids[2 * n + 1]};
        if (world.torn && !world.torn->rename(ends)) continue;
        ends_.push_back({local(ends[0]), local(ends[1])});
        springs_.push_back({row.rest, 1 / row.compliance, 1 / row.compression});
    }
    for (const Membrane::Rubber& rubber : membrane.rubber) {
        const int law = static_cast<int>(laws_.size());
        laws_.push_back({rubber.law, rubber.relaxed});
        for (std::size_t n = 0; n < rubber.triangles.size() / 3; ++n) {
            std::array<int, 3> v{};
            std::copy_n(&rubber.triangles[3 * n], 3, v.begin());
            if (world.torn) world.torn->rename(v);
            corners_.push_back({local(v[0]), local(v[1]), local(v[2])});
            const double t = rubber.thickness[rubber.thickness.size() == 1 ? 0 : n];
            patches_.push_back(
                {Patch(world.rest[v[0]], world.rest[v[1]], world.rest[v[2]], t), law});
        }
    }
    for (const Membrane::Filling& filling : membrane.gases) {
        Enclosed gas{{}, {}, {}, filling.gas, filling.amount, 0, 0, 0, 0, {}, {}};
        gas.from = gas.to = gas.gas.amount;
        for (const auto& t : filling.enclosure.triangles)
            gas.triangles.push_back({local(t[0]), local(t[1]), local(t[2])});
        if (!filling.leak.hole.empty())
            gas.leak.emplace(filling.leak, filling.gas, filling.enclosure.triangles, filling.riding,
                             world.mass);
        gases_.push_back(std::move(gas));
    }
    const std::size_t n = ids_.size();
    for (Enclosed& gas : gases_) {
        gas.start.assign(n + 1, 0);
        for (const auto& t : gas.triangles)
            for (const int v : t) ++gas.start[v + 1];
        std::partial_sum(gas.start.begin(), gas.start.end(), gas.start.begin());
        gas.corners.resize(3 * gas.triangles.size());
        std::vector<int> next(gas.start.begin(), gas.start.end() - 1);
        for (int t = 0; t < std::ssize(gas.triangles); ++t)
            for (int c = 0; c < 3; ++c) gas.corners[next[gas.triangles[t][c]]++] = 3 * t + c;
        gas.gradient.resize(n);
    }
    for (std::vector<Four>* array : {&x_, &start_, &trial_, &kept_, &step_, &right_})
        array->resize(n);
    mass_.resize(n);
    inertia_.resize(n);
    springForces_.resize(springs_.size());
    springBlocks_.resize(springs_.size());
    patchForces_.resize(patches_.size());
    patchBlocks_.resize(patches_.size());
    energies_.resize(springs_.size() + patches_.size());
    system_ = std::make_unique<MembraneSystem>(static_cast<int>(n), ends_, corners_);
    findIslands();
}

// The place in the set of a vertex of the world.
template <class Real>
int MembraneSet<Real>::local(int vertex) {
    int& place = places_[vertex];
    if (place < 0) {
        place = static_cast<int>(ids_.size());
        ids_.push_back(vertex);
    }
    return place;
}

// What hangs together by elements or by a surface that encloses a gas.
template <class Real>
void MembraneSet<Real>::findIslands() {
    std::vector<int> leader(ids_.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](int v) {
        while (leader[v] != v) v = leader[v] = leader[leader[v]];
        return v;
    };
    const auto join = [&](int a, int b) {
        leader[std::max(find(a), find(b))] = std::min(find(a), find(b));
    };
    for (const auto& ends : ends_) join(ends[0], ends[1]);
    for (const auto& t : corners_) join(t[0], t[1]), join(t[1], t[2]);
    for (const Enclosed& gas : gases_)
        for (const auto& t : gas.triangles) join(t[0], t[1]), join(t[1], t[2]);
    std::vector<int> number(ids_.size(), -1);
    for (int v = 0; v < std::ssize(ids_); ++v) {
        int& island = number[find(v)];
        if (island < 0) {
            island = static_cast<int>(islands_.size());
            islands_.emplace_back();
        }
        islands_[island].push_back(v);
    }
}

// Each gas that leaks, with what is kept of it.
template <class Real>
template <class Numbers, class Visit>
void MembraneSet<Real>::forLeaks(Numbers* kept, const Visit& visit) {
    for (Enclosed& gas : gases_)
        if (gas.leak) visit(gas, std::exchange(kept, kept + Leak::numbers));
}

template <class Real>
void MembraneSet<Real>::furnish(Drawer<Real>& kept) const {
    for (const Enclosed& gas : gases_) {
        if (!gas.leak) continue;
        kept.numbers.resize(kept.numbers.size() + Leak::numbers);
        gas.leak->furnish(kept.numbers.data() + kept.numbers.size() - Leak::numbers);
    }
}

template <class Real>
void MembraneSet<Real>::settle(State<Real>& state, Drawer<Real>& kept, double t, double h) {
    forLeaks(kept.numbers.data(), [&](Enclosed& gas, Real* numbers) {
        gas.leak->settle(state, numbers, gas.given, t, h);
    });
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
    for (Enclosed& gas : gases_)
        gas.gas.amount = gas.given = gas.from + substep.frameFraction * (gas.to - gas.from);
}

template <class Real>
void MembraneSet<Real>::project(const Sweep<Real>& sweep, Direction, Workers& workers) {
    if (ids_.empty()) return;
    forLeaks(sweep.kept,
             [](Enclosed& gas, const Real* numbers) { gas.gas.amount = Leak::left(numbers); });
    gather(sweep, workers);
    evaluate(workers);
    system_->assemble(inertia_, springBlocks_, patchBlocks_, workers);
    terms_.clear();
    for (const Enclosed& gas : gases_)
        terms_.push_back({gas.gas.stiffness(gas.volume), gas.gradient});
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
    const auto springs = static_cast<int>(springs_.size());
    workers.forBlocks(springs, blockSize, [&](int begin, int end) {
        for (int n = begin; n < end; ++n)
            springForces_[n] =
                springs_[n].force(between(x_, ends_[n][0], ends_[n][1]), springBlocks_[n]);
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
            for (const Enclosed& gas : gases_) f += gas.gas.gauge(gas.volume) * gas.gradient[v];
            right_[v] = f - inertia_[v] * kept_[v];
        }
    });
}

// Volume and its gradient, of a closed surface the same from wherever it is measured.
template <class Real>
void MembraneSet<Real>::fill(Enclosed& gas, Workers& workers) {
    gas.volume = volumeOf(gas, x_);
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
    const auto springs = static_cast<int>(springs_.size());
    workers.forBlocks(springs, blockSize, [&](int begin, int end) {
        for (int e = begin; e < end; ++e)
            energies_[e] = springs_[e].energy(between(trial_, ends_[e][0], ends_[e][1]));
    });
    workers.forBlocks(static_cast<int>(patches_.size()), blockSize, [&](int begin, int end) {
        for (int e = begin; e < end; ++e) {
            const auto& c = corners_[e];
            const Law& law = laws_[patches_[e].law];
            energies_[springs + e] = patches_[e].patch.energy(
                law.ogden, law.relaxed, between(trial_, c[0], c[1]), between(trial_, c[0], c[2]));
        }
    });
    double energy = std::accumulate(energies_.begin(), energies_.end(), 0.0);
    for (const Enclosed& gas : gases_) {
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
