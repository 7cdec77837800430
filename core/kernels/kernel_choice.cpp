#include "../forces/air_kernels.h"
#include "../linear/fronts/front_kernels.h"
#include "../sheets/strands/strand_kernels.h"
#include "kernels.h"

#include <stdexcept>
#include <string>

namespace plait {

// The three copies of each; those in lanes have none for some widths.
template <class Table>
using ByLanes = const Table*(int lanes);
template <class Table>
using Single = const Table*();
ByLanes<KernelTable<float>> floatKernels_v2, floatKernels_v3, floatKernels_v4;
Single<KernelTable<double>> doubleKernels_v2, doubleKernels_v3, doubleKernels_v4;
ByLanes<AirTable<float>> floatAir_v2, floatAir_v3, floatAir_v4;
Single<AirTable<double>> doubleAir_v2, doubleAir_v3, doubleAir_v4;
ByLanes<StrandTable<float>> floatStrands_v2, floatStrands_v3, floatStrands_v4;
Single<StrandTable<double>> doubleStrands_v2, doubleStrands_v3, doubleStrands_v4;
Single<FrontTable> fronts_v2, fronts_v3, fronts_v4;

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

template <class Copy>
Copy* copyFor(Isa isa, Copy* v2, Copy* v3, Copy* v4) {
    return isa == Isa::v2 ? v2 : isa == Isa::v3 ? v3 : v4;
}

template <class Copy>
Copy* chosen(KernelChoice choice, Copy* v2, Copy* v3, Copy* v4) {
    if (!available(choice))
        throw std::invalid_argument("no kernels for x86-64-v" +
                                    std::to_string(static_cast<int>(choice.isa) + 2) + " with " +
                                    std::to_string(choice.lanes) + " lanes on this machine");
    return copyFor(choice.isa, v2, v3, v4);
}

}  // namespace

KernelChoice bestKernels() {
    if (runs(Isa::v4))
        return {Isa::v4, 8};  // 16 are slower: divisions take as long, transposes longer
    return runs(Isa::v3) ? KernelChoice{Isa::v3, 8} : KernelChoice{Isa::v2, 4};
}

bool available(KernelChoice choice) {
    return runs(choice.isa) &&
           copyFor(choice.isa, floatKernels_v2, floatKernels_v3, floatKernels_v4)(choice.lanes);
}

const KernelTable<float>& floatKernels(KernelChoice choice, int kind) {
    return chosen(choice, floatKernels_v2, floatKernels_v3, floatKernels_v4)(choice.lanes)[kind];
}

const KernelTable<double>& doubleKernels(KernelChoice choice, int kind) {
    return chosen(choice, doubleKernels_v2, doubleKernels_v3, doubleKernels_v4)()[kind];
}

template <>
const AirTable<float>& airKernels<float>(KernelChoice choice) {
    return *chosen(choice, floatAir_v2, floatAir_v3, floatAir_v4)(choice.lanes);
}

template <>
const AirTable<double>& airKernels<double>(KernelChoice choice) {
    return *chosen(choice, doubleAir_v2, doubleAir_v3, doubleAir_v4)();
}

template <>
const StrandTable<float>& strandKernels<float>(KernelChoice choice) {
    return *chosen(choice, floatStrands_v2, floatStrands_v3, floatStrands_v4)(choice.lanes);
}

template <>
const StrandTable<double>& strandKernels<double>(KernelChoice choice) {
    return *chosen(choice, doubleStrands_v2, doubleStrands_v3, doubleStrands_v4)();
}

const FrontTable& frontKernels(KernelChoice choice) {
    return *chosen(choice, fronts_v2, fronts_v3, fronts_v4)();
}

}  // namespace plait
