// Rows of one kind in a chain set, which knows of them only what stands here. All is double,
// whatever the run is in: in float the end of a long rod never rests.
#pragma once

#include "../constraint.h"
#include "../constraints/constants.h"
#include "../constraints/kinds.h"
#include "../constraints/moving_rows.h"
#include "../numbers/convert.h"
#include "chain_plan.h"

#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace plait {

// One value of a row at the positions of a sweep.
struct ChainRow {
    double c;           // C
    double compliance;  // on either side of C
    Stencil<Vec<double>, mostChained> gradient;
    Stencil<Vec<double>, mostChained> answer;  // W gradient, where the set puts it
};

class ChainPart {
public:
    virtual ~ChainPart() = default;

    int arity() const { return arity_; }
    int values() const { return values_; }    // of a row
    bool areLinks() const { return links_; }  // C is a distance less a constant
    std::span<const int> ids() const { return ids_; }
    int rows() const { return static_cast<int>(ids_.size()) / arity_; }

    virtual void beginFrame(double /*t0*/, double /*t1*/) {}
    virtual void begin(const Substep&) {}

    // Row i, its values to out[0], out[1] ...
    virtual void evaluate(int i, const Sweep<float>&, ChainRow* out) const = 0;
    virtual void evaluate(int i, const Sweep<double>&, ChainRow* out) const = 0;

protected:
    ChainPart(std::span<const int> ids, int arity, int values, bool links)
        : ids_(ids), arity_(arity), values_(values), links_(links) {}

private:
    std::span<const int> ids_;
    int arity_, values_;
    bool links_;
};

template <class Kind>
constexpr int valuesOf() {
    if constexpr (requires { Kind::values; })
        return Kind::values;
    else
        return 1;
}

template <class Kind>
class ChainPartOf final : public ChainPart {
public:
    explicit ChainPartOf(SharedRows<Kind> set)
        : ChainPart(set->ids, Kind::arity, valuesOf<Kind>(), std::is_same_v<Kind, Stretch>),
          set_(std::move(set)),
          rows_(set_->rows),
          moving_(*set_) {
        if constexpr (valuesOf<Kind>() == 1)
            for (const auto& row : rows_)
                if (Kind::compliance(row, 1.0) != Kind::compliance(row, -1.0) ||
                    Kind::compliance(row, 1.0) >= slack)
                    throw std::invalid_argument("rows of one side cannot be solved at once");
    }

    void beginFrame(double t0, double t1) override { moving_.beginFrame(t0, t1); }
    void begin(const Substep& substep) override {
        if (!moving_) return;
        for (int i = 0; i < rows(); ++i) rows_[i] = moving_.at(i, substep.frameFraction);
    }
    void evaluate(int i, const Sweep<float>& sweep, ChainRow* out) const override {
        evaluateIn(i, sweep, out);
    }
    void evaluate(int i, const Sweep<double>& sweep, ChainRow* out) const override {
        evaluateIn(i, sweep, out);
    }

private:
    static_assert(Kind::arity > 1 && Kind::arity <= mostChained);

    template <class Real>
    void evaluateIn(int i, const Sweep<Real>& sweep, ChainRow* out) const {
        constexpr int arity = Kind::arity;
        const int* const v = &set_->ids[arity * i];
        Stencil<Vec<double>, arity> before{}, x{};
        const Real* const first = sweep.particles + 8 * v[0];
        for (int a = 1; a < arity; ++a) {
            const Real* const p = sweep.particles + 8 * v[a];
            before[a] = three(p) - three(first);
            x[a] = before[a] + (three(p + 4) - three(first + 4));
        }
        const auto& row = rows_[i];
        if constexpr (valuesOf<Kind>() > 1) {
            typename Kind::template Gradients<double> gradient;
            const auto c = Kind::evaluate(row, x, before, gradient),
                       compliance = Kind::compliance(row);
            for (int k = 0; k < Kind::values; ++k) {
                out[k].c = c[k];
                out[k].compliance = compliance[k];
                for (int a = 0; a < arity; ++a) out[k].gradient[a] = gradient[k][a];
            }
        } else {
            Stencil<Vec<double>, arity> gradient;
            out->c = Kind::evaluate(row, x, gradient);
            out->compliance = Kind::compliance(row, 1.0);
            for (int a = 0; a < arity; ++a) out->gradient[a] = gradient[a];
        }
    }

    SharedRows<Kind> set_;
    std::vector<typename Kind::template Row<double>> rows_;
    MovingRows<Kind> moving_;
};

}  // namespace plait
