// Multifrontal Cholesky in float against CHOLMOD in double, on sheets as large as scenes have.
#include "block_check.h"

#include <Eigen/CholmodSupport>
#include <numbers>

using namespace plait;
using namespace plait::test;

namespace {

using Cholmod = Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>>;

// With n x n vertices, or about as many.
struct Sheet {
    std::string name;
    System system;
};

std::vector<Sheet> sheets(int n) {
    const int rings = static_cast<int>(n / std::numbers::sqrt3);
    const Shape round = disc({.rings = rings});
    const std::string size = std::to_string(n);
    return {{"regular, side of " + size, sheet(n, n)},
            {"jittered, side of " + size, irregular(n, n, 3)},
            {"disc of " + std::to_string(rings) + " rings", {round.positions, edgesOf(round)}}};
}

void checkSheets(int n) {
    for (const auto& [name, empty] : sheets(n)) {
        for (const double mass : {1.0, 1e-3}) {
            System hung = empty;
            hung.fill(1, mass).pinned[0] = 1;
            checkAgainst<Cholmod>(name + (mass < 1 ? ", light" : ", heavy"), hung);
        }
        // Pivots that are lost, one component of a vertex each.
        System torn = empty;
        torn.fill(2, 0.1);
        std::vector<int> frozen;
        for (int v = 5; v < static_cast<int>(torn.rest.size()); v += 97) {
            Symmetric<float>& block = torn.vertexBlocks[v];
            (v % 3 == 0 ? block.xx : v % 3 == 1 ? block.yy : block.zz) = -1e4F;
            frozen.push_back(3 * v + v % 3);
        }
        checkAgainst<Cholmod>(name + ", frozen", torn, 16, frozen);
    }
}

}  // namespace

TEST_CASE("multifrontal: solves what CHOLMOD solves", "[multifrontal][cholmod][figures]") {
    for (const int n : {16, 33}) checkSheets(n);
}

TEST_CASE("multifrontal: solves what CHOLMOD solves, large", "[multifrontal][cholmod][long]") {
    for (const int n : {64, 128, 256}) checkSheets(n);
}
