#include "strand_kernels.h"

#include "../../kernels/copies.h"

namespace plait {

ByLanes<StrandTable<float>> floatStrands_v2, floatStrands_v3, floatStrands_v4;
Single<StrandTable<double>> doubleStrands_v2, doubleStrands_v3, doubleStrands_v4;

template <>
const StrandTable<float>& strandKernels<float>(KernelChoice choice) {
    return *copyFor(choice, floatStrands_v2, floatStrands_v3, floatStrands_v4)(choice.lanes);
}

template <>
const StrandTable<double>& strandKernels<double>(KernelChoice choice) {
    return *copyFor(choice, doubleStrands_v2, doubleStrands_v3, doubleStrands_v4)();
}

}  // namespace plait
