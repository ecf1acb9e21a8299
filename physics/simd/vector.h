// Vectors of `FETTLE_LANES` floats. One source file per instruction set includes this file and
// defines FETTLE_LANES before: 4, 8 or 16. Everything is in an unnamed namespace, so that code for
// one instruction set is never linked into another.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace fettle::physics::detail {
namespace {

inline constexpr int width = FETTLE_LANES;
using Wide = float __attribute__((vector_size(width * sizeof(float))));
using WideInt = int32_t __attribute__((vector_size(width * sizeof(int32_t))));
using Quad = float __attribute__((vector_size(4 * sizeof(float))));

inline Wide load(const float* from) {
    Wide v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
inline void store(float* to, Wide v) {
    std::memcpy(to, &v, sizeof v);
}
inline Wide splat(float v) {
    return v - Wide{};
}
inline Wide greater(Wide a, Wide b) {
    return a > b ? a : b;
}
inline Wide lesser(Wide a, Wide b) {
    return a < b ? a : b;
}
inline Wide limit(Wide v, Wide low, Wide high) {
    return v < low ? low : (v > high ? high : v);
}

inline Wide root(Wide v) {
#if FETTLE_LANES == 4 && defined(__aarch64__)
    return reinterpret_cast<Wide>(vsqrtq_f32(reinterpret_cast<float32x4_t>(v)));
#elif FETTLE_LANES == 4 && defined(__wasm_simd128__)
    return __builtin_wasm_sqrt_f32x4(v);
#else
    for (int lane = 0; lane < width; ++lane) v[lane] = std::sqrt(v[lane]);
    return v;
#endif
}
inline WideInt load_int(const int32_t* from) {
    WideInt v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
inline WideInt splat_int(int32_t v) {
    return v - WideInt{};
}
inline WideInt as_int(Wide v) {
    return reinterpret_cast<WideInt>(v);
}
inline Wide as_float(WideInt v) {
    return reinterpret_cast<Wide>(v);
}
/// The lanes in which a comparison is true, one bit each.
inline uint32_t bits(WideInt v) {
#if FETTLE_LANES == 16 && defined(__AVX512DQ__)
    return _mm512_movepi32_mask(reinterpret_cast<__m512i>(v));
#elif FETTLE_LANES == 8 && defined(__AVX2__)
    return uint32_t(_mm256_movemask_ps(reinterpret_cast<__m256>(v)));
#elif FETTLE_LANES == 4 && defined(__SSE2__)
    return uint32_t(_mm_movemask_ps(reinterpret_cast<__m128>(v)));
#elif FETTLE_LANES == 4 && defined(__aarch64__)
    const uint32x4_t signs = reinterpret_cast<uint32x4_t>(v) >> 31;
    return vaddvq_u32(vshlq_u32(signs, int32x4_t{0, 1, 2, 3}));
#elif FETTLE_LANES == 4 && defined(__wasm_simd128__)
    return uint32_t(__builtin_wasm_bitmask_i32x4(v));
#else
    uint32_t set = 0;
    for (int lane = 0; lane < width; ++lane) set |= (uint32_t(v[lane]) >> 31) << lane;
    return set;
#endif
}
inline bool any(WideInt v) {
    return bits(v) != 0;
}

#define FETTLE_SHUFFLE __builtin_shufflevector

/// Transposes each 128 bits by itself: the first elements of four vectors become one vector.
inline void transpose_quads(Wide& a, Wide& b, Wide& c, Wide& d) {
#if FETTLE_LANES == 16
#define FETTLE_LOW 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29
#define FETTLE_HIGH 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31
#define FETTLE_EVEN 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29
#define FETTLE_ODD 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31
#elif FETTLE_LANES == 8
#define FETTLE_LOW 0, 8, 1, 9, 4, 12, 5, 13
#define FETTLE_HIGH 2, 10, 3, 11, 6, 14, 7, 15
#define FETTLE_EVEN 0, 1, 8, 9, 4, 5, 12, 13
#define FETTLE_ODD 2, 3, 10, 11, 6, 7, 14, 15
#else
#define FETTLE_LOW 0, 4, 1, 5
#define FETTLE_HIGH 2, 6, 3, 7
#define FETTLE_EVEN 0, 1, 4, 5
#define FETTLE_ODD 2, 3, 6, 7
#endif
    const Wide ab_low = FETTLE_SHUFFLE(a, b, FETTLE_LOW);
    const Wide ab_high = FETTLE_SHUFFLE(a, b, FETTLE_HIGH);
    const Wide cd_low = FETTLE_SHUFFLE(c, d, FETTLE_LOW);
    const Wide cd_high = FETTLE_SHUFFLE(c, d, FETTLE_HIGH);
    a = FETTLE_SHUFFLE(ab_low, cd_low, FETTLE_EVEN);
    b = FETTLE_SHUFFLE(ab_low, cd_low, FETTLE_ODD);
    c = FETTLE_SHUFFLE(ab_high, cd_high, FETTLE_EVEN);
    d = FETTLE_SHUFFLE(ab_high, cd_high, FETTLE_ODD);
#undef FETTLE_LOW
#undef FETTLE_HIGH
#undef FETTLE_EVEN
#undef FETTLE_ODD
}

/// Four floats of every fourth lane, beginning with lane k; `at(lane)` returns their address.
template <typename At>
inline Wide quads_of(int k, At&& at) {
    Quad part[width / 4];
    for (int i = 0; i < width / 4; ++i) std::memcpy(&part[i], at(4 * i + k), sizeof(Quad));
#if FETTLE_LANES == 16
    const auto low = FETTLE_SHUFFLE(part[0], part[1], 0, 1, 2, 3, 4, 5, 6, 7);
    const auto high = FETTLE_SHUFFLE(part[2], part[3], 0, 1, 2, 3, 4, 5, 6, 7);
    return FETTLE_SHUFFLE(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#elif FETTLE_LANES == 8
    return FETTLE_SHUFFLE(part[0], part[1], 0, 1, 2, 3, 4, 5, 6, 7);
#else
    return part[0];
#endif
}

/// The four floats beginning with 4·i.
template <int i>
inline Quad quad(Wide v) {
    return FETTLE_SHUFFLE(v, v, 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3);
}

/// Four floats of each lane, as four vectors.
struct Columns4 {
    Wide a, b, c, d;
};
template <typename At>
inline Columns4 gather4(At&& at) {
    Columns4 r = {quads_of(0, at), quads_of(1, at), quads_of(2, at), quads_of(3, at)};
    transpose_quads(r.a, r.b, r.c, r.d);
    return r;
}
/// Writes the vectors back, four floats for each lane.
template <typename At>
inline void scatter4(Columns4 r, At&& at) {
    transpose_quads(r.a, r.b, r.c, r.d);
    const Wide rows[4] = {r.a, r.b, r.c, r.d};
    for (int k = 0; k < 4; ++k) {
        const auto put = [&](int lane, Quad part) { std::memcpy(at(lane), &part, sizeof part); };
        put(k, quad<0>(rows[k]));
#if FETTLE_LANES >= 8
        put(4 + k, quad<1>(rows[k]));
#endif
#if FETTLE_LANES == 16
        put(8 + k, quad<2>(rows[k]));
        put(12 + k, quad<3>(rows[k]));
#endif
    }
}

}  // namespace
}  // namespace fettle::physics::detail
