// SIMD of eight floats: AVX2 if the file is compiled for it, scalar loops otherwise. Internal to the engine.
// Everything has internal linkage, because the including files are compiled for different instruction sets.
//
// Both versions give the same bits for the same arguments, including NaN (except its payload) and signed
// zeros, so that no result depends on the CPU: every operation rounds once, none is fused or approximate, and
// lanes are combined in a fixed order.
#pragma once

#include <cstdint>
#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace abstand::kernels {
namespace {

#ifdef __AVX2__

struct Float8 {
  __m256 v;
};
struct Int8 {
  __m256i v;
};
/// Each lane has all bits set or none.
struct Mask8 {
  __m256 v;
};

inline Float8 splat(float a) { return {_mm256_set1_ps(a)}; }
inline Int8 splatInt(int a) { return {_mm256_set1_epi32(a)}; }
inline Float8 load(const float* p) { return {_mm256_loadu_ps(p)}; }
inline void store(float* p, Float8 a) { _mm256_storeu_ps(p, a.v); }
inline Float8 operator+(Float8 a, Float8 b) { return {_mm256_add_ps(a.v, b.v)}; }
inline Float8 operator-(Float8 a, Float8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
inline Float8 operator*(Float8 a, Float8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
inline Float8 min(Float8 a, Float8 b) { return {_mm256_min_ps(a.v, b.v)}; }
inline Float8 max(Float8 a, Float8 b) { return {_mm256_max_ps(a.v, b.v)}; }
inline Float8 abs(Float8 a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)}; }
inline Float8 sqrt(Float8 a) { return {_mm256_sqrt_ps(a.v)}; }
inline Mask8 operator<(Float8 a, Float8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
inline Mask8 operator<=(Float8 a, Float8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
inline Mask8 operator&(Mask8 a, Mask8 b) { return {_mm256_and_ps(a.v, b.v)}; }
inline Mask8 isAtLeastZero(Int8 a) {
  return {_mm256_castsi256_ps(_mm256_cmpgt_epi32(a.v, _mm256_set1_epi32(-1)))};
}
inline Mask8 isEqual(Int8 a, Int8 b) { return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(a.v, b.v))}; }
/// Mask of the lanes: bit i is lane i.
inline int bits(Mask8 a) { return _mm256_movemask_ps(a.v); }
inline Float8 select(Mask8 where, Float8 yes, Float8 no) { return {_mm256_blendv_ps(no.v, yes.v, where.v)}; }
inline Int8 truncate(Float8 a) { return {_mm256_cvttps_epi32(a.v)}; }
inline Float8 toFloat(Int8 a) { return {_mm256_cvtepi32_ps(a.v)}; }
inline Int8 operator+(Int8 a, Int8 b) { return {_mm256_add_epi32(a.v, b.v)}; }
inline Int8 operator-(Int8 a, Int8 b) { return {_mm256_sub_epi32(a.v, b.v)}; }
inline Int8 operator*(Int8 a, Int8 b) { return {_mm256_mullo_epi32(a.v, b.v)}; }
inline Int8 operator&(Int8 a, Int8 b) { return {_mm256_and_si256(a.v, b.v)}; }
inline Int8 min(Int8 a, Int8 b) { return {_mm256_min_epi32(a.v, b.v)}; }
template <int kBits>
inline Int8 shiftRight(Int8 a) {
  return {_mm256_srli_epi32(a.v, kBits)};
}
/// 1 where the mask is set, otherwise 0.
inline Int8 count(Mask8 a) { return {_mm256_srli_epi32(_mm256_castps_si256(a.v), 31)}; }
/// table[at] for at in [0, 8).
inline Float8 lookUp(const float* table, Int8 at) {
  return {_mm256_permutevar8x32_ps(_mm256_loadu_ps(table), at.v)};
}
/// base[at] where the mask is set, otherwise 0.
inline Int8 gather(const std::uint32_t* base, Int8 at, Mask8 where) {
  return {_mm256_mask_i32gather_epi32(_mm256_setzero_si256(), reinterpret_cast<const int*>(base), at.v,
                                      _mm256_castps_si256(where.v), 4)};
}
/// base[at] and base[at + 1].
inline void gatherTwo(const std::uint16_t* base, Int8 at, Float8& first, Float8& second) {
  const __m256i two = _mm256_i32gather_epi32(reinterpret_cast<const int*>(base), at.v, 2);
  first = {_mm256_cvtepi32_ps(_mm256_and_si256(two, _mm256_set1_epi32(0xffff)))};
  second = {_mm256_cvtepi32_ps(_mm256_srli_epi32(two, 16))};
}
inline void gatherTwo(const std::int16_t* base, Int8 at, Float8& first, Float8& second) {
  const __m256i two = _mm256_i32gather_epi32(reinterpret_cast<const int*>(base), at.v, 2);
  first = {_mm256_cvtepi32_ps(_mm256_srai_epi32(_mm256_slli_epi32(two, 16), 16))};
  second = {_mm256_cvtepi32_ps(_mm256_srai_epi32(two, 16))};
}
inline float smallestOf(Float8 a) {
  __m128 m = _mm_min_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
  m = _mm_min_ps(m, _mm_movehl_ps(m, m));
  return _mm_cvtss_f32(_mm_min_ss(m, _mm_shuffle_ps(m, m, 1)));
}
/// Sum of the lanes in double.
inline double sumOf(Float8 a) {
  const __m256d s = _mm256_add_pd(_mm256_cvtps_pd(_mm256_castps256_ps128(a.v)),
                                  _mm256_cvtps_pd(_mm256_extractf128_ps(a.v, 1)));
  const __m128d t = _mm_add_pd(_mm256_castpd256_pd128(s), _mm256_extractf128_pd(s, 1));
  return _mm_cvtsd_f64(_mm_add_sd(t, _mm_unpackhi_pd(t, t)));
}

#else

struct Float8 {
  float v[8];
};
struct Int8 {
  std::int32_t v[8];
};
struct Mask8 {
  bool v[8];
};

template <class Out, class Fn>
inline Out forLanes(Fn fn) {
  Out out;
  for (int i = 0; i < 8; ++i) out.v[i] = fn(i);
  return out;
}
inline Float8 splat(float a) {
  return forLanes<Float8>([=](int) { return a; });
}
inline Int8 splatInt(int a) {
  return forLanes<Int8>([=](int) { return a; });
}
inline Float8 load(const float* p) {
  return forLanes<Float8>([=](int i) { return p[i]; });
}
inline void store(float* p, Float8 a) {
  for (int i = 0; i < 8; ++i) p[i] = a.v[i];
}
inline Float8 operator+(Float8 a, Float8 b) {
  return forLanes<Float8>([&](int i) { return a.v[i] + b.v[i]; });
}
inline Float8 operator-(Float8 a, Float8 b) {
  return forLanes<Float8>([&](int i) { return a.v[i] - b.v[i]; });
}
inline Float8 operator*(Float8 a, Float8 b) {
  return forLanes<Float8>([&](int i) { return a.v[i] * b.v[i]; });
}
/// As the AVX2 instruction: b where one of them is NaN.
inline Float8 min(Float8 a, Float8 b) {
  return forLanes<Float8>([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
inline Float8 max(Float8 a, Float8 b) {
  return forLanes<Float8>([&](int i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
}
inline Float8 abs(Float8 a) {
  return forLanes<Float8>([&](int i) { return __builtin_fabsf(a.v[i]); });
}
inline Float8 sqrt(Float8 a) {
  return forLanes<Float8>([&](int i) { return __builtin_sqrtf(a.v[i]); });
}
inline Mask8 operator<(Float8 a, Float8 b) {
  return forLanes<Mask8>([&](int i) { return a.v[i] < b.v[i]; });
}
inline Mask8 operator<=(Float8 a, Float8 b) {
  return forLanes<Mask8>([&](int i) { return a.v[i] <= b.v[i]; });
}
inline Mask8 operator&(Mask8 a, Mask8 b) {
  return forLanes<Mask8>([&](int i) { return a.v[i] && b.v[i]; });
}
inline Mask8 isAtLeastZero(Int8 a) {
  return forLanes<Mask8>([&](int i) { return a.v[i] >= 0; });
}
inline Mask8 isEqual(Int8 a, Int8 b) {
  return forLanes<Mask8>([&](int i) { return a.v[i] == b.v[i]; });
}
inline int bits(Mask8 a) {
  int out = 0;
  for (int i = 0; i < 8; ++i) out |= a.v[i] << i;
  return out;
}
inline Float8 select(Mask8 where, Float8 yes, Float8 no) {
  return forLanes<Float8>([&](int i) { return where.v[i] ? yes.v[i] : no.v[i]; });
}
/// Defined for values that fit into an int; others give the minimum int, as the AVX2 instruction does.
inline Int8 truncate(Float8 a) {
  return forLanes<Int8>([&](int i) {
    return a.v[i] > -2147483648.0f && a.v[i] < 2147483648.0f ? static_cast<std::int32_t>(a.v[i]) : INT32_MIN;
  });
}
inline Float8 toFloat(Int8 a) {
  return forLanes<Float8>([&](int i) { return static_cast<float>(a.v[i]); });
}
inline Int8 operator+(Int8 a, Int8 b) {
  return forLanes<Int8>([&](int i) { return a.v[i] + b.v[i]; });
}
inline Int8 operator-(Int8 a, Int8 b) {
  return forLanes<Int8>([&](int i) { return a.v[i] - b.v[i]; });
}
inline Int8 operator*(Int8 a, Int8 b) {
  return forLanes<Int8>([&](int i) { return a.v[i] * b.v[i]; });
}
inline Int8 operator&(Int8 a, Int8 b) {
  return forLanes<Int8>([&](int i) { return a.v[i] & b.v[i]; });
}
inline Int8 min(Int8 a, Int8 b) {
  return forLanes<Int8>([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
template <int kBits>
inline Int8 shiftRight(Int8 a) {
  return forLanes<Int8>(
      [&](int i) { return static_cast<std::int32_t>(static_cast<std::uint32_t>(a.v[i]) >> kBits); });
}
inline Int8 count(Mask8 a) {
  return forLanes<Int8>([&](int i) { return a.v[i] ? 1 : 0; });
}
inline Float8 lookUp(const float* table, Int8 at) {
  return forLanes<Float8>([&](int i) { return table[at.v[i]]; });
}
inline Int8 gather(const std::uint32_t* base, Int8 at, Mask8 where) {
  return forLanes<Int8>([&](int i) { return where.v[i] ? static_cast<std::int32_t>(base[at.v[i]]) : 0; });
}
template <class Value>
inline void gatherTwo(const Value* base, Int8 at, Float8& first, Float8& second) {
  for (int i = 0; i < 8; ++i) {
    first.v[i] = static_cast<float>(base[at.v[i]]);
    second.v[i] = static_cast<float>(base[at.v[i] + 1]);
  }
}
/// Smallest lane; in the order of the AVX2 version, which decides between zeros and about NaN.
inline float smallestOf(Float8 a) {
  const auto lower = [](float x, float y) { return x < y ? x : y; };
  float m[4];
  for (int i = 0; i < 4; ++i) m[i] = lower(a.v[i], a.v[i + 4]);
  return lower(lower(m[0], m[2]), lower(m[1], m[3]));
}
/// In the order of the AVX2 version.
inline double sumOf(Float8 a) {
  double s[4];
  for (int i = 0; i < 4; ++i) s[i] = static_cast<double>(a.v[i]) + static_cast<double>(a.v[i + 4]);
  return (s[0] + s[2]) + (s[1] + s[3]);
}

#endif

/// a b + c, rounded twice: a fused operation would give other bits than CPUs without it.
inline Float8 multiplyAdd(Float8 a, Float8 b, Float8 c) { return a * b + c; }

}  // namespace
}  // namespace abstand::kernels
