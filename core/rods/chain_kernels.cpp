// Compiled once for each of x86-64-v2, -v3 and -v4, as kernels.cpp is.
#include "chain_kernels.h"

#include "chain_loop.h"
#include "chain_solve.h"

#define PLAIT_JOIN2(a, b) a##_##b
#define PLAIT_JOIN(a, b) PLAIT_JOIN2(a, b)

namespace plait {
namespace {

template <class T, class... Kind>
const ChainRowsTable* tables(KindList<Kind...>) {
    static constexpr ChainRowsTable table[] = {chainRowsOf<Kind, T>...};
    return table;
}

template <class Copies>
auto byLanes(int lanes, const Copies& copies) -> decltype(copies(double{})) {
    if (lanes == 4) return copies(Pack<2, double>{});
#ifdef __AVX512F__
    if (lanes == 16) return copies(Pack<8, double>{});
#endif
#ifdef __AVX__
    if (lanes == 8) return copies(Pack<4, double>{});
#else
    if (lanes == 1) return copies(double{});
#endif
    return nullptr;
}

template <class Real>
const ChainTable<Real>* tableOf(int lanes) {
    return byLanes(lanes, [](auto t) { return &chainTableOf<decltype(t), Real>; });
}

}  // namespace

// Null for a width that this copy does not have.
const ChainTable<float>* PLAIT_JOIN(floatChains, PLAIT_ISA)(int lanes) {
    return tableOf<float>(lanes);
}
const ChainTable<double>* PLAIT_JOIN(doubleChains, PLAIT_ISA)(int lanes) {
    return tableOf<double>(lanes);
}
const ChainRowsTable* PLAIT_JOIN(chainRows, PLAIT_ISA)(int lanes) {
    return byLanes(lanes, [](auto t) { return tables<decltype(t)>(ChainKinds{}); });
}

}  // namespace plait
