// Air: drag, tangential drag and lift on each triangle, and on each edge that no triangle has; and
// the air that a sheet carries with it [AW1-AW8, X9].
//
// A facet of area A with unit normal n (of an edge: along the part of u across it) meets the air at
// u = wind - v, v its vertices' mean velocity; u = un n + ut. The force on it, by form:
//
//   legacy     A rho Cd (un n + tau ut) + A rho Cl L, Cd in m/s            (M 5.3, 5.4)
//   physical   A rho / 2 (Cd (|un| un n + tau |ut| ut) + Cl L)             (the remedy M 5.3 wants)
//
//   L = un (|u| n - un u / |u|), the part across the wind of a pressure |u| un (a thin plate's at
//       small angles of attack): 0 broadside and edge-on, in the plane of wind and normal
//
// rho density, Cd drag, tau tangential drag, Cl lift. M gives powers of speed, not formulas.
// `legacy` keeps its faults: drag is linear in speed and its area fixed (that of the rest shape),
// lift is quadratic and outgrows it. `physical` has both at area times speed squared, of the area
// as it is.
//
// In time: a facet has its share of its vertices' mass, in proportion to rest area, and drag is
// solved implicitly (backward Euler; a quadratic equation in `physical`) on facet and share alone.
// Energy is convex, so the sum of all facets gains none, for any h, masses and pins; terminal
// velocity and the angle of a strip in wind are exact for any h if gravity has acted before, so
// register air after it, with an interval of 1. Lift does no work in the frame of the air:
// `physical` keeps to that exactly, turning u by a scheme of first order; `legacy` is explicit and
// gains energy at high speed, as M 5.3 warns [AW6]. Negative drag and lift are explicit.
//
// Gusts are sampled where a facet is when a frame begins, for the times of both its ends, and run
// straight between them, as everything that is animated does (M 2.4); `velocity` is asked whenever
// the air pushes. With c the larger of frame / noise time and frame * drift / noise length the
// error is 0.9 c^2 of the gusts, root mean square, and 1.8 c^2 where both are alike: 0.3 % at 24
// frames a second, 1 s, and 1 m/s over 1 m; 10 % at c = 1/4, beyond which gusts lose strength as
// well. What a facet moves in a frame it notices when the next begins. Outside a frame gusts are
// those of t.
#pragma once

#include "../complex/complex.h"
#include "../force.h"
#include "carried_air.h"
#include "skin.h"
#include "wind.h"

#include <memory>
#include <vector>

namespace plait {

struct World;

enum class AirForm { legacy, physical };

struct AirOptions {
    AirForm form = AirForm::physical;
    double density = 1;            // kg/m^3
    double drag = 1;               // physical: 1.2 is a flat plate; legacy: m/s
    double tangentialDrag = 0.05;  // 0 slips like a knife, 1 is as sticky as a sphere
    double lift = 0;
    // Air that moves with a sheet and that the wind carries along it: what flags flutter by. A
    // thin sheet that waves with the wave number k carries 2 rho / k (potential flow on both
    // sides), more than its own mass for silk.
    CarriedAirOptions carried = {};
    double width = 0.01;              // m, of a curve: its area per length
    int interval = 1;                 // substeps from one push to the next, which is for them all
    std::vector<Range> objects = {};  // that the air acts on; empty: everything
    Wind wind = {};
};

// Adds air to a world, with a warning for each value outside its sensible range [FH15]: density and
// drag >= 0, tangential drag 0 to 1, lift 0 to drag in `legacy` (M 5.6.1) and 0 to 2 pi (a thin
// plate) in `physical`. Throws as the class does.
void actAir(World& world, const AirOptions& options);

template <class Real>
class Air : public Force<Real> {
public:
    // Throws std::invalid_argument for numbers that are not finite, a noise, mass, reach or width
    // below 0, mass carried that reaches nowhere, triangles that carry air and go round an edge the
    // same way, a noise length or time not above 0, an interval below 1, objects that the world has
    // not, and kernels that are not available.
    Air(const World& world, const AirOptions& options, KernelChoice kernels = bestKernels());

    std::string name() const override { return "air"; }
    void furnish(Drawer<Real>& kept) const override;
    void beginFrame(const State<Real>& state, double t0, double t1, Workers& workers) override;
    void prepare(State<Real>& state, Drawer<Real>& kept, double t, double h,
                 Workers& workers) override;
    void apply(State<Real>& state, double t, double h, Workers& workers) override;

    // N s that the air last gave, what pins took included.
    Vec<double> impulse() const;

private:
    Vec<double> gust(const Vec<double>& x, double t) const;
    bool rests(const State<Real>& state) const { return state.substep % options_.interval != 0; }
    AirStep<Real> stepOf(State<Real>& state, double t) const;

    AirOptions options_;
    const AirTable<Real>& kernels_;
    std::array<AirSkin<Real>, 2> skins_;  // edges, triangles
    std::unique_ptr<CarriedAir<Real>> carried_;
    double from_ = 0, to_ = 0;  // s, the frame that gusts are known for
    Vec<double> wind_{};        // m/s, of the substep
};

}  // namespace plait
