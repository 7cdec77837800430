#include "../kernels/copies.h"
#include "chain_kernels.h"

namespace plait {

ByLanes<ChainTable<float>> floatChains_v2, floatChains_v3, floatChains_v4;
ByLanes<ChainTable<double>> doubleChains_v2, doubleChains_v3, doubleChains_v4;
ByLanes<ChainRowsTable> chainRows_v2, chainRows_v3, chainRows_v4;

template <>
const ChainTable<float>& chainKernels<float>(KernelChoice choice) {
    return *copyFor(choice, floatChains_v2, floatChains_v3, floatChains_v4)(choice.lanes);
}

template <>
const ChainTable<double>& chainKernels<double>(KernelChoice choice) {
    return *copyFor(choice, doubleChains_v2, doubleChains_v3, doubleChains_v4)(choice.lanes);
}

const ChainRowsTable& chainRowsKernels(KernelChoice choice, int kind) {
    return copyFor(choice, chainRows_v2, chainRows_v3, chainRows_v4)(choice.lanes)[kind];
}

}  // namespace plait
