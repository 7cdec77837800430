// Where everything of a curve stands in memory, for the inner loops: what curves of one plan have
// in common.
#pragma once

#include "chain_kernels.h"
#include "chain_plan.h"

#include <span>
#include <vector>

namespace plait {

class ChainLayout {
public:
    // Rows of one part, `of` them by number in what a unit keeps: as ChainRows.
    struct Part {
        int part, rows, blocks;
        int ids;         // where its own begin, in ids()
        int parameters;  // and in those of a unit
        int out;
    };

    // `along`: of a curve alone, `width` of whose rows are evaluated at once; else of as many
    // curves. `members` by part: parameters of a row.
    ChainLayout(const ChainCurve& plan, std::span<const ChainStencils> stencils,
                std::span<const int> members, int width, bool along);

    bool along() const { return along_; }
    int curves() const { return along_ ? 1 : width_; }
    int width() const { return width_; }
    const std::vector<Part>& parts() const { return parts_; }
    const int* ids() const { return ids_.data(); }
    int rows() const { return static_cast<int>(places_.size()); }
    int vertices() const { return vertices_; }
    int parameters() const { return parameters_; }  // numbers of a unit
    // Numbers to work in: of vertices, of what is left of rows, and of the system.
    int scratch() const { return vertexScratch() + out_ + systemScratch(); }
    int vertexScratch() const { return vertexNumbers * vertices_ * curves(); }

    // Of a unit with particles `ids` and multipliers `lambda`.
    ChainSystem system(const int* ids, double* lambda, double* scratch) const;

    // Where number 0 of row r stands, in what has `numbers` of them a row.
    int slot(int r, int numbers) const {
        return along_ ? r / width_ * width_ * numbers + r % width_ : r * width_ * numbers;
    }

private:
    int systemScratch() const;
    void placeRows(const ChainCurve& plan, std::span<const ChainStencils> stencils,
                   std::span<const int> members);
    void meet(const ChainCurve& plan);
    void join(const ChainCurve& plan, std::span<const ChainStencils> stencils);

    int width_;
    bool along_;
    int vertices_, moving_;
    BandShape shape_, links_{};
    int parameters_ = 0, out_ = 0;
    std::vector<Part> parts_;
    std::vector<int> ids_, places_, begins_, edges_, ready_, joinedAt_;
    std::vector<ChainMeeting> meetings_;
    std::vector<ChainJoint> joints_;
};

}  // namespace plait
