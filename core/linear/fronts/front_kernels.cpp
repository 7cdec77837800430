// Compiled once for each of x86-64-v2, -v3 and -v4, as kernels.cpp is, in the widest lanes of each.
#include "eliminate.h"
#include "extend.h"
#include "solve.h"

#define PLAIT_JOIN2(a, b) a##_##b
#define PLAIT_JOIN(a, b) PLAIT_JOIN2(a, b)

namespace plait {
inline namespace PLAIT_ISA {

template <class T>
inline constexpr FrontTable frontKernelsOf = {eliminate<T>,   eliminateBelow<T>,   complement<T>,
                                              extendPanel<T>, extendComplement<T>, forward<T>,
                                              backward<T>};

}  // namespace PLAIT_ISA

const FrontTable* PLAIT_JOIN(fronts, PLAIT_ISA)() {
#ifdef __AVX512F__
    return &frontKernelsOf<Pack<16>>;
#elif defined(__AVX__)
    return &frontKernelsOf<Pack<8>>;
#else
    return &frontKernelsOf<Pack<4>>;
#endif
}

}  // namespace plait
