#include "copies.h"
#include "kernels.h"

namespace plait {

ByLanes<KernelTable<float>> floatKernels_v2, floatKernels_v3, floatKernels_v4;
Single<KernelTable<double>> doubleKernels_v2, doubleKernels_v3, doubleKernels_v4;

namespace {

bool runs(Isa isa) {
    __builtin_cpu_init();
    const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
                    __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
    const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
    return isa == Isa::v2 || (isa == Isa::v3 && v3) || (isa == Isa::v4 && v4);
}

}  // namespace

KernelChoice bestKernels() {
    if (runs(Isa::v4))
        return {Isa::v4, 8};  // 16 are slower: divisions take as long, transposes longer
    return runs(Isa::v3) ? KernelChoice{Isa::v3, 8} : KernelChoice{Isa::v2, 4};
}

bool available(KernelChoice choice) {
    if (!runs(choice.isa)) return false;
    switch (choice.isa) {
        case Isa::v2:
            return floatKernels_v2(choice.lanes);
        case Isa::v3:
            return floatKernels_v3(choice.lanes);
        default:
            return floatKernels_v4(choice.lanes);
    }
}

const KernelTable<float>& floatKernels(KernelChoice choice, int kind) {
    return copyFor(choice, floatKernels_v2, floatKernels_v3, floatKernels_v4)(choice.lanes)[kind];
}

const KernelTable<double>& doubleKernels(KernelChoice choice, int kind) {
    return copyFor(choice, doubleKernels_v2, doubleKernels_v3, doubleKernels_v4)()[kind];
}

}  // namespace plait
