// Compiled once for each of x86-64-v2, -v3 and -v4, as kernels.cpp is.
#include "strand_loop.h"

#define PLAIT_JOIN2(a, b) a##_##b
#define PLAIT_JOIN(a, b) PLAIT_JOIN2(a, b)

namespace plait {

// Null for a width that this copy does not have.
const StrandTable<float>* PLAIT_JOIN(floatStrands, PLAIT_ISA)(int lanes) {
    if (lanes == 4) return &strandKernelsOf<Pack<4>>;
#ifdef __AVX512F__
    if (lanes == 16) return &strandKernelsOf<Pack<16>>;
#endif
#ifdef __AVX__
    if (lanes == 8) return &strandKernelsOf<Pack<8>>;
#else
    if (lanes == 1) return &strandKernelsOf<float>;
#endif
    return nullptr;
}

const StrandTable<double>* PLAIT_JOIN(doubleStrands, PLAIT_ISA)() {
    return &strandKernelsOf<double>;
}

}  // namespace plait
