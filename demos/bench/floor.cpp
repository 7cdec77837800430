#include "floor.h"

#include <immintrin.h>

#define AVX2 __attribute__((target("avx2")))

namespace plait {
namespace {

struct Eight {
    __m256 x, y, z, w;
};

// Rows l and l + 4 side by side, then a 4x4 transpose in each half.
AVX2 inline Eight transposed(__m256 r0, __m256 r1, __m256 r2, __m256 r3) {
    const __m256 a = _mm256_unpacklo_ps(r0, r1), b = _mm256_unpackhi_ps(r0, r1);
    const __m256 c = _mm256_unpacklo_ps(r2, r3), d = _mm256_unpackhi_ps(r2, r3);
    return {_mm256_shuffle_ps(a, c, 0x44), _mm256_shuffle_ps(a, c, 0xee),
            _mm256_shuffle_ps(b, d, 0x44), _mm256_shuffle_ps(b, d, 0xee)};
}

AVX2 inline void addTo(Particle<float>* p, const int* ids, const Eight& move) {
    const Eight r = transposed(move.x, move.y, move.z, move.w);
    const __m256 rows[4] = {r.x, r.y, r.z, r.w};
    for (int l = 0; l < 8; ++l) {
        float* d = &p[ids[l]].d.x;
        const __m128 row =
            l < 4 ? _mm256_castps256_ps128(rows[l]) : _mm256_extractf128_ps(rows[l - 4], 1);
        _mm_store_ps(d, _mm_add_ps(_mm_load_ps(d), row));
    }
}

AVX2 inline void eightStretches(Particle<float>* p, FloorColor::Block& block, int lane,
                                __m256 inverseH2) {
    const int* ia = block.ids[0] + lane;
    const int* ib = block.ids[1] + lane;
    const __m128 keep = _mm_castsi128_ps(_mm_setr_epi32(-1, -1, -1, 0));
    __m128 r[8], heavy[8];
    for (int l = 0; l < 8; ++l) {
        const float* a = &p[ia[l]].x.x;
        const float* b = &p[ib[l]].x.x;
        heavy[l] = _mm_load_ps(a);
        r[l] = _mm_add_ps(_mm_sub_ps(_mm_load_ps(b), _mm_and_ps(heavy[l], keep)),
                          _mm_sub_ps(_mm_load_ps(b + 4), _mm_load_ps(a + 4)));
    }
    const auto pair = [](__m128 low, __m128 high) AVX2 { return _mm256_set_m128(high, low); };
    const Eight d =
        transposed(pair(r[0], r[4]), pair(r[1], r[5]), pair(r[2], r[6]), pair(r[3], r[7]));
    const __m256 wa = transposed(pair(heavy[0], heavy[4]), pair(heavy[1], heavy[5]),
                                 pair(heavy[2], heavy[6]), pair(heavy[3], heavy[7]))
                          .w;
    const __m256 zero = _mm256_setzero_ps(), one = _mm256_set1_ps(1), tiny = _mm256_set1_ps(1e-30F);
    const auto product = [](const Eight& a, const Eight& b) AVX2 {
        return _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(a.x, b.x), _mm256_mul_ps(a.y, b.y)),
                             _mm256_mul_ps(a.z, b.z));
    };
    const auto scaled = [](__m256 s, const Eight& a) AVX2 {
        return Eight{_mm256_mul_ps(s, a.x), _mm256_mul_ps(s, a.y), _mm256_mul_ps(s, a.z),
                     _mm256_setzero_ps()};
    };
    const __m256 l = _mm256_sqrt_ps(product(d, d)), safe = _mm256_cmp_ps(l, tiny, _CMP_GT_OQ);
    const __m256 inverse = _mm256_div_ps(_mm256_and_ps(safe, one), _mm256_blendv_ps(one, l, safe));
    const Eight gb = scaled(inverse, d);
    const Eight ga{_mm256_sub_ps(zero, gb.x), _mm256_sub_ps(zero, gb.y), _mm256_sub_ps(zero, gb.z),
                   zero};
    const Eight ma = scaled(wa, ga), mb = scaled(d.w, gb);
    const __m256 weight = _mm256_add_ps(product(ga, ma), product(gb, mb));

    const __m256 old = _mm256_load_ps(block.lambda + lane);
    const __m256 s = _mm256_sub_ps(_mm256_sub_ps(l, _mm256_load_ps(block.rows[0] + lane)),
                                   _mm256_mul_ps(weight, old));
    const __m256 compliance =
        _mm256_blendv_ps(_mm256_load_ps(block.rows[2] + lane), _mm256_load_ps(block.rows[1] + lane),
                         _mm256_cmp_ps(s, zero, _CMP_GT_OQ));
    const __m256 acts = _mm256_cmp_ps(compliance, _mm256_set1_ps(1e30F), _CMP_LT_OQ);
    const __m256 below = _mm256_add_ps(weight, _mm256_mul_ps(compliance, inverseH2));
    const __m256 fine = _mm256_cmp_ps(below, tiny, _CMP_GT_OQ);
    const __m256 quotient = _mm256_div_ps(s, _mm256_blendv_ps(one, below, fine));
    const __m256 target = _mm256_and_ps(_mm256_and_ps(acts, fine), _mm256_sub_ps(zero, quotient));
    const __m256 change = _mm256_sub_ps(target, old);
    _mm256_store_ps(block.lambda + lane, _mm256_add_ps(old, change));
    addTo(p, ia, scaled(change, ma));
    addTo(p, ib, scaled(change, mb));
}

}  // namespace

bool floorAvailable() { return __builtin_cpu_supports("avx2"); }

AVX2 void floorStretch(Particle<float>* particles, FloorColor::Block* blocks, float inverseH2,
                       int begin, int end) {
    for (int b = begin; b < end; ++b)
        for (const int lane : {0, 8})
            eightStretches(particles, blocks[b], lane, _mm256_set1_ps(inverseH2));
}

void floorPredict(Particle<float>* particles, Padded<float>* velocity, Padded<float>* before,
                  float h, float gravity, int begin, int end) {
    const __m128 push = _mm_setr_ps(0, h * gravity, 0, 0);
    for (int i = begin; i < end; ++i) {
        float* d = &particles[i].d.x;
        float* v = &velocity[i].v.x;
        const float moves = particles[i].w > 0 ? 1.0F : 0.0F;
        const __m128 free = _mm_set1_ps(moves), old = _mm_load_ps(d);
        const __m128 fast = _mm_add_ps(_mm_load_ps(v), _mm_mul_ps(free, push));
        _mm_store_ps(v, fast);
        _mm_store_ps(&before[i].v.x, old);
        _mm_store_ps(d, _mm_add_ps(old, _mm_mul_ps(_mm_set1_ps(h * moves), fast)));
    }
}

void floorUpdate(Particle<float>* particles, Padded<float>* velocity, const Padded<float>* before,
                 float h, int begin, int end) {
    const __m128 step = _mm_set1_ps(h);
    const __m128 keep = _mm_castsi128_ps(_mm_setr_epi32(-1, -1, -1, 0));
    for (int i = begin; i < end; ++i) {
        float* p = &particles[i].x.x;
        const __m128 record = _mm_load_ps(p), d = _mm_load_ps(p + 4);
        const __m128 x = _mm_and_ps(record, keep);
        _mm_store_ps(&velocity[i].v.x,
                     _mm_div_ps(_mm_sub_ps(d, _mm_load_ps(&before[i].v.x)), step));
        const __m128 sum = _mm_add_ps(x, d), part = _mm_sub_ps(sum, x);
        _mm_store_ps(p, _mm_blend_ps(sum, record, 8));
        _mm_store_ps(p + 4, _mm_add_ps(_mm_sub_ps(x, _mm_sub_ps(sum, part)), _mm_sub_ps(d, part)));
    }
}

}  // namespace plait
