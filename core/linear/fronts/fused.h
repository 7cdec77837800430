// a * b + c rounded once, in every lane and on every processor: where it is one instruction it
// doubles the speed of products of matrices, and where it is not it is imitated to the bit.
#pragma once

#include "../../numbers/lanes.h"

namespace plait {
inline namespace PLAIT_ISA {

#ifndef __FMA__
// The product of two floats is exact in double. The sum is rounded to odd, which keeps it from
// being rounded twice (Boldo, Melquiond, "Emulation of FMA and correctly rounded sums", 2008).
inline __m128d fusedInDouble(__m128d a, __m128d b, __m128d c) {
    typedef double D __attribute__((vector_size(16)));
    typedef long long L __attribute__((vector_size(16)));
    const D p = D(a) * D(b), q = D(c), sum = p + q;
    const D virtualQ = sum - p;
    const D error = (p - (sum - virtualQ)) + (q - virtualQ);
    const L bits = L(sum);
    const L inexact = (error < 0) | (error > 0);
    const L away = ((L(error) ^ bits) >> 63) | 1;  // -1 where the error is towards zero
    return __m128d(D(bits + (away & inexact & ((bits & 1) - 1))));
}

inline Pack<4> fused(Pack<4> a, Pack<4> b, Pack<4> c) {
    const auto high = [](Pack<4> p) { return _mm_cvtps_pd(_mm_movehl_ps(p.v, p.v)); };
    const __m128d low = fusedInDouble(_mm_cvtps_pd(a.v), _mm_cvtps_pd(b.v), _mm_cvtps_pd(c.v));
    return Pack<4>(Pack<4>::V(
        _mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(fusedInDouble(high(a), high(b), high(c))))));
}

inline Pack<4> fusedLess(Pack<4> a, Pack<4> b, Pack<4> c) { return fused(-a, b, c); }
#else
inline Pack<8> fused(Pack<8> a, Pack<8> b, Pack<8> c) {
    return Pack<8>(Pack<8>::V(_mm256_fmadd_ps(a.v, b.v, c.v)));
}
// c - a * b.
inline Pack<8> fusedLess(Pack<8> a, Pack<8> b, Pack<8> c) {
    return Pack<8>(Pack<8>::V(_mm256_fnmadd_ps(a.v, b.v, c.v)));
}
#endif

#ifdef __AVX512F__
inline Pack<16> fused(Pack<16> a, Pack<16> b, Pack<16> c) {
    return Pack<16>(Pack<16>::V(_mm512_fmadd_ps(a.v, b.v, c.v)));
}
inline Pack<16> fusedLess(Pack<16> a, Pack<16> b, Pack<16> c) {
    return Pack<16>(Pack<16>::V(_mm512_fnmadd_ps(a.v, b.v, c.v)));
}
#endif

}  // namespace PLAIT_ISA
}  // namespace plait
