#include "multifrontal.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace plait {
namespace {

// body(item, thread) for all items, each by whichever thread is free.
template <class Body>
void deal(int count, Workers& workers, const Body& body) {
    std::atomic<int> next{0};
    const auto run = [&](int thread, int) {
        for (int item = next++; item < count; item = next++) body(item, thread);
    };
    count > 1 ? workers.forBlocks(workers.threads(), 1, run) : run(0, 1);
}

// body(begin, end) for [0, count), of which each item takes `each` operations.
template <class Body>
void dealRuns(int count, double each, Workers& workers, const Body& body) {
    constexpr double enough = 1e5;  // operations that are worth handing over
    constexpr int multiple = 3;     // of what kernels like to do at once
    if (workers.threads() == 1 || count <= multiple) return body(0, count);
    const int run = static_cast<int>(enough / (each * multiple) + 1) * multiple;
    const int runs = (count + run - 1) / run;
    // The last ones, often the longest, first.
    deal(runs, workers, [&](int item, int) {
        const int begin = (runs - 1 - item) * run;
        body(begin, std::min(begin + run, count));
    });
}

// Three rows of a panel from `row` on, each from column 0; its columns are stripRows apart.
std::array<float*, 3> rowsFrom(float* panel, int pivotStrips, int row) {
    const auto at = [&](int r) {
        return panel + stripRows * columnsBefore(pivotStrips, r / stripRows) + r % stripRows;
    };
    return {at(row), at(row + 1), at(row + 2)};
}

bool isFinite(const Symmetric<float>& a) {
    return std::isfinite(a.xx + a.xy + a.xz + a.yy + a.yz + a.zz);
}

}  // namespace

Multifrontal::Multifrontal(std::span<const Vec<double>> rest, std::span<const int> edges,
                           std::span<const unsigned char> pinned,
                           const MultifrontalOptions& options)
    : fronts_(analyse(rest, edges, pinned, options.leaf)),
      kernels_(frontKernels(options.kernels)),
      vertices_(rest.size()),
      edges_(edges.size() / 2),
      panels_(fronts_.panelColumns + 1),
      own_(fronts_.ownColumns + 1),
      rows_(fronts_.rows / stripRows + 1),
      least_(fronts_.rows / stripRows + 1) {}

double Multifrontal::multiplications() const {
    double sum = 0;
    for (const Front& front : fronts_.fronts) {
        const double p = stripRows * front.pivotStrips, b = stripRows * front.boundaryStrips;
        sum += p * p * p / 6 + p * p * b / 2 + p * b * b / 2 + p * p + 2 * p * b;
    }
    return sum;
}

FrontView Multifrontal::viewOf(const Front& front, Columns& memory) {
    Columns& schur = front.ownMemory ? own_ : memory;
    return {panels_.data()->number + front.panel * stripRows,
            schur.data()->number + front.schur * stripRows, least_.data()->number + front.rows,
            front.pivotStrips, front.boundaryStrips};
}

// visit(front, thread, workers): threads share out subtrees, then the fronts of a level, and where
// there are fewer of these than threads, what is in a front.
template <class Visit>
void Multifrontal::childrenFirst(Workers& workers, const Visit& visit) {
    deal(static_cast<int>(fronts_.subtrees.size()), workers, [&](int item, int thread) {
        for (int f = fronts_.subtrees[item].begin; f < fronts_.subtrees[item].end; ++f)
            visit(f, thread, alone_);
    });
    for (const std::vector<int>& level : fronts_.levels) {
        const int count = static_cast<int>(level.size());
        if (count >= workers.threads())
            deal(count, workers, [&](int item, int thread) { visit(level[item], thread, alone_); });
        else
            for (const int f : level) visit(f, 0, workers);
    }
}

Factored Multifrontal::factor(Blocks vertexBlocks, Blocks edgeBlocks, Workers& workers) {
    return factorForward(vertexBlocks, edgeBlocks, {}, workers);
}

Factored Multifrontal::factorAndSolve(Blocks vertexBlocks, Blocks edgeBlocks,
                                      std::span<Vec<float>> x, Workers& workers) {
    checkSize(x.size());
    const Factored factored = factorForward(vertexBlocks, edgeBlocks, x, workers);
    solveBackward(x, workers);
    return factored;
}

void Multifrontal::solve(std::span<Vec<float>> x, Workers& workers) {
    checkSize(x.size());
    const FlushDenormals flush;
    if (factored_) childrenFirst(workers, [&](int f, int, Workers&) { forward(f, x); });
    solveBackward(x, workers);
}

void Multifrontal::checkSize(std::size_t vertices) const {
    if (vertices != vertices_) throw std::invalid_argument("a number for each vertex is wanted");
}

Factored Multifrontal::factorForward(Blocks vertexBlocks, Blocks edgeBlocks,
                                     std::span<const Vec<float>> b, Workers& workers) {
    checkSize(vertexBlocks.size());
    if (edgeBlocks.size() != edges_) throw std::invalid_argument("a block for each edge is wanted");
    const FlushDenormals flush;
    while (static_cast<int>(threads_.size()) < workers.threads())
        threads_.emplace_back(fronts_.threadColumns + 1);
    std::atomic<int> frozen{0};
    std::atomic<bool> finite{true};
    childrenFirst(workers, [&](int f, int thread, Workers& together) {
        if (!assemble(fronts_.fronts[f], vertexBlocks, edgeBlocks)) finite = false;
        frozen += eliminate(f, threads_[thread], together);
        if (!b.empty()) forward(f, b);
    });
    factored_ = finite;
    return {finite, frozen};
}

bool Multifrontal::assemble(const Front& front, Blocks vertexBlocks, Blocks edgeBlocks) {
    constexpr float roundedAway = 0x1p-24f;
    const int k = front.pivotStrips;
    float* const panel = panels_.data()->number + front.panel * stripRows;
    float* const least = least_.data()->number + front.rows;
    std::memset(panel, 0, columnsBefore(k, k + front.boundaryStrips) * sizeof(Column));
    bool finite = true;
    int row = 0;
    for (int p = front.begin; p < front.end; ++p, row += 3) {
        const int c0 = row * stripRows, c1 = c0 + stripRows, c2 = c1 + stripRows;
        Symmetric<float> own = vertexBlocks[fronts_.order[p]];
        for (int i = fronts_.firstIncidence[p]; i < fronts_.firstIncidence[p + 1]; ++i) {
            const Incidence& at = fronts_.incidences[i];
            const Symmetric<float>& h = edgeBlocks[at.edge];
            own += h;
            if (at.row < 0) continue;
            const auto [x, y, z] = rowsFrom(panel, k, at.row);
            x[c0] -= h.xx, x[c1] -= h.xy, x[c2] -= h.xz;
            y[c0] -= h.xy, y[c1] -= h.yy, y[c2] -= h.yz;
            z[c0] -= h.xz, z[c1] -= h.yz, z[c2] -= h.zz;
        }
        const auto [x, y, z] = rowsFrom(panel, k, row);
        x[c0] = own.xx;
        y[c0] = own.xy, y[c1] = own.yy;
        z[c0] = own.xz, z[c1] = own.yz, z[c2] = own.zz;
        const float diagonal[] = {own.xx, own.yy, own.zz};
        for (int r = 0; r < 3; ++r) least[row + r] = std::max(diagonal[r] * roundedAway, 0.0F);
        finite = finite && isFinite(own);
    }
    for (; row < k * stripRows; ++row) {
        rowsFrom(panel, k, row)[0][row * stripRows] = 1;
        least[row] = 0;
    }
    return finite;
}

int Multifrontal::eliminate(int f, Columns& memory, Workers& workers) {
    const Front& front = fronts_.fronts[f];
    const FrontView view = viewOf(front, memory);
    extend(f, true, memory, workers);
    int frozen = 0;
    for (int block = 0; block < front.pivotStrips; ++block) {
        frozen += kernels_.eliminate(view, block);
        const int below = block + 1, strips = front.pivotStrips + front.boundaryStrips;
        dealRuns(strips - below, 4096 * (block + 0.5), workers, [&](int begin, int end) {
            kernels_.eliminateBelow(view, block, below + begin, below + end);
        });
    }
    dealRuns(front.boundaryStrips, 2048.0 * front.pivotStrips * front.boundaryStrips, workers,
             [&](int begin, int end) { kernels_.complement(view, begin, end); });
    extend(f, false, memory, workers);
    return frozen;
}

void Multifrontal::extend(int f, bool panel, Columns& memory, Workers& workers) {
    const FrontView parent = viewOf(fronts_.fronts[f], memory);
    for (const int c : fronts_.children[f]) {
        const Front& child = fronts_.fronts[c];
        const Extension extension{viewOf(child, memory).schur, child.overlaps.data(),
                                  child.firstOverlap.data(),   child.inParent.data(),
                                  child.boundaryStrips,        parent};
        const int rows = static_cast<int>(child.inParent.size());
        const int first = panel ? 0 : child.parentPivots, last = panel ? child.parentPivots : rows;
        dealRuns(last - first, 8.0 * rows, workers, [&](int begin, int end) {
            (panel ? kernels_.extendPanel : kernels_.extendComplement)(extension, first + begin,
                                                                       first + end);
        });
    }
}

void Multifrontal::solveBackward(std::span<Vec<float>> x, Workers& workers) {
    std::fill(x.begin(), x.end(), Vec<float>{0, 0, 0});
    if (!factored_) return;
    const FlushDenormals flush;
    for (std::size_t level = fronts_.levels.size(); level-- > 0;)
        deal(static_cast<int>(fronts_.levels[level].size()), workers,
             [&](int item, int) { backward(fronts_.levels[level][item], x); });
    deal(static_cast<int>(fronts_.subtrees.size()), workers, [&](int item, int) {
        for (int f = fronts_.subtrees[item].end; f-- > fronts_.subtrees[item].begin;)
            backward(f, x);
    });
}

void Multifrontal::forward(int f, std::span<const Vec<float>> b) {
    const Front& front = fronts_.fronts[f];
    const int pivots = front.pivotStrips * stripRows;
    float* const x = rowsOf(front);
    std::fill(x, x + pivots + static_cast<long>(front.boundaryStrips) * stripRows, 0.0F);
    for (int p = front.begin; p < front.end; ++p) {
        const Vec<float>& v = b[fronts_.order[p]];
        float* const at = x + 3L * (p - front.begin);
        at[0] = v.x, at[1] = v.y, at[2] = v.z;
    }
    for (const int c : fronts_.children[f]) {
        const Front& child = fronts_.fronts[c];
        const float* const passed = rowsOf(child) + child.pivotStrips * stripRows;
        for (std::size_t i = 0; i < child.inParent.size(); ++i) x[child.inParent[i]] += passed[i];
    }
    kernels_.forward(viewOf(front, own_), x);
}

void Multifrontal::backward(int f, std::span<Vec<float>> solution) {
    const Front& front = fronts_.fronts[f];
    float* const x = rowsOf(front);
    if (front.parent >= 0) {
        const float* const above = rowsOf(fronts_.fronts[front.parent]);
        float* const boundary = x + front.pivotStrips * stripRows;
        for (std::size_t i = 0; i < front.inParent.size(); ++i)
            boundary[i] = above[front.inParent[i]];
    }
    kernels_.backward(viewOf(front, own_), x);
    for (int p = front.begin; p < front.end; ++p) {
        const float* const at = x + 3L * (p - front.begin);
        solution[fronts_.order[p]] = {at[0], at[1], at[2]};
    }
}

}  // namespace plait
