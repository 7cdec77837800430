#include "air_kernels.h"

#include "../kernels/copies.h"

namespace plait {

ByLanes<AirTable<float>> floatAir_v2, floatAir_v3, floatAir_v4;
Single<AirTable<double>> doubleAir_v2, doubleAir_v3, doubleAir_v4;

template <>
const AirTable<float>& airKernels<float>(KernelChoice choice) {
    return *copyFor(choice, floatAir_v2, floatAir_v3, floatAir_v4)(choice.lanes);
}

template <>
const AirTable<double>& airKernels<double>(KernelChoice choice) {
    return *copyFor(choice, doubleAir_v2, doubleAir_v3, doubleAir_v4)();
}

}  // namespace plait
