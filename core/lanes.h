#pragma once

#include <bit>
#include <cmath>
#include <experimental/simd>

namespace ringlet {

/// Strands are processed side by side, one per lane of a pack: the production scalar of every
/// kernel. A pack is one register of the machine (8 doubles with AVX-512, 4 with AVX2, 2 with
/// SSE2); wider ones of several registers spill, and take twice the time an element.
using Pack = std::experimental::native_simd<double>;
inline constexpr int lane_count = static_cast<int>(Pack::size());
using Mask = Pack::mask_type;

// Kernels are templates over their scalar (double, Pack, traced numbers) and call these functions
// unqualified: doubles find them here, packs and traced numbers by argument-dependent lookup.
using std::abs;
using std::copysign;
using std::max;
using std::min;
using std::sqrt;

/// condition ? a : b, for every scalar.
inline double select(bool condition, double a, double b) { return condition ? a : b; }
[[gnu::always_inline]] inline Pack select(const Mask& condition, const Pack& a, const Pack& b) {
#if defined(__clang__) && defined(__AVX512F__)
  // libstdc++ 12 with clang takes one lane's condition for all of them (_S_blend_avx512).
  return Pack(_mm512_mask_blend_pd(std::bit_cast<__mmask8>(condition), static_cast<__m512d>(b),
                                   static_cast<__m512d>(a)));
#else
  Pack result = b;
  std::experimental::where(condition, result) = a;
  return result;
#endif
}

/// 1 / sqrt(a) for a > 0, neither tiny nor huge enough to be denormal; to about two units in the
/// last place.
inline double inverse_sqrt(double a) { return 1 / std::sqrt(a); }
[[gnu::always_inline]] inline Pack inverse_sqrt(const Pack& a) {
#if defined(__AVX512F__)
  // The processor's estimate has 14 bits, which each step of Newton's method doubles: faster by far
  // than its square root and its division, which it does not pipeline.
  const __m512d value = static_cast<__m512d>(a);
  Pack root(_mm512_rsqrt14_pd(value));
  const Pack half = 0.5 * a;
  root += root * (0.5 - half * root * root);
  root += root * (0.5 - half * root * root);
  return root;
#else
  return 1 / sqrt(a);
#endif
}

inline bool any(bool condition) { return condition; }
inline bool any(const Mask& condition) { return std::experimental::any_of(condition); }

/// The sum over the lanes in lane order, the same on every machine.
inline double sum_lanes(double value) { return value; }
inline double sum_lanes(const Pack& values) {
  double sum = 0;
  for (int lane = 0; lane < lane_count; ++lane) sum += values[lane];
  return sum;
}

}  // namespace ringlet
