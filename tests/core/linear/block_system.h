// Meshes with a random matrix and right-hand side on them, as the multifrontal solver takes them
// and as Eigen does.
#pragma once

#include "tests/random.h"
#include "tests/shells.h"

#include <plait/complex/shapes.h>
#include <plait/linear/multifrontal.h>
#include <plait/stencils.h>

#include <Eigen/Sparse>
#include <vector>

namespace plait::test {

using Blocks = std::vector<Symmetric<float>>;
using Vectors = std::vector<Vec<float>>;

// A mesh, and a matrix and a right-hand side on it.
struct System {
    std::vector<Vec<double>> rest;
    std::vector<int> edges;
    std::vector<unsigned char> pinned;
    Blocks vertexBlocks, edgeBlocks;
    Vectors b;

    System(std::vector<Vec<double>> positions, std::vector<int> pairs)
        : rest(std::move(positions)), edges(std::move(pairs)), pinned(rest.size(), 0) {}

    // Springs in any direction, up to 1 / softest as stiff across as along; vertices as heavy as
    // `mass`.
    System& fill(std::uint64_t seed, double mass, double softest = 0.01) {
        Random random(seed);
        const auto number = [&](double low, double high) {
            return static_cast<float>(random.uniform(low, high));
        };
        for (std::size_t v = 0; v < rest.size(); ++v) {
            const float m = number(0.5, 1.5) * static_cast<float>(mass);
            vertexBlocks.push_back({m, 0, 0, m, 0, m});
            b.push_back({number(-1, 1), number(-1, 1), number(-1, 1)});
        }
        for (std::size_t e = 0; e < edges.size() / 2; ++e) {
            const Vec<float> d{number(-1, 1), number(-1, 1), number(-1, 1)};
            const float g = number(softest, 2 * softest), k = number(0.5, 1.5) / dot(d, d);
            Symmetric<float> h{g, 0, 0, g, 0, g};
            h.addOuter(k, d);
            edgeBlocks.push_back(h);
        }
        return *this;
    }

    Eigen::SparseMatrix<double> matrix() const {
        std::vector<Eigen::Triplet<double>> entries;
        const auto add = [&](int i, int j, const Symmetric<float>& h, double sign) {
            const float full[3][3] = {{h.xx, h.xy, h.xz}, {h.xy, h.yy, h.yz}, {h.xz, h.yz, h.zz}};
            if (pinned[i] || pinned[j]) return;
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c)
                    entries.emplace_back(3 * i + r, 3 * j + c, sign * double(full[r][c]));
        };
        for (int v = 0; v < static_cast<int>(rest.size()); ++v) {
            add(v, v, vertexBlocks[v], 1);
            for (int r = 0; r < 3 && pinned[v]; ++r) entries.emplace_back(3 * v + r, 3 * v + r, 1);
        }
        for (std::size_t e = 0; e < edges.size() / 2; ++e) {
            const int i = edges[2 * e], j = edges[2 * e + 1];
            add(i, i, edgeBlocks[e], 1), add(j, j, edgeBlocks[e], 1);
            add(i, j, edgeBlocks[e], -1), add(j, i, edgeBlocks[e], -1);
        }
        const auto n = static_cast<Eigen::Index>(3 * rest.size());
        Eigen::SparseMatrix<double> a(n, n);
        a.setFromTriplets(entries.begin(), entries.end());
        return a;
    }

    Eigen::VectorXd right() const {
        Eigen::VectorXd all(3 * b.size());
        for (std::size_t v = 0; v < b.size(); ++v)
            all.segment<3>(static_cast<Eigen::Index>(3 * v)) =
                pinned[v] ? Eigen::Vector3d::Zero() : Eigen::Vector3d(b[v].x, b[v].y, b[v].z);
        return all;
    }
};

inline std::vector<int> edgesOf(const Shape& shape) {
    return edgeStencils(shape.complex, {0, static_cast<int>(shape.positions.size())});
}

inline System sheet(int columns, int rows, double width = 1, double height = 1) {
    const Shape shape = grid({.columns = columns, .rows = rows, .width = width, .height = height});
    return {shape.positions, edgesOf(shape)};
}

inline System irregular(int columns, int rows, std::uint64_t seed) {
    Shell shell = shellOf(columns, rows, seed);
    return {std::move(shell.rest), std::move(shell.links)};
}

inline System chain(int vertices) {
    std::vector<Vec<double>> rest;
    std::vector<int> edges;
    for (int v = 0; v < vertices; ++v) {
        rest.push_back({0.01 * v, 0, 0});
        if (v) edges.insert(edges.end(), {v - 1, v});
    }
    return {rest, edges};
}

// Points and edges anywhere.
inline System tangle(int vertices, int edges, std::uint64_t seed) {
    Random random(seed);
    System system({}, {});
    for (int v = 0; v < vertices; ++v) system.rest.push_back(random.point(1));
    for (int e = 0; e < 2 * edges; ++e) system.edges.push_back(random.below(vertices));
    system.pinned.assign(system.rest.size(), 0);
    return system;
}

inline System together(const std::vector<System>& systems) {
    System all({}, {});
    for (const System& system : systems) {
        for (const int v : system.edges) all.edges.push_back(v + static_cast<int>(all.rest.size()));
        all.rest.insert(all.rest.end(), system.rest.begin(), system.rest.end());
    }
    all.pinned.assign(all.rest.size(), 0);
    return all;
}

}  // namespace plait::test
