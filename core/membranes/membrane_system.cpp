#include "membrane_system.h"

#include "../numbers/symmetric.h"

#include <algorithm>

namespace plait {
namespace {

Four times(const Four* columns, const Four& v) {
    return v[0] * columns[0] + v[1] * columns[1] + v[2] * columns[2];
}

double dot(const Four& a, const Four& b) {
    const Four c = a * b;
    return c[0] + c[1] + c[2];
}

// Of element corners: by vertex, in the order of elements.
template <std::size_t n, class Corner>
void cornersOf(std::span<const std::array<int, n>> elements, int vertices, std::vector<int>& start,
               std::vector<Corner>& corners) {
    start.assign(static_cast<std::size_t>(vertices) + 1, 0);
    for (const auto& element : elements)
        for (const int v : element) ++start[v + 1];
    for (int v = 0; v < vertices; ++v) start[v + 1] += start[v];
    corners.resize(static_cast<std::size_t>(start[vertices]));
    std::vector<int> next(start.begin(), start.end() - 1);
    for (int e = 0; e < std::ssize(elements); ++e)
        for (int c = 0; c < static_cast<int>(n); ++c) corners[next[elements[e][c]]++] = {e, c, {}};
}

}  // namespace

MembraneSystem::MembraneSystem(int vertices, std::span<const std::array<int, 2>> springs,
                               std::span<const std::array<int, 3>> patches)
    : vertices_(vertices),
      parts_(std::max(1, (vertices + part - 1) / part)),
      r_(vertices),
      z_(vertices),
      p_(vertices),
      product_(vertices),
      partial_(parts_),
      curvature_(parts_) {
    cornersOf(springs, vertices, springStart_, springCorners_);
    cornersOf(patches, vertices, patchStart_, patchCorners_);
    start_.push_back(0);
    for (int v = 0; v < vertices; ++v) {
        std::vector<int> row;
        for (int i = springStart_[v]; i < springStart_[v + 1]; ++i)
            for (const int other : springs[springCorners_[i].element]) row.push_back(other);
        for (int i = patchStart_[v]; i < patchStart_[v + 1]; ++i)
            for (const int other : patches[patchCorners_[i].element]) row.push_back(other);
        row.push_back(v);
        std::ranges::sort(row);
        row.erase(std::ranges::unique(row).begin(), row.end());
        row.erase(std::ranges::find(row, v));
        row.insert(row.begin(), v);
        const auto place = [&](int other) {
            return start_[v] + static_cast<int>(std::ranges::find(row, other) - row.begin());
        };
        for (int i = springStart_[v]; i < springStart_[v + 1]; ++i)
            for (int c = 0; c < 2; ++c)
                springCorners_[i].places[c] = place(springs[springCorners_[i].element][c]);
        for (int i = patchStart_[v]; i < patchStart_[v + 1]; ++i)
            for (int c = 0; c < 3; ++c)
                patchCorners_[i].places[c] = place(patches[patchCorners_[i].element][c]);
        column_.insert(column_.end(), row.begin(), row.end());
        start_.push_back(static_cast<int>(column_.size()));
    }
    blocks_.resize(column_.size());
    preconditioner_.resize(vertices);
}

double MembraneSystem::total(std::span<const double> sums) {
    double sum = 0;
    for (const double of : sums) sum += of;
    return sum;
}

void MembraneSystem::addRow(int v, std::span<const Block> springs,
                            std::span<const std::array<Block, 6>> patches) {
    const auto add = [&](int place, double sign, const Block& block) {
        for (int c = 0; c < 3; ++c) blocks_[place].column[c] += sign * four(block.column[c]);
    };
    for (int i = springStart_[v]; i < springStart_[v + 1]; ++i) {
        const Corner& at = springCorners_[i];
        for (int c = 0; c < 2; ++c) add(at.places[c], c == at.corner ? 1 : -1, springs[at.element]);
    }
    // Where in a patch the block of two corners is; below the diagonal it is transposed.
    static constexpr int of[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
    for (int i = patchStart_[v]; i < patchStart_[v + 1]; ++i) {
        const Corner& at = patchCorners_[i];
        for (int c = 0; c < 3; ++c) {
            const Block& block = patches[at.element][of[at.corner][c]];
            add(at.places[c], 1, c < at.corner ? block.transposed() : block);
        }
    }
}

void MembraneSystem::assemble(std::span<const double> inertia, std::span<const Block> springs,
                              std::span<const std::array<Block, 6>> patches, Workers& workers) {
    forParts(workers, [&](int, int begin, int end) {
        for (int v = begin; v < end; ++v) {
            preconditioner_[v] = {};
            std::fill(&blocks_[start_[v]], &blocks_[start_[v]] + (start_[v + 1] - start_[v]),
                      Columns{});
            if (inertia[v] == 0) continue;
            addRow(v, springs, patches);
            Columns& own = blocks_[start_[v]];
            for (int c = 0; c < 3; ++c) own.column[c][c] += inertia[v];
            const Symmetric<double> a{own.column[0][0], own.column[1][0], own.column[2][0],
                                      own.column[1][1], own.column[2][1], own.column[2][2]};
            for (int c = 0; c < 3; ++c)
                preconditioner_[v].column[c] =
                    four(a.solve({double(c == 0), double(c == 1), double(c == 2)}));
        }
    });
}

Vec<double> MembraneSystem::forceOn(int v, std::span<const Vec<double>> springs,
                                    std::span<const std::array<Vec<double>, 3>> patches) const {
    Vec<double> sum{0, 0, 0};
    for (int i = springStart_[v]; i < springStart_[v + 1]; ++i) {
        const Corner& at = springCorners_[i];
        sum += (at.corner == 0 ? 1.0 : -1.0) * springs[at.element];
    }
    for (int i = patchStart_[v]; i < patchStart_[v + 1]; ++i)
        sum += patches[patchCorners_[i].element][patchCorners_[i].corner];
    return sum;
}

// product = A p without gases; curvature p A p; along g p.
void MembraneSystem::multiply(std::span<const RankOne> gases, Workers& workers) {
    forParts(workers, [&](int at, int begin, int end) {
        double curvature = 0;
        for (int v = begin; v < end; ++v) {
            Four sum{};
            for (int i = start_[v]; i < start_[v + 1]; ++i)
                sum += times(blocks_[i].column, p_[column_[i]]);
            product_[v] = sum;
            curvature += dot(sum, p_[v]);
        }
        curvature_[at] = curvature;
        for (std::size_t g = 0; g < gases.size(); ++g) {
            double along = 0;
            for (int v = begin; v < end; ++v) along += dot(gases[g].g[v], p_[v]);
            along_[g * parts_ + at] = along;
        }
    });
}

int MembraneSystem::solve(std::span<const Four> b, std::span<const RankOne> gases, int iterations,
                          double tolerance, std::span<Four> x, Workers& workers) {
    along_.resize(gases.size() * parts_);
    forParts(workers, [&](int at, int begin, int end) {
        double rz = 0;
        for (int v = begin; v < end; ++v) {
            x[v] = Four{};
            r_[v] = b[v];
            p_[v] = times(preconditioner_[v].column, r_[v]);
            rz += dot(r_[v], p_[v]);
        }
        partial_[at] = rz;
    });
    double rz = total(partial_);
    const double enough = tolerance * tolerance * rz;
    pull_.resize(gases.size());
    int taken = 0;
    while (taken < iterations && rz > enough) {
        multiply(gases, workers);
        double curvature = total(curvature_);
        for (std::size_t g = 0; g < gases.size(); ++g) {
            const double along = total(std::span(along_).subspan(g * parts_, parts_));
            pull_[g] = gases[g].s * along;
            curvature += pull_[g] * along;
        }
        if (!(curvature > 0)) break;
        const double step = rz / curvature;
        forParts(workers, [&](int at, int begin, int end) {
            double sum = 0;
            for (int v = begin; v < end; ++v) {
                Four product = product_[v];
                // What does not move takes no part in a gas.
                for (std::size_t g = 0; g < gases.size(); ++g) product += pull_[g] * gases[g].g[v];
                x[v] += step * p_[v];
                r_[v] -= step * product;
                z_[v] = times(preconditioner_[v].column, r_[v]);
                sum += dot(r_[v], z_[v]);
            }
            partial_[at] = sum;
        });
        const double next = total(partial_), turn = next / rz;
        rz = next;
        ++taken;
        forParts(workers, [&](int, int begin, int end) {
            for (int v = begin; v < end; ++v) p_[v] = z_[v] + turn * p_[v];
        });
    }
    return taken;
}

}  // namespace plait
