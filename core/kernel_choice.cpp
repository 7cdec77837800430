#include "forces/air_kernels.h"
#include "kernels.h"
#include "strand_kernels.h"

#include <stdexcept>
#include <string>

namespace plait {

const KernelTable<float>* floatKernels_v2(int lanes);
const KernelTable<float>* floatKernels_v3(int lanes);
const KernelTable<float>* floatKernels_v4(int lanes);
const KernelTable<double>* doubleKernels_v2();
const KernelTable<double>* doubleKernels_v3();
const KernelTable<double>* doubleKernels_v4();
const AirTable<float>* floatAir_v2(int lanes);
const AirTable<float>* floatAir_v3(int lanes);
const AirTable<float>* floatAir_v4(int lanes);
const AirTable<double>* doubleAir_v2();
const AirTable<double>* doubleAir_v3();
const AirTable<double>* doubleAir_v4();
const StrandTable<float>* floatStrands_v2(int lanes);
const StrandTable<float>* floatStrands_v3(int lanes);
const StrandTable<float>* floatStrands_v4(int lanes);
const StrandTable<double>* doubleStrands_v2();
const StrandTable<double>* doubleStrands_v3();
const StrandTable<double>* doubleStrands_v4();

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

const KernelTable<float>* find(KernelChoice choice) {
    if (!runs(choice.isa)) return nullptr;
    if (choice.isa == Isa::v2) return floatKernels_v2(choice.lanes);
    return choice.isa == Isa::v3 ? floatKernels_v3(choice.lanes) : floatKernels_v4(choice.lanes);
}

[[noreturn]] void refuse(KernelChoice choice) {
    throw std::invalid_argument("no kernels for x86-64-v" +
                                std::to_string(static_cast<int>(choice.isa) + 2) + " with " +
                                std::to_string(choice.lanes) + " lanes on this machine");
}

}  // namespace

KernelChoice bestKernels() {
    if (runs(Isa::v4))
        return {Isa::v4, 8};  // 16 are slower: divisions take as long, transposes longer
    return runs(Isa::v3) ? KernelChoice{Isa::v3, 8} : KernelChoice{Isa::v2, 4};
}

bool available(KernelChoice choice) { return find(choice) != nullptr; }

const KernelTable<float>& floatKernels(KernelChoice choice, int kind) {
    const KernelTable<float>* tables = find(choice);
    if (!tables) refuse(choice);
    return tables[kind];
}

const KernelTable<double>& doubleKernels(KernelChoice choice, int kind) {
    if (!available(choice)) refuse(choice);
    const KernelTable<double>* tables = choice.isa == Isa::v2   ? doubleKernels_v2()
                                        : choice.isa == Isa::v3 ? doubleKernels_v3()
                                                                : doubleKernels_v4();
    return tables[kind];
}

template <>
const AirTable<float>& airKernels<float>(KernelChoice choice) {
    if (!available(choice)) refuse(choice);
    if (choice.isa == Isa::v2) return *floatAir_v2(choice.lanes);
    return choice.isa == Isa::v3 ? *floatAir_v3(choice.lanes) : *floatAir_v4(choice.lanes);
}

template <>
const AirTable<double>& airKernels<double>(KernelChoice choice) {
    if (!available(choice)) refuse(choice);
    if (choice.isa == Isa::v2) return *doubleAir_v2();
    return choice.isa == Isa::v3 ? *doubleAir_v3() : *doubleAir_v4();
}

template <>
const StrandTable<float>& strandKernels<float>(KernelChoice choice) {
    if (!available(choice)) refuse(choice);
    if (choice.isa == Isa::v2) return *floatStrands_v2(choice.lanes);
    return choice.isa == Isa::v3 ? *floatStrands_v3(choice.lanes) : *floatStrands_v4(choice.lanes);
}

template <>
const StrandTable<double>& strandKernels<double>(KernelChoice choice) {
    if (!available(choice)) refuse(choice);
    if (choice.isa == Isa::v2) return *doubleStrands_v2();
    return choice.isa == Isa::v3 ? *doubleStrands_v3() : *doubleStrands_v4();
}

}  // namespace plait
