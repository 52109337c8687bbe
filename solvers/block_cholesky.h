#pragma once

#include <array>
#include <limits>

#include "core/vector3.h"
#include "solvers/unrolled.h"

namespace ringlet {

/// The inverse of the Cholesky factor of eight symmetric 3x3 matrices side by side: with S = L L^T,
/// T = L^-1 is lower triangular. Entries 00, 10, 11, 20, 21, 22.
struct InverseTriangle {
  std::array<Pack, 6> t;
};

/// Factors the symmetric matrix whose lower triangle is s (entries as above), none of them beyond
/// 1e-77 to 1e77. Sets the lanes of `bad` in which a pivot is not positive and finite; the result
/// is not usable there.
///
/// Eliminates without quotients (Bareiss, Math. Comp. 22, 1968): Schur complements are multiplied
/// by the pivots before them instead of divided, so that no root waits for another,
///
///     p = s00 s11 - s10^2,  q = s00 s21 - s20 s10,  r = s00 s22 - s20^2,  u = p r - q^2
///
///     T = (1                                  ) / sqrt(s00)
///         (-s10               s00             ) / sqrt(s00 p)
///         (q s10 - p s20     -q s00      p s00) / sqrt(s00 p u)
///
/// and the relative errors are those of Cholesky's method all the same.
[[gnu::always_inline]] inline InverseTriangle inverse_cholesky(const std::array<Pack, 6>& s,
                                                               Mask& bad) {
  const Pack largest = std::numeric_limits<double>::max();
  const auto inverse_root = [&](const Pack& pivot) {
    bad = bad || !(pivot > 0 && pivot <= largest);
    return inverse_sqrt(pivot);
  };
  const Pack p = s[0] * s[2] - s[1] * s[1];
  const Pack q = s[0] * s[4] - s[3] * s[1];
  const Pack r = s[0] * s[5] - s[3] * s[3];
  const Pack t00 = inverse_root(s[0]);
  const Pack inverse_root_p = inverse_root(p);
  const Pack inverse_root_u = inverse_root(p * r - q * q);
  const Pack inverse_root_s_p = t00 * inverse_root_p;
  const Pack t11 = s[0] * inverse_root_s_p;
  const Pack t11_by_root_u = t11 * inverse_root_u;
  const Pack t20 = (q * s[1] - p * s[3]) * (inverse_root_s_p * inverse_root_u);
  return {{t00, -s[1] * inverse_root_s_p, t11, t20, -q * t11_by_root_u, p * t11_by_root_u}};
}

/// The lower triangle of a symmetric matrix.
inline std::array<Pack, 6> lower_triangle(const Matrix3<Pack>& a) {
  return {a(0, 0), a(1, 0), a(1, 1), a(2, 0), a(2, 1), a(2, 2)};
}

/// T v.
inline Vector3<Pack> operator*(const InverseTriangle& a, const Vector3<Pack>& v) {
  const auto& t = a.t;
  return {t[0] * v.x, t[1] * v.x + t[2] * v.y, t[3] * v.x + t[4] * v.y + t[5] * v.z};
}

/// T^T v.
inline Vector3<Pack> transpose_multiply(const InverseTriangle& a, const Vector3<Pack>& v) {
  const auto& t = a.t;
  return {t[0] * v.x + t[1] * v.y + t[3] * v.z, t[2] * v.y + t[4] * v.z, t[5] * v.z};
}

/// A T^T.
inline Matrix3<Pack> times_transposed(const Matrix3<Pack>& a, const InverseTriangle& triangle) {
  const auto& t = triangle.t;
  Matrix3<Pack> product;
  unrolled<3>([&](auto r) {
    product(r, 0) = a(r, 0) * t[0];
    product(r, 1) = a(r, 0) * t[1] + a(r, 1) * t[2];
    product(r, 2) = a(r, 0) * t[3] + a(r, 1) * t[4] + a(r, 2) * t[5];
  });
  return product;
}

}  // namespace ringlet
