// Compiled once for each of x86-64-v2, -v3 and -v4, with PLAIT_ISA naming the copy. A level has
// every width that it has registers for, so that tests can tell width from instruction set.
#include "../constraints/kinds.h"
#include "kernel_loop.h"

#define PLAIT_JOIN2(a, b) a##_##b
#define PLAIT_JOIN(a, b) PLAIT_JOIN2(a, b)

namespace plait {
namespace {

template <class T, class... Kind>
const KernelTable<Scalar<T>>* tables(KindList<Kind...>) {
    static constexpr KernelTable<Scalar<T>> table[] = {kernelsOf<Kind, T>...};
    return table;
}

}  // namespace

// Null for a width that this copy does not have.
const KernelTable<float>* PLAIT_JOIN(floatKernels, PLAIT_ISA)(int lanes) {
    if (lanes == 4) return tables<Pack<4>>(Kinds{});
#ifdef __AVX512F__
    if (lanes == 16) return tables<Pack<16>>(Kinds{});
#endif
#ifdef __AVX__
    if (lanes == 8) return tables<Pack<8>>(Kinds{});
#else
    if (lanes == 1) return tables<float>(Kinds{});
#endif
    return nullptr;
}

const KernelTable<double>* PLAIT_JOIN(doubleKernels, PLAIT_ISA)() {
    return tables<double>(Kinds{});
}

}  // namespace plait
