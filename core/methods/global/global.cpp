#include "global.h"

#include "../../sets/link_sweeps.h"
#include "../block/vertex_block.h"
#include "../sweeps/nucleus.h"
#include "../sweeps/xpbd.h"
#include "free_islands.h"
#include "set_roles.h"
#include "spring_net.h"

#include <memory>

namespace plait {
namespace {

template <class Real>
class Global : public WholeStep<Real> {
public:
    Global(const SolverOptions& options, const std::vector<NamedSet<Real>>& sets,
           const State<Real>& state)
        : free_(state) {
        const int padding = state.count();
        std::vector<int> ids;
        for (int k = 0; k < static_cast<int>(sets.size()); ++k) {
            sets[k].set->terms(state, false, terms_);
            free_.join(terms_);
            const bool links = areLinks(terms_, state);
            if (links) ids.insert(ids.end(), terms_.ids.begin(), terms_.ids.end());
            const bool holds = areHolds(terms_);
            const bool contacts = sets[k].contact && terms_.arity == 1;
            (links ? links_ : holds ? holds_ : contacts ? contacts_ : swept_).push_back(k);
            if (contacts) touching_.insert(touching_.end(), terms_.ids.begin(), terms_.ids.end());
            if (holds && areRigid(terms_)) hard_.push_back(k);
        }
        free_.find(state);
        sweeps_ = std::make_unique<LinkSweeps<Real>>(ids, padding, options.kernels);
        net_ = std::make_unique<SpringNet<Real>>(sweeps_->links(), state, options.kernels);
        pulls_.resize(net_->edgeBlocks.size() + touching_.size());
        bore_.resize(touching_.size());
        goal_.resize(state.particles.size());
    }

    // Tensions in N, by link, then contact.
    void furnish(Drawer<Real>& kept) const override { kept.numbers.assign(pulls_.size(), Real(0)); }

    void begin(const State<Real>& state) override { free_.noteVelocities(state); }

    long take(WholeSubstep<Real>& s) override {
        work_ = 0;
        free_.noteMeans(s.state);
        readLinks(s);
        for (std::size_t i = 0; i < touching_.size(); ++i)
            bore_[i] = s.kept.numbers[net_->edgeBlocks.size() + i] < 0;
        for (std::size_t v = 0; v < goal_.size(); ++v) goal_[v] = s.state.particles[v].d;
        sweep(s, {.tolerance = 2e-2, .rings = 5, .sweeps = 30, .rounds = 8});
        for (int column = 0; column < s.columns; ++column) {
            double ratio = stiffest;
            while (!solve(s, ratio) && ratio > 1) ratio /= 4;
            move(s);
            sweep(s, {.tolerance = 2e-3, .rings = 5, .sweeps = 30, .rounds = 2});
        }
        free_.keepMomentum(s);
        return work_;
    }

    // All of an island, since links pass an impact on at once: where only the vertices that touch
    // fell back, their neighbours bounced, and a sheet gained 3 J on a sphere.
    void markStruck(const State<Real>&, const Drawer<Real>& kept,
                    std::vector<std::uint8_t>& struck) override {
        std::vector<bool> hit(struck.size(), false);
        for (std::size_t i = 0; i < touching_.size(); ++i)
            if (!bore_[i] && kept.numbers[net_->edgeBlocks.size() + i] < 0)
                hit[free_.islandOf(touching_[i])] = true;
        for (std::size_t v = 0; v < struck.size(); ++v)
            struck[v] |= hit[free_.islandOf(static_cast<int>(v))];
    }

private:
    // k h^2 over the lighter mass of a link, to begin with.
    static constexpr double stiffest = 5e5;
    // A link as the matrix has it.
    struct Pull {
        Vec<double> direction;
        double stiffness, tension;  // k', N/m; T', N
    };

    void readLinks(WholeSubstep<Real>& s) {
        int link = 0;
        for (const int k : links_) {
            s.sets[k]->terms(s.state, false, terms_);
            work_ += terms_.size();
            for (int n = 0; n < terms_.size(); ++n) {
                const double l = length(between(s.state, terms_.ids[2 * n], terms_.ids[2 * n + 1]));
                const Real rest = static_cast<Real>(l - double(terms_.value[n]));
                sweeps_->setRow(sweeps_->slot(link++), {rest, terms_.above[n], terms_.below[n]});
            }
        }
    }

    static Sweep<Real> linkSweep(WholeSubstep<Real>& s) {
        Sweep<Real> sweep = xpbdSweep<Real>(s.implied);
        sweep.particles = &s.state.particles[0].x.x;
        return sweep;
    }

    void sweep(WholeSubstep<Real>& s, const Mending& mending) {
        sweeps_->aim(s.kept.numbers);
        for (const Direction direction :
             {Direction::forward, Direction::backward, Direction::forward}) {
            work_ += sweeps_->sweep(linkSweep(s), direction, s.workers);
            push(s, swept_, direction);
        }
        work_ += sweeps_->mend(linkSweep(s), mending, s.workers);
        for (const int k : hard_) project(s, k, nucleusSweep<Real>(1), Direction::forward);
        touch(s);
    }
    // A contact takes the force that would move a lone vertex as far.
    void touch(WholeSubstep<Real>& s) {
        Real* pressure = s.kept.numbers.data() + net_->edgeBlocks.size();
        for (const int k : contacts_) {
            s.sets[k]->terms(s.state, false, terms_);
            for (int n = 0; n < terms_.size(); ++n, ++pressure)
                *pressure += std::min(terms_.value[n], Real(0)) *
                             divide(static_cast<Real>(1 / (s.implied * s.implied)),
                                    s.state.particles[terms_.ids[n]].w);
            project(s, k, nucleusSweep<Real>(1), Direction::forward);
        }
    }
    // What these sets do to vertices they do to y as well.
    void push(WholeSubstep<Real>& s, const std::vector<int>& sets, Direction direction) {
        if (sets.empty()) return;
        const std::vector<Particle<Real>>& particles = s.state.particles;
        for (std::size_t v = 0; v < goal_.size(); ++v) goal_[v] -= particles[v].d;
        const std::size_t last = sets.size() - 1;
        for (std::size_t i = 0; i <= last; ++i)
            project(s, sets[direction == Direction::backward ? last - i : i],
                    xpbdSweep<Real>(s.implied), direction);
        for (std::size_t v = 0; v < goal_.size(); ++v) goal_[v] += particles[v].d;
    }
    void project(WholeSubstep<Real>& s, int set, Sweep<Real> sweep, Direction direction) {
        sweep.particles = &s.state.particles[0].x.x;
        s.sets[set]->project(sweep, direction, s.workers);
        work_ += s.sets[set]->size();
    }

    bool solve(WholeSubstep<Real>& s, double ratio) {
        linearise(s, ratio);
        work_ += net_->work();
        return net_->solve(s.state, s.workers);
    }

    void linearise(WholeSubstep<Real>& s, double ratio) {
        const double inverseH2 = 1 / (s.implied * s.implied);
        for (std::size_t v = 0; v < goal_.size(); ++v) {
            const Particle<Real>& p = s.state.particles[v];
            const double inertia = divide(inverseH2, double(p.w));
            net_->vertexBlocks[v] = Symmetric<float>::diagonal(static_cast<float>(inertia));
            net_->right[v] = inertia * as<double>(goal_[v] - p.d);
        }
        sweeps_->links().forColors(false, s.workers, [&](int begin, int end) {
            for (int n = begin; n < end; ++n) addLink(s, n, ratio * inverseH2);
        });
        for (const int k : holds_) addHolds(s, k, ratio * inverseH2);
        addContacts(s, ratio * inverseH2);
        work_ += sweeps_->links().count();
    }

    // `heaviest`: k times the inverse of the lighter mass, N/m/kg.
    void addLink(const WholeSubstep<Real>& s, int n, double heaviest) {
        const State<Real>& state = s.state;
        const LinkBlocks<Real>& all = sweeps_->links();
        const int a = all.vertex(n, 0), b = all.vertex(n, 1);
        const double w = std::max(state.particles[a].w, state.particles[b].w);
        net_->edgeBlocks[n] = {};
        pulls_[n] = {};
        if (w == 0) return;
        const auto& link = sweeps_->row(n);
        const Vec<double> d = between(state, a, b);
        // A link that is shrunk to a point has no direction, and is not stiff without bound.
        const double k = heaviest / w, l = std::max(length(d), 1e-3 * double(link.rest));
        const double c = l - double(link.rest), tension = s.kept.numbers[n];
        const double alpha = c + tension / k > 0 ? link.compliance : link.compression;
        if (!(alpha < slack) || !(l > 0)) return;
        const Vec<double> u = (1 / l) * d;
        const double part = 1 / (1 + k * alpha), turning = std::max(tension, 0.0) / l;
        const Pull& pull = pulls_[n] = {u, part * k, part * (tension + k * c)};
        const double across = std::min(turning, pull.stiffness);
        net_->edgeBlocks[n] = Symmetric<float>::diagonal(static_cast<float>(across));
        net_->edgeBlocks[n].addOuter(static_cast<float>(pull.stiffness - across), as<float>(u));
        net_->right[a] += pull.tension * u;
        net_->right[b] -= pull.tension * u;
    }

    // A distance of 0 has no gradient, and holds in every direction.
    void addHolds(WholeSubstep<Real>& s, int set, double heaviest) {
        s.sets[set]->terms(s.state, true, terms_);
        work_ += terms_.size();
        for (int n = 0; n < terms_.size(); ++n) {
            const int v = terms_.ids[n];
            const double w = s.state.particles[v].w, alpha = terms_.compliance(n);
            if (w == 0 || !(alpha < slack)) continue;
            const double stiffness = 1 / (w / heaviest + alpha);
            const double force = stiffness * double(terms_.value[n]);
            const Vec<Real>& u = terms_.gradient[n];
            if (dot(u, u) == Real(0))
                net_->vertexBlocks[v] += Symmetric<float>::diagonal(static_cast<float>(stiffness));
            net_->vertexBlocks[v].addOuter(static_cast<float>(stiffness), as<float>(u));
            if (force > 0)
                net_->vertexBlocks[v].add(static_cast<float>(force),
                                          as<float>(vertexBlock(terms_, n, 0)));
            net_->right[v] -= force * as<double>(u);
        }
    }

    // A contact that has pushed, or is passed, counts as two-sided; what pulled then is let go.
    void addContacts(WholeSubstep<Real>& s, double heaviest) {
        std::size_t i = net_->edgeBlocks.size();
        for (const int k : contacts_) {
            s.sets[k]->terms(s.state, false, terms_);
            work_ += terms_.size();
            for (int n = 0; n < terms_.size(); ++n, ++i) {
                pulls_[i] = {};
                const int v = terms_.ids[n];
                const double w = s.state.particles[v].w;
                if (w == 0) continue;
                const double stiffness = heaviest / w;
                const double force = s.kept.numbers[i] + stiffness * double(terms_.value[n]);
                if (!(force < 0)) continue;
                pulls_[i] = {as<double>(terms_.gradient[n]), stiffness, force};
                net_->vertexBlocks[v].addOuter(static_cast<float>(stiffness),
                                               as<float>(terms_.gradient[n]));
                net_->right[v] -= force * pulls_[i].direction;
            }
        }
    }

    void move(WholeSubstep<Real>& s) {
        const LinkBlocks<Real>& all = sweeps_->links();
        for (int n = 0; n < all.size(); ++n) {
            const Vec<float> d = net_->step[all.vertex(n, 1)] - net_->step[all.vertex(n, 0)];
            const Pull& pull = pulls_[n];
            s.kept.numbers[n] = static_cast<Real>(
                pull.tension + pull.stiffness * dot(pull.direction, as<double>(d)));
        }
        for (std::size_t i = 0; i < touching_.size(); ++i) {
            const Pull& pull = pulls_[net_->edgeBlocks.size() + i];
            const double moved = dot(pull.direction, as<double>(net_->step[touching_[i]]));
            s.kept.numbers[net_->edgeBlocks.size() + i] =
                static_cast<Real>(std::min(pull.tension + pull.stiffness * moved, 0.0));
        }
        for (std::size_t v = 0; v < net_->step.size(); ++v)
            s.state.particles[v].d += as<Real>(net_->step[v]);
    }

    std::vector<int> links_, holds_, contacts_, swept_;  // sets
    std::vector<int> hard_;                              // those of holds_ that are rigid
    FreeIslands<Real> free_;
    std::unique_ptr<LinkSweeps<Real>> sweeps_;
    std::unique_ptr<SpringNet<Real>> net_;
    std::vector<Vec<Real>> goal_;  // y, as d
    std::vector<int> touching_;    // vertices, by contact
    std::vector<bool> bore_;       // by contact: it pushed when the substep began
    std::vector<Pull> pulls_;      // by link, then by contact
    Terms<Real> terms_;
    long work_ = 0;
};

}  // namespace

template <class Real>
std::unique_ptr<WholeStep<Real>> makeGlobal(const SolverOptions& options,
                                            const std::vector<NamedSet<Real>>& sets,
                                            const State<Real>& state) {
    return std::make_unique<Global<Real>>(options, sets, state);
}
template std::unique_ptr<WholeStep<float>> makeGlobal(const SolverOptions&,
                                                      const std::vector<NamedSet<float>>&,
                                                      const State<float>&);
template std::unique_ptr<WholeStep<double>> makeGlobal(const SolverOptions&,
                                                       const std::vector<NamedSet<double>>&,
                                                       const State<double>&);

}  // namespace plait
