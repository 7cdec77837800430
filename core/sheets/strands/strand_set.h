// Stretch links strung to strands, each strand solved at once: an evaluation is one Newton step for
// all of its multipliers, exact and in O(N), eight strands and more side by side. Where a sheet is
// taut along its threads and soft across their weave, as cloth is, two such sets (warp and weft)
// hold it at any resolution; sweeps would need some N^2 of them.
//
// Unlike DirectSet it runs in the precision of the sweep and in lanes, and knows chains only; links
// resist compression as they do extension. Links without compliance that contradict each other (two
// pins further apart than the strand is long) have no solution; give them compliance.
//
// With geometric stiffness (Tournier et al., "Stable constrained dynamics", 2015) the multipliers
// that an evaluation finds act not along where links were, but, where they pull, along where they
// come to lie: what a taut strand has against being turned is then implicit, and a wave across it
// may pass many links in a substep (README.md). Theirs is of the step before and part of
// one system; here it is of the multipliers just found, in a second one, so that nothing is kept.
#pragma once

#include "../../constraint.h"
#include "../../constraints/kinds.h"
#include "../../constraints/rows.h"
#include "../../world.h"
#include "strand_kernels.h"
#include "strands.h"

#include <algorithm>
#include <stdexcept>

namespace plait {

template <class Real>
class StrandSet : public Constraint<Real> {
public:
    // `rest` by vertex, m; one vertex more is a vertex without mass that nothing else uses. Throws
    // std::invalid_argument for rows that move and for links that buckle or do not act.
    StrandSet(Rows<Stretch> set, std::span<const Vec<double>> rest, KernelChoice choice,
              bool geometricStiffness = false)
        : StrandSet(std::make_shared<const Rows<Stretch>>(std::move(set)), rest, choice,
                    geometricStiffness) {}
    StrandSet(const SharedRows<Stretch>& set, std::span<const Vec<double>> rest,
              KernelChoice choice, bool geometricStiffness = false)
        : StrandSet(set, strandsOf(set->ids, rest), static_cast<int>(rest.size()), choice,
                    geometricStiffness) {}
    // `strands` of all links, those of a colour from long to short; `padding` is that vertex.
    StrandSet(SharedRows<Stretch> shared, std::span<const Strand> strands, int padding,
              KernelChoice choice, bool geometricStiffness = false)
        : kernels_(strandKernels<Real>(choice)),
          set_(std::move(shared)),
          turns_(geometricStiffness) {
        const Rows<Stretch>& set = *set_;
        if (set.animate) throw std::invalid_argument("strands: rest lengths cannot move");
        for (const auto& row : set.rows)
            if (row.compression != row.compliance)
                throw std::invalid_argument("strands: links cannot buckle");
            else if (row.compliance >= slack)
                throw std::invalid_argument("strands: every link must act");
        const bool rigid = std::all_of(set.rows.begin(), set.rows.end(),
                                       [](const auto& row) { return row.compliance == 0; });
        int colors = 0;
        for (const Strand& strand : strands) colors = std::max(colors, strand.color + 1);
        for (int color = 0; color < colors; ++color) {
            std::vector<const Strand*> members;
            for (const Strand& strand : strands)
                if (strand.color == color) members.push_back(&strand);
            const int begin = static_cast<int>(shares_.size());
            for (std::size_t i = 0; i < members.size(); i += blockSize) {
                const std::size_t count = std::min<std::size_t>(blockSize, members.size() - i);
                blocks_.emplace_back(set, std::span(members).subspan(i, count), padding, rigid);
                // Half a block, where the lanes allow it: a flag has few blocks to deal out.
                const int share = std::max(blockSize / 2, choice.lanes);
                for (int n = 0; n < static_cast<int>(count); n += share)
                    shares_.push_back(
                        {static_cast<int>(blocks_.size()) - 1, n, n + share,
                         std::vector<Real>(strandWork * share * blocks_.back().links)});
            }
            colors_.push_back({begin, static_cast<int>(shares_.size())});
        }
    }

    void begin(const Substep&, Workers&) override {
        for (Block& block : blocks_) std::fill(block.lambda.begin(), block.lambda.end(), Real(0));
    }
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override {
        const bool back = direction == Direction::backward;
        for (std::size_t c = 0; c < colors_.size(); ++c)
            run(kernels_.project, colors_[back ? colors_.size() - 1 - c : c], sweep, workers);
    }
    void damp(const Sweep<Real>& sweep, Workers& workers) override {
        for (const Color& color : colors_) run(kernels_.damp, color, sweep, workers);
    }
    bool termsOf(std::span<const int> which, const State<Real>& state, bool curved,
                 Terms<Real>& out) const override {
        setTerms<Stretch>(out, set_->ids, which, curved, state,
                          [&](int i) { return narrow<Stretch, Real>(set_->rows[i]); });
        return true;
    }
    long size() const override { return set_->size(); }

private:
    // As in StrandBlock.
    struct Block {
        Block(const Rows<Stretch>& set, std::span<const Strand* const> strands, int padding,
              bool rigid)
            : links(static_cast<int>(strands[0]->links.size())),
              ids((links + 1) * blockSize, padding),
              rows(2 * links * blockSize, 0),
              lambda(rigid ? 0 : links * blockSize, 0) {
            for (std::size_t n = 0; n < strands.size(); ++n) {
                const Strand& strand = *strands[n];
                for (int v = 0; v <= links; ++v)
                    ids[v * blockSize + n] =
                        strand.vertices[std::min<std::size_t>(v, strand.links.size())];
                for (std::size_t k = 0; k < strand.links.size(); ++k) {
                    const auto& row = set.rows[strand.links[k]];
                    rows[2 * k * blockSize + n] = static_cast<Real>(row.rest);
                    rows[(2 * k + 1) * blockSize + n] = static_cast<Real>(row.compliance);
                }
            }
        }

        int links;  // of its longest strand
        std::vector<int> ids;
        std::vector<Real> rows, lambda;  // no lambda where all are rigid: it would be lost on them
    };
    // What a thread takes at once: these strands of a block.
    struct Share {
        int block, begin, end;
        std::vector<Real> work;
    };
    struct Color {
        int begin, end;  // shares
    };

    void run(StrandKernel<Real> kernel, const Color& color, const Sweep<Real>& sweep,
             Workers& workers) {
        workers.forBlocks(color.end - color.begin, 1, [&](int begin, int end) {
            // That of the first share, which has the longest strands, serves a whole run: it stays
            // in the cache, where one a share would be streamed through memory.
            Real* const work = shares_[color.begin + begin].work.data();
            for (int i = color.begin + begin; i < color.begin + end; ++i) {
                const Share& share = shares_[i];
                Block& block = blocks_[share.block];
                Real* const lambda = block.lambda.empty() ? nullptr : block.lambda.data();
                kernel(sweep, {block.ids.data(), block.rows.data(), lambda, work, block.links,
                               share.begin, share.end, turns_});
            }
        });
    }

    const StrandTable<Real>& kernels_;
    SharedRows<Stretch> set_;
    bool turns_;
    std::vector<Block> blocks_;
    std::vector<Share> shares_;
    std::vector<Color> colors_;
};

// These links strung to strands, each solved at once, in lanes: to those given, or, without any,
// the straightest ways through them.
void strand(World& world, const Rows<Stretch>& set, SetOptions options,
            bool geometricStiffness = false);
void strand(World& world, const Rows<Stretch>& set, std::vector<Strand> strands, SetOptions options,
            bool geometricStiffness = false);

}  // namespace plait
