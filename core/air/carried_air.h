// The air that moves with a sheet and along it: the reactive force of a stream (Lighthill, "Note on
// the swimming of slender fish", 1960; Argentina and Mahadevan, PNAS 2005).
//
// A sheet that moves across the air at u gives it momentum p = A u along its normal
// (MomentumFilter), and the wind carries that momentum on along the sheet. What the sheet has next
// it must give again: the force is -(d/dt + U . grad) A u, U the wind along the sheet. Of it the
// first part is inertia, the others are what makes flags flutter. With an A that is alike for all
// waves they would flutter at the size of the mesh.
//
// As a substep begins, P, the momentum by area along the normal, is carried along the sheet (linear
// elements with lumped masses, midpoint rule: of second order), in as many steps as the wind needs.
// Then sheet and air meet: (M + A) u' = M u + a P. Meeting can only lose energy, for any time since
// the last; what carrying brings is the wind's. P turns with the sheet, as the jump of a potential
// does: kept as a vector, what is rough in the normals of a crumpled sheet struck its vertices.
// Where the wind comes in at a border the air has met the border already.
#pragma once

#include "../kernels/workers.h"
#include "skin.h"

#include <memory>
#include <span>
#include <vector>

namespace plait {

class MomentumFilter;  // its header wants Eigen, which a program with air need not have

struct CarriedAirOptions {
    double mass = 0;   // kg/m^2, of long waves; 0: none is carried
    double reach = 0;  // m: l of MomentumFilter
};

template <class Real>
class CarriedAir {
public:
    // Throws std::invalid_argument where two triangles at an edge go round it the same way.
    CarriedAir(std::span<const RestFacet> triangles, int vertices,
               const CarriedAirOptions& options);
    ~CarriedAir();

    // Numbers of P: one a vertex, the padding vertex included.
    std::size_t numbers() const { return static_cast<std::size_t>(vertices_) + 1; }

    // To `velocity` and `lastVelocity` of the state, and to `momentum`, P, what `seconds` since the
    // last exchange bring, as a substep begins. Facets have their sides; `step`
    // its wind and gusts.
    void exchange(State<Real>& state, Real* momentum, const AirStep<Real>& step,
                  AirSkin<Real>& skin, const AirTable<Real>& kernels, double seconds,
                  Workers& workers);

    // N s that the last exchange gave the sheet, what pins took included.
    Vec<double> impulse() const;

private:
    struct BorderVertex {
        int place, vertex, before, after;  // along the border
    };

    void findBorder(std::span<const RestFacet> triangles);
    CarriedBlocks<Real> blocks(State<Real>& state, Real* momentum, double seconds);
    void closeInflow(const State<Real>& state, const AirStep<Real>& step);
    int turns(double seconds) const;
    template <class Write>
    void begin(Real* momentum, const Write& writeRight);
    void weigh(const State<Real>& state);
    void solve();

    CarriedAirOptions options_;
    int vertices_;
    std::unique_ptr<MomentumFilter> filter_;
    std::vector<int> vertexAt_;  // by place
    std::vector<BorderVertex> border_;
    std::vector<double> w_, right_, phi_;  // by place
    std::vector<Real> rates_, slopes_, areas_, open_, flatRight_, flatPhi_, middle_;
    std::vector<Padded<Real>> ways_, normals_, impulses_;
};

}  // namespace plait
