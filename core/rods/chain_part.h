// Rows of one kind in a chain set, which knows of them only what stands here.
#pragma once

#include "../constraint.h"
#include "../constraints/kinds.h"
#include "../constraints/moving_rows.h"
#include "../sets/constraint_set.h"
#include "chain_loop.h"
#include "chain_plan.h"

#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace plait {

class ChainPart {
public:
    virtual ~ChainPart() = default;

    const ChainStencils& stencils() const { return stencils_; }
    int rows() const { return static_cast<int>(stencils_.ids.size()) / stencils_.arity; }

    virtual void beginFrame(double /*t0*/, double /*t1*/) {}
    // True if rows are no more what they were.
    virtual bool begin(const Substep&) { return false; }

    // Numbers of a row, and those of row i.
    virtual int members() const = 0;
    virtual const double* row(int i) const = 0;

    // `along`: for rows of one curve side by side; else for rows of as many curves.
    virtual ChainRowsKernel kernel(KernelChoice choice, bool along) const = 0;

protected:
    explicit ChainPart(const ChainStencils& stencils) : stencils_(stencils) {}

private:
    ChainStencils stencils_;
};

template <class Kind>
class ChainPartOf final : public ChainPart {
public:
    explicit ChainPartOf(SharedRows<Kind> set)
        : ChainPart({set->ids, Kind::arity, valuesOf<Kind>(), std::is_same_v<Kind, Stretch>}),
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
    bool begin(const Substep& substep) override {
        if (!moving_) return false;
        for (int i = 0; i < rows(); ++i) rows_[i] = moving_.at(i, substep.frameFraction);
        return true;
    }

    int members() const override { return sizeof(Row) / sizeof(double); }
    const double* row(int i) const override { return reinterpret_cast<const double*>(&rows_[i]); }

    // Of a kind from outside the core that which is compiled where it is used.
    ChainRowsKernel kernel(KernelChoice choice, bool along) const override {
        constexpr int index = kindIndex<Kind>(ChainKinds{});
        const auto& table = [&]() -> const ChainRowsTable& {
            if constexpr (index < 0)
                return chainRowsOf<Kind, double>;
            else
                return chainRowsKernels(choice, index);
        }();
        return table.evaluate[along ? 1 : 0];
    }

private:
    static_assert(Kind::arity > 1 && Kind::arity <= mostChained);

    using Row = typename Kind::template Row<double>;

    SharedRows<Kind> set_;
    std::vector<Row> rows_;
    MovingRows<Kind> moving_;
};

}  // namespace plait
