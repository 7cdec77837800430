// Compiled once for each of x86-64-v2, -v3 and -v4, as kernels/kernels.cpp is.
#include "air_loop.h"
#include "carried_loop.h"

#define PLAIT_JOIN2(a, b) a##_##b
#define PLAIT_JOIN(a, b) PLAIT_JOIN2(a, b)

namespace plait {
inline namespace PLAIT_ISA {

template <class T>
inline constexpr AirTable<Scalar<T>> airKernelsOf = {
    {writeSides<T, 2>, writeSides<T, 3>},
    {{writeImpulses<T, 2, false>, writeImpulses<T, 3, false>},
     {writeImpulses<T, 2, true>, writeImpulses<T, 3, true>}},
    writeVelocities<T>,
    writeWays<T>,
    writeSlopes<T>,
    writeCarried<T>,
    writeNormals<T>,
    writeRight<T>,
    writeExchanged<T>};

}  // namespace PLAIT_ISA

// Null for a width that this copy does not have.
const AirTable<float>* PLAIT_JOIN(floatAir, PLAIT_ISA)(int lanes) {
    if (lanes == 4) return &airKernelsOf<Pack<4>>;
#ifdef __AVX512F__
    if (lanes == 16) return &airKernelsOf<Pack<16>>;
#endif
#ifdef __AVX__
    if (lanes == 8) return &airKernelsOf<Pack<8>>;
#else
    if (lanes == 1) return &airKernelsOf<float>;
#endif
    return nullptr;
}

const AirTable<double>* PLAIT_JOIN(doubleAir, PLAIT_ISA)() { return &airKernelsOf<double>; }

}  // namespace plait
