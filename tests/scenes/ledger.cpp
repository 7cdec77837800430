#include "ledger.h"

#include <plait/contact_constraint.h>
#include <plait/measure/energy.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

namespace plait::test {

using Impulses = std::vector<Vec<double>>;

// A force, and what it does to velocities.
class MeteredForce : public Force<double> {
public:
    MeteredForce(std::unique_ptr<Force<double>> force, Ledger& ledger)
        : force_(std::move(force)), ledger_(ledger) {}

    std::string name() const override { return force_->name(); }
    void furnish(Drawer<double>& kept) const override { force_->furnish(kept); }
    void beginFrame(const State<double>& state, double t0, double t1, Workers& workers) override {
        force_->beginFrame(state, t0, t1, workers);
    }
    void prepare(State<double>& state, Drawer<double>& kept, double t, double h,
                 Workers& workers) override {
        meter(state, [&] { force_->prepare(state, kept, t, h, workers); });
    }
    void apply(State<double>& state, double t, double h, Workers& workers) override {
        meter(state, [&] { force_->apply(state, t, h, workers); });
    }

private:
    template <class Act>
    void meter(State<double>& state, const Act& act) {
        const auto before = state.velocity;
        act();
        if (name() == "gravity") return;
        for (std::size_t v = 0; v < ledger_.mass_.size(); ++v)
            ledger_.blown_[v] += ledger_.mass_[v] * (state.velocity[v].v - before[v].v);
    }

    std::unique_ptr<Force<double>> force_;
    Ledger& ledger_;
};

// A set, and what it does to positions.
class MeteredSet : public ContactConstraint<double> {
public:
    MeteredSet(std::unique_ptr<Constraint<double>> set, Ledger& ledger, std::size_t line)
        : set_(std::move(set)),
          contact_(dynamic_cast<ContactConstraint<double>*>(set_.get())),
          ledger_(ledger),
          impulses_(ledger.impulses_[line]) {}

    void beginFrame(double t0, double t1) override { set_->beginFrame(t0, t1); }
    void begin(const Substep& substep, Workers& workers) override {
        h_ = substep.h;
        set_->begin(substep, workers);
    }
    void furnish(Drawer<double>& kept) const override {
        if (contact_) contact_->furnish(kept);
    }
    bool needsPast() const override { return true; }  // close() asks what moved
    void strike(const Sweep<double>& sweep, const State<double>& state, const Drawer<double>& kept,
                Workers& workers) override {
        if (contact_) contact_->strike(sweep, state, kept, workers);
    }
    void project(const Sweep<double>& sweep, Direction direction, Workers& workers) override {
        meter(sweep, [&] { set_->project(sweep, direction, workers); });
    }
    long finish(const Sweep<double>& sweep, Workers& workers) override {
        long work = 0;
        meter(sweep, [&] { work = set_->finish(sweep, workers); });
        return work;
    }
    // Of contacts alone, after velocities are known.
    void rebound(State<double>& state, Drawer<double>& kept) const override {
        if (contact_) contact_->rebound(state, kept);
        ledger_.close(state, h_);
    }
    long failures() const override { return contact_ ? contact_->failures() : 0; }
    long size() const override { return set_->size(); }

private:
    template <class Act>
    void meter(const Sweep<double>& sweep, const Act& act) {
        const std::size_t n = ledger_.mass_.size();
        const auto offset = [&](std::size_t v) {
            const double* const d = sweep.particles + 8 * v + 4;
            return Vec<double>{d[0], d[1], d[2]};
        };
        before_.resize(n);
        for (std::size_t v = 0; v < n; ++v) {
            before_[v] = offset(v);
            if (ledger_.mass_[v] == 0) sweep.particles[8 * v + 3] = ledger_.lent_;
        }
        act();
        for (std::size_t v = 0; v < n; ++v) {
            double* const p = sweep.particles + 8 * v;
            impulses_[v] += (1 / (p[3] * h_)) * (offset(v) - before_[v]);
            if (ledger_.mass_[v] > 0) continue;
            p[3] = 0;
            p[4] = before_[v].x, p[5] = before_[v].y, p[6] = before_[v].z;
        }
    }

    std::unique_ptr<Constraint<double>> set_;
    ContactConstraint<double>* contact_;  // the same; null: no contact
    Ledger& ledger_;
    Impulses& impulses_;
    Impulses before_;
    double h_ = 0;
};

Ledger::Ledger(World& world, const Vec<double>& g)
    : g_(g),
      mass_(world.mass),
      impulses_(world.sets.size(), Impulses(mass_.size())),
      blown_(mass_.size()),
      positions_(world.start),
      velocities_(world.velocity) {
    double heaviest = 0;
    for (std::size_t v = 0; v < mass_.size(); ++v) {
        if (world.pinned[v]) mass_[v] = 0;
        heaviest = std::max(heaviest, mass_[v]);
    }
    lent_ = 1e-7 / heaviest;
    start_ = energy();
    for (std::size_t s = 0; s < world.sets.size(); ++s) {
        lines_.push_back({.set = world.sets[s].options.name});
        auto& make = world.sets[s].recipe.full;
        make = [this, s, make](const World& of, KernelChoice kernels) {
            return std::make_unique<MeteredSet>(make(of, kernels), *this, s);
        };
    }
    for (Recipe<Force>& force : world.forces)
        force.full = [this, make = force.full](const World& of, KernelChoice kernels) {
            return std::make_unique<MeteredForce>(make(of, kernels), *this);
        };
}

void Ledger::clear() {
    for (Line& line : lines_) line = {.set = line.set};
    start_ = energy();
    air_ = damping_ = falling_ = 0;
}

double Ledger::given() const {
    return std::accumulate(lines_.begin(), lines_.end(), 0.0,
                           [](double sum, const Line& line) { return sum + line.given; });
}

double Ledger::lost() const {
    return std::accumulate(lines_.begin(), lines_.end(), 0.0,
                           [](double sum, const Line& line) { return sum + line.lost; });
}

double Ledger::energy() const {
    return kineticEnergy(mass_, velocities_) + gravitationalEnergy(mass_, positions_, g_);
}

// With the mean of a vertex's velocities at both ends, an impulse gives exactly the energy that is
// then there. What is pinned gives by the way it goes.
void Ledger::close(const State<double>& state, double h) {
    for (std::size_t v = 0; v < mass_.size(); ++v) {
        const Vec<double> u = (1 / h) * (state.particles[v].d - state.last[v].v);
        const Vec<double> mean = 0.5 * (velocities_[v] + u);
        for (std::size_t s = 0; s < lines_.size(); ++s) {
            const Vec<double>& p = impulses_[s][v];
            Line& line = lines_[s];
            line.excess += p;
            if (mass_[v] > 0) {
                line.lost -= dot(p, mean);
                continue;
            }
            line.given -= dot(p, u);
            line.lost -= dot(p, u);
            line.felt += length(p);
        }
        air_ -= dot(blown_[v], mean);
        falling_ += mass_[v] * h * dot(g_, u - mean);
        const Vec<double> damped = state.velocity[v].v;
        damping_ += 0.5 * mass_[v] * (dot(u, u) - dot(damped, damped));
        velocities_[v] = damped;
        positions_[v] = state.position(static_cast<int>(v));
    }
    for (Impulses& impulses : impulses_) std::ranges::fill(impulses, Vec<double>{});
    std::ranges::fill(blown_, Vec<double>{});
}

}  // namespace plait::test
