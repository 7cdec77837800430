// A set of constraints of one kind: coloured, laid out in blocks for the kernels, swept in either
// direction. What is here happens once a run or once a colour; the loop over constraints is in
// kernel_loop.h.
#pragma once

#include "../constraint.h"
#include "../constraints/kinds.h"
#include "../constraints/moving_rows.h"
#include "../constraints/rows.h"
#include "../kernels/kernel_loop.h"
#include "coloring.h"

#include <algorithm>
#include <type_traits>

namespace plait {

// Place of a kind in the list of kinds, -1 for a kind from outside the core.
template <class Kind, class... Listed>
constexpr int kindIndex(KindList<Listed...>) {
    int index = -1, i = 0;
    ((std::is_same_v<Kind, Listed> ? index = i : 0, ++i), ...);
    return index;
}

// The kernels of a kind; those of a kind from outside the core are compiled where it is used.
template <class Kind, class Real>
const KernelTable<Real>& kernelTable(KernelChoice choice) {
    constexpr int index = kindIndex<Kind>(Kinds{});
    if constexpr (index < 0) {
        using Wide = std::conditional_t<std::is_same_v<Real, float>, Pack<4>, Real>;
        return choice.lanes == 1 ? kernelsOf<Kind, Real> : kernelsOf<Kind, Wide>;
    } else if constexpr (std::is_same_v<Real, float>) {
        return floatKernels(choice, index);
    } else {
        return doubleKernels(choice, index);
    }
}

template <class Kind, class Real>
class ConstraintSet : public Constraint<Real> {
public:
    using Row = typename Kind::template Row<Real>;
    using WideRow = typename Kind::template Row<double>;

    // `padding` is a vertex without mass that nothing else uses; all others are below it. `renamed`
    // are the stencils where some came apart, at the same places; empty: those of the rows.
    ConstraintSet(Rows<Kind> set, int padding, KernelChoice choice)
        : ConstraintSet(std::make_shared<const Rows<Kind>>(std::move(set)), padding, choice) {}
    ConstraintSet(SharedRows<Kind> set, int padding, KernelChoice choice,
                  std::vector<int> renamed = {})
        : set_(std::move(set)),
          renamed_(std::move(renamed)),
          moving_(*set_),
          kernels_(kernelTable<Kind, Real>(choice)) {
        layOut(set_->colors.empty() ? greedyColors(set_->ids, arity, padding) : set_->colors,
               padding);
    }

    void beginFrame(double t0, double t1) override { moving_.beginFrame(t0, t1); }

    void begin(const Substep& substep, Workers& workers) override {
        std::fill(lambda_.begin(), lambda_.end(), Lanes{});
        if (!moving_) return;
        workers.forBlocks(static_cast<int>(slot_.size()), 1024, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) setRow(i, moving_.at(i, substep.frameFraction));
        });
    }

    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override {
        const bool back = direction == Direction::backward;
        for (std::size_t c = 0; c < colors_.size(); ++c)
            run(kernels_.project, colors_[back ? colors_.size() - 1 - c : c], sweep, workers);
    }
    void smooth(const Sweep<Real>& sweep, Workers& workers) override {
        for (const Color& color : colors_) run(kernels_.smooth, color, sweep, workers);
    }
    void damp(const Sweep<Real>& sweep, Workers& workers) override {
        for (const Color& color : colors_) run(kernels_.damp, color, sweep, workers);
    }

    void countAt(std::vector<int>& counts) const override {
        for (const int v : stencils()) ++counts[static_cast<std::size_t>(v)];
    }
    void relaxBy(const std::vector<int>& counts) override {
        for (std::size_t i = 0; i < slot_.size(); ++i) {
            int most = 1;
            for (std::size_t a = 0; a < arity; ++a)
                most = std::max(most, counts[static_cast<std::size_t>(stencils()[i * arity + a])]);
            at(relax_, slot_[i]) = Real(1) / static_cast<Real>(most);
        }
    }

    void markTouched(std::vector<std::uint8_t>& touched) const override {
        if constexpr (requires { Kind::contact; })
            for (std::size_t i = 0; i < slot_.size(); ++i)
                for (std::size_t a = 0; a < arity; ++a)
                    touched[static_cast<std::size_t>(stencils()[i * arity + a])] |=
                        at(lambda_, slot_[i]) != Real(0);
    }

    bool termsOf(std::span<const int> which, const State<Real>& state, bool curved,
                 Terms<Real>& out) const override {
        setTerms<Kind>(out, stencils(), which, curved, state,
                       [&](int i) { return read(slot_[i]); });
        return true;
    }

    long size() const override { return static_cast<long>(slot_.size()); }

    // Lagrange multiplier of constraint i of the set as given, of the substep last taken; force
    // along the gradient is multiplier / h^2.
    Real multiplier(int i) const { return at(lambda_, slot_[static_cast<std::size_t>(i)]); }
    int colorCount() const { return static_cast<int>(colors_.size()); }

private:
    static constexpr std::size_t arity = Kind::arity;
    static constexpr std::size_t members = sizeof(Row) / sizeof(Real);

    // Member m of the constraint in lane n of a block is at [m][n].
    template <class T, std::size_t m>
    struct alignas(64) Block {
        T member[m][blockSize];
    };
    using Lanes = Block<Real, 1>;
    struct Color {
        int begin, end;  // slots; multiples of blockSize
    };

    const std::vector<int>& stencils() const { return renamed_.empty() ? set_->ids : renamed_; }

    template <class Lane>
    static auto& at(Lane& lanes, int slot) {
        return lanes[static_cast<std::size_t>(slot / blockSize)].member[0][slot % blockSize];
    }

    // Colour by colour, each filled up to whole blocks with copies of its last row that hang on the
    // padding vertex and so change nothing. A colour in the order of its vertices, whichever its
    // constraints came in: the bits are the same, and memory is gone through in order (diagonals of
    // a grid come strand by strand, each vertex on another page).
    void layOut(const std::vector<int>& colors, int padding) {
        slot_.resize(colors.size());
        const int count = colors.empty() ? 0 : *std::max_element(colors.begin(), colors.end()) + 1;
        std::vector<std::vector<int>> membersOf(static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < colors.size(); ++i)
            membersOf[static_cast<std::size_t>(colors[i])].push_back(static_cast<int>(i));
        int slot = 0;
        for (std::vector<int>& color : membersOf) {
            const int begin = slot;
            std::sort(color.begin(), color.end(), [&](int a, int b) {
                const int first = set_->ids[static_cast<std::size_t>(a) * arity],
                          second = set_->ids[static_cast<std::size_t>(b) * arity];
                return first < second || (first == second && a < b);
            });
            for (const int i : color) {
                slot_[static_cast<std::size_t>(i)] = slot;
                place(slot++, i, padding);
            }
            if (color.empty()) continue;
            while (slot % blockSize) place(slot++, color.back(), padding, true);
            colors_.push_back({begin, slot});
        }
    }

    void place(int slot, int i, int padding, bool pad = false) {
        const auto block = static_cast<std::size_t>(slot / blockSize);
        if (block == ids_.size()) {
            ids_.emplace_back();
            rows_.emplace_back();
            lambda_.emplace_back();
            relax_.emplace_back();
        }
        for (std::size_t a = 0; a < arity; ++a)
            ids_[block].member[a][slot % blockSize] =
                pad ? padding : stencils()[static_cast<std::size_t>(i) * arity + a];
        write(slot, narrow<Kind, Real>(set_->rows[static_cast<std::size_t>(i)]));
    }

    void setRow(int i, const WideRow& row) {
        write(slot_[static_cast<std::size_t>(i)], narrow<Kind, Real>(row));
    }

    void write(int slot, const Row& row) {
        Stencil<Real, static_cast<int>(members)> numbers;
        __builtin_memcpy(&numbers, &row, sizeof row);
        auto& block = rows_[static_cast<std::size_t>(slot / blockSize)];
        for (std::size_t m = 0; m < members; ++m)
            block.member[m][slot % blockSize] = numbers[static_cast<int>(m)];
    }

    Row read(int slot) const {
        Stencil<Real, static_cast<int>(members)> numbers;
        const auto& block = rows_[static_cast<std::size_t>(slot / blockSize)];
        for (std::size_t m = 0; m < members; ++m)
            numbers[static_cast<int>(m)] = block.member[m][slot % blockSize];
        Row row;
        __builtin_memcpy(&row, &numbers, sizeof row);
        return row;
    }

    void run(Kernel<Real> kernel, const Color& color, const Sweep<Real>& sweep, Workers& workers) {
        const Batch<Real> batch{&ids_[0].member[0][0], &rows_[0].member[0][0],
                                &lambda_[0].member[0][0], &relax_[0].member[0][0]};
        constexpr int grain = 16;  // blocks a thread takes at least: below, a barrier costs more
        workers.forBlocks((color.end - color.begin) / blockSize, grain, [&](int begin, int end) {
            kernel(sweep, batch, color.begin + begin * blockSize, color.begin + end * blockSize);
        });
    }

    SharedRows<Kind> set_;
    std::vector<int> renamed_;
    MovingRows<Kind> moving_;
    const KernelTable<Real>& kernels_;
    std::vector<Block<int, arity>> ids_;
    std::vector<Block<Real, members>> rows_;
    std::vector<Lanes> lambda_, relax_;
    std::vector<Color> colors_;
    std::vector<int> slot_;  // of each constraint, in the order given
};

}  // namespace plait
