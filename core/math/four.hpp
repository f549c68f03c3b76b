// Four floats as a SIMD vector, for loops that the compiler does not vectorise by itself (Eigen's select(),
// for example, works lane by lane).
#pragma once

#include <Eigen/Core>
#include <cmath>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace abstand {

/// Arithmetic and comparisons are per lane, also with a scalar float; `where ? a : b` selects per lane.
using Four [[gnu::vector_size(16)]] = float;
using FourInts [[gnu::vector_size(16)]] = int;

inline Four splat(float a) { return Four{a, a, a, a}; }
inline Four load(const float* p) { return Four{p[0], p[1], p[2], p[3]}; }
inline Four load(const Eigen::Array4f& a) { return load(a.data()); }
inline void storeFour(Four a, float* p) {
  for (int i = 0; i < 4; ++i) p[i] = a[i];
}
/// Per-lane minimum; b where one of them is NaN.
inline Four min(Four a, Four b) { return a < b ? a : b; }
inline Four max(Four a, Four b) { return a > b ? a : b; }
inline Four abs(Four a) { return max(a, -a); }
inline Four sqrt(Four a) {
#ifdef __SSE2__
  return _mm_sqrt_ps(a);
#else
  return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}
/// Mask of the lanes: bit i is lane i.
inline int bits(FourInts where) {
#ifdef __SSE2__
  return _mm_movemask_ps(reinterpret_cast<__m128>(where));
#else
  return (where[0] & 1) | (where[1] & 2) | (where[2] & 4) | (where[3] & 8);
#endif
}
inline float sumOf(Four a) { return (a[0] + a[2]) + (a[1] + a[3]); }
inline float smallestOf(Four a) {
  const Four m = min(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
  return m[1] < m[0] ? m[1] : m[0];
}
inline float largestOf(Four a) { return -smallestOf(-a); }

/// Transposes the 4x4 matrix whose rows are a, b, c, d.
inline void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5),
             AB = __builtin_shufflevector(a, b, 2, 6, 3, 7), CD = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  a = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
  c = __builtin_shufflevector(AB, CD, 0, 1, 4, 5);
  d = __builtin_shufflevector(AB, CD, 2, 3, 6, 7);
}

}  // namespace abstand
