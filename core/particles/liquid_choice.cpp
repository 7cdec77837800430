#include "../kernels/copies.h"
#include "liquid_kernels.h"

namespace plait {

Single<LiquidTable<float>> floatLiquid_v2, floatLiquid_v3, floatLiquid_v4;
Single<LiquidTable<double>> doubleLiquid_v2, doubleLiquid_v3, doubleLiquid_v4;

template <>
const LiquidTable<float>& liquidKernels<float>(KernelChoice choice) {
    return *copyFor(choice, floatLiquid_v2, floatLiquid_v3, floatLiquid_v4)();
}

template <>
const LiquidTable<double>& liquidKernels<double>(KernelChoice choice) {
    return *copyFor(choice, doubleLiquid_v2, doubleLiquid_v3, doubleLiquid_v4)();
}

}  // namespace plait
