// The set that pushOut adds.
#pragma once

#include "../../collision/candidates.h"
#include "../../collision/kdop_tree.h"
#include "../../complex/csr.h"
#include "../../contact_constraint.h"
#include "push_out.h"

#include <memory>

namespace plait {

template <class Real>
class PushOutSet : public ContactConstraint<Real> {
public:
    PushOutSet(const World& world, Range mesh, const std::vector<Range>& points,
               const PushOutOptions& options);

    void begin(const Substep&, Workers&) override { again_ = false; }
    void project(const Sweep<Real>&, Direction, Workers&) override {}
    // Looks for what is inside where the substep ends; it is moved when that is over, so that it
    // is no motion.
    long finish(const Sweep<Real>& sweep, Workers& workers) override;
    void rebound(State<Real>& state, Drawer<Real>& kept) const override;
    long size() const override { return 0; }

    const PushOutCounts& counts() const { return counts_; }

private:
    static constexpr int slabs = 6;

    // The nearest place of the surface to a point that is inside or nearer than the thickness.
    struct Push {
        int vertex, triangle;
        double distance;  // m
        Vec<double> way;  // m
        Vec<double> out;  // unit
        std::array<double, 3> weight;
    };

    void locate(const Sweep<Real>& sweep, Workers& workers);
    Vec<double> normalAt(int triangle, const std::array<double, 3>& weight) const;
    std::array<Vec<double>, 3> cornersOf(int triangle) const;

    PushOutOptions options_;
    std::vector<int> points_;                    // vertices
    std::vector<std::array<int, 3>> triangles_;  // as they are oriented
    Csr fans_;                                   // triangles, by vertex
    std::vector<Vec<double>> x_;                 // m, by vertex
    std::unique_ptr<KDopTree<slabs>> pointTree_, triangleTree_;
    Candidates found_;
    std::vector<Push> near_, pushes_;  // near_: way from the surface, not yet the one to go
    bool again_ = false;               // this substep has been finished before
    PushOutCounts counts_;
};

extern template class PushOutSet<float>;
extern template class PushOutSet<double>;

}  // namespace plait
