#include "weld_set.h"

#include "../numbers/convert.h"
#include "../numbers/splitmix.h"
#include "../state.h"
#include "rigid_motion.h"

#include <algorithm>
#include <cmath>

namespace plait {
namespace {

constexpr int mostPasses = 16;

std::vector<double> strengthsOf(std::size_t count, const WeldMatter& matter) {
    Splitmix random(matter.seed);
    std::vector<double> strengths;
    for (std::size_t i = 0; i < count; ++i)
        strengths.push_back(matter.strength * (1 + matter.scatter * random.both()));
    return strengths;
}

std::vector<PieceMass> massesOf(const World& world) {
    std::vector<PieceMass> masses;
    for (const Range& piece : world.pieces) {
        PieceMass sum;
        for (int v = piece.first; v < piece.last; ++v) {
            sum.mass += world.mass[v];
            sum.centre += world.mass[v] * world.start[v];
        }
        sum.centre = (1 / sum.mass) * sum.centre;
        for (int v = piece.first; v < piece.last; ++v) {
            const Vec<double> arm = world.start[v] - sum.centre;
            sum.inertia += Symmetric<double>::diagonal(world.mass[v] * dot(arm, arm));
            sum.inertia.addOuter(-world.mass[v], arm);
        }
        masses.push_back(sum);
    }
    return masses;
}

double areaOf(const Weld& weld) { return weld.length * weld.height; }

}  // namespace

template <class Real>
WeldSet<Real>::WeldSet(const World& world, std::vector<Weld> welds, const WeldMatter& matter)
    : welds_(std::move(welds)),
      matter_(matter),
      strength_(strengthsOf(welds_.size(), matter)),
      clusters_(world),
      blows_(world, matter),
      forces_(welds_, matter.stiffness, massesOf(world)),
      joined_(welds_.size(), 1),
      place_(world.pieces.size()),
      predicted_(world.start.size()),
      struck_(world.pieces.size()) {
    clusters_.join(welds_, joined_);
}

template <class Real>
void WeldSet<Real>::furnish(Drawer<Real>& kept) const {
    Clusters clusters = clusters_;
    const std::vector<std::int32_t> all(welds_.size(), 1);
    clusters.join(welds_, all);
    kept.integers.assign(clusters.leaders().begin(), clusters.leaders().end());
    kept.integers.insert(kept.integers.end(), all.begin(), all.end());
}

template <class Real>
void WeldSet<Real>::strike(const Sweep<Real>& sweep, const State<Real>&, const Drawer<Real>& kept,
                           Workers&) {
    const std::span<const std::int32_t> now = holds(kept);
    if (!std::ranges::equal(now, joined_)) {
        joined_.assign(now.begin(), now.end());
        clusters_.join(welds_, joined_);
    }
    for (const Cluster& cluster : clusters_.all())
        for (std::size_t i = 0; i < cluster.pieces.size(); ++i)
            place_[cluster.pieces[i]] = static_cast<int>(i);
    for (std::size_t v = 0; v < predicted_.size(); ++v)
        std::copy_n(sweep.particles + 8 * v + 4, 3, &predicted_[v].x);
    if (passes_ == 0) {
        budget_ = spent_ = 0;
        std::ranges::fill(struck_, 0);
    }
}

template <class Real>
void WeldSet<Real>::project(const Sweep<Real>& sweep, Direction, Workers& workers) {
    projected_ = true;
    const std::span<const Cluster> all = clusters_.all();
    workers.forBlocks(static_cast<int>(all.size()), 4, [&](int begin, int end) {
        for (int i = begin; i < end; ++i)
            clusters_.put(sweep, all[i], clusters_.poseOf(sweep, all[i]));
    });
}

// Less mass times acceleration: of each vertex what moved it from where it would have gone, gravity
// and all, is a force that contacts and welds give it.
template <class Real>
std::vector<PieceForce> WeldSet<Real>::lasting(const Sweep<Real>& sweep,
                                               const Cluster& cluster) const {
    const ClusterPose pose = clusters_.poseOf(sweep, cluster);
    std::vector<PieceForce> forces;
    for (const int p : cluster.pieces) {
        const Vec<double>& centre = forces_.massOf(p).centre;
        PieceForce& force = forces.emplace_back();
        for (int v = clusters_.verticesOf(p).first; v < clusters_.verticesOf(p).last; ++v) {
            const Vec<double> moved = three(sweep.particles + 8 * v + 4) - three(&predicted_[v].x);
            const Vec<double> f = pose.turn.back((-clusters_.massOf(v) / (h_ * h_)) * moved);
            force.force += f;
            force.torque += cross(clusters_.startOf(v) - centre, f);
        }
    }
    return forces;
}

template <class Real>
auto WeldSet<Real>::pressesOf(const Sweep<Real>& sweep, const Cluster& cluster,
                              std::span<const Load> loads, std::span<const Blow> blows) const
    -> Presses {
    Presses presses;
    presses.lasting = lasting(sweep, cluster);
    presses.blown.resize(cluster.pieces.size());
    const auto hardest =
        std::ranges::max_element(blows, {}, [](const Blow& blow) { return length(blow.impulse); });
    if (hardest != blows.end()) presses.time = blows_.timeOf(*hardest);
    const ClusterPose pose = clusters_.poseOf(sweep, cluster);
    for (const Load& load : loads) {
        const bool blow = std::ranges::find(blows, load.other, &Blow::other) != blows.end();
        PieceForce& force = (blow ? presses.blown : presses.lasting)[place_[load.piece]];
        const Vec<double> f = pose.turn.back(blow ? (1 / (h_ * presses.time)) * load.whole
                                                  : (1 / (h_ * h_)) * load.impulse);
        const Vec<double> at = cluster.centre + pose.turn.back(load.at - pose.to);
        force.force += f;
        force.torque += cross(at - forces_.massOf(load.piece).centre, f);
    }
    for (const int p : cluster.pieces)
        presses.pinned.push_back(sweep.particles[8 * clusters_.verticesOf(p).first + 3] == Real(0));
    return presses;
}

// Over strength, by weld of the cluster. What a blow bends farther away, it bends later and with
// less: a step of implicit Euler as long as it presses, of twice that, and so on until the substep
// ends, each with the same impulse.
template <class Real>
std::vector<double> WeldSet<Real>::stressesOf(const Cluster& cluster, Presses presses) {
    std::vector<WeldForce> last(cluster.welds.size());
    forces_.add(cluster, presses.pinned, std::move(presses.lasting), 0, last);
    std::vector<double> stresses(cluster.welds.size());
    const auto bear = [&](const std::vector<WeldForce>& forces) {
        for (std::size_t i = 0; i < forces.size(); ++i) {
            const int w = cluster.welds[i];
            stresses[i] = std::max(stresses[i], stressOf(welds_[w], forces[i]) / strength_[w]);
        }
    };
    bear(last);
    for (double time = presses.time; time > 0; time *= 2) {
        std::vector<WeldForce> forces = last;
        forces_.add(cluster, presses.pinned, presses.blown, time, forces);
        bear(forces);
        if (2 * time > h_) break;
        for (PieceForce& force : presses.blown) {
            force.force = 0.5 * force.force;
            force.torque = 0.5 * force.torque;
        }
    }
    return stresses;
}

template <class Real>
void WeldSet<Real>::look(const Sweep<Real>& sweep, const Cluster& cluster,
                         std::span<const Load> loads, std::vector<Overload>& overloads) {
    const std::vector<Blow> blows = blows_.among(loads, h_);
    const std::vector<double> stresses =
        stressesOf(cluster, pressesOf(sweep, cluster, loads, blows));
    const auto before = overloads.size();
    for (std::size_t i = 0; i < stresses.size(); ++i)
        if (stresses[i] > 1) overloads.push_back({stresses[i], cluster.welds[i], !blows.empty()});
    if (overloads.size() == before || blows.empty()) return;
    double energy = 0;
    for (const Blow& blow : blows) {
        energy += blow.energy();
        struck_[blow.other] = 1;
    }
    budget_ = std::max(budget_, energy);
    for (const int p : cluster.pieces) struck_[p] = 1;
}

// The most overloaded first, as long as blows can pay.
template <class Real>
bool WeldSet<Real>::breakAll(std::vector<Overload>& overloads, Drawer<Real>& kept) {
    std::ranges::sort(overloads, [](const Overload& a, const Overload& b) {
        return std::pair(-a.times, a.weld) < std::pair(-b.times, b.weld);
    });
    bool any = false;
    for (const Overload& o : overloads) {
        const double cost = matter_.toughness * areaOf(welds_[o.weld]);
        if (o.blown && spent_ + cost > budget_) {
            ++counts_.refused;
            continue;
        }
        (o.blown ? spent_ : counts_.elastic) += cost;
        kept.integers[kept.integers.size() - welds_.size() + o.weld] = 0;
        ++counts_.broken;
        any = true;
    }
    return any;
}

template <class Real>
bool WeldSet<Real>::giveWay(const Sweep<Real>& sweep, std::span<const Load> loads,
                            Drawer<Real>& kept, Workers&) {
    std::vector<Overload> overloads;
    for (const Cluster& cluster : clusters_.all()) {
        if (cluster.welds.empty()) continue;
        ofCluster_.clear();
        for (const Load& load : loads)
            if (clusters_.leaders()[load.piece] == cluster.pieces[0]) ofCluster_.push_back(load);
        look(sweep, cluster, ofCluster_, overloads);
    }
    counts_.factors = forces_.factors();
    counts_.solves = forces_.solves();
    if (passes_ == mostPasses) {
        counts_.cut += !overloads.empty();
        return false;
    }
    if (!breakAll(overloads, kept)) return false;
    counts_.passes = std::max(counts_.passes, static_cast<long>(++passes_));
    Clusters broken = clusters_;
    broken.join(welds_, holds(kept));
    std::ranges::copy(broken.leaders(), kept.integers.begin());
    return true;
}

// What new faces took out of blows is missing in how those that were struck move among each other:
// by what they move as one, rigidly, they keep both momenta.
template <class Real>
void WeldSet<Real>::rebound(State<Real>& state, Drawer<Real>&) const {
    passes_ = 0;
    if (spent_ <= 0) return;
    std::vector<int> vertices;
    for (const Cluster& cluster : clusters_.all())
        for (const int p : cluster.pieces) {
            const Range& own = clusters_.verticesOf(p);
            for (int v = own.first; v < own.last && struck_[p] && !cluster.pinned; ++v)
                vertices.push_back(v);
        }
    RigidMotion motion;
    for (const int v : vertices)
        motion.add(clusters_.massOf(v), state.position(v), as<double>(state.velocity[v].v));
    motion.solve();
    double energy = 0;
    const auto among = [&](int v) {
        return as<double>(state.velocity[v].v) - motion.at(state.position(v));
    };
    for (const int v : vertices) energy += clusters_.massOf(v) / 2 * dot(among(v), among(v));
    counts_.faces += spent_;
    counts_.unpaid += std::max(0.0, spent_ - energy);
    const double left = energy > spent_ ? std::sqrt(1 - spent_ / energy) : 0;
    for (const int v : vertices) {
        const Vec<double> to = motion.at(state.position(v)) + left * among(v);
        state.velocity[v].v = as<Real>(to);
        if (state.lastVelocity.empty()) continue;
        state.lastVelocity[v].v = state.velocity[v].v;
        state.last[v].v = state.particles[v].d - static_cast<Real>(h_) * state.velocity[v].v;
    }
}

template class WeldSet<float>;
template class WeldSet<double>;

}  // namespace plait
