#pragma once

#include <Eigen/Core>

#include "core/lanes.h"

namespace ringlet {

/// A 3-vector over any scalar of a kernel (double, Pack, traced number).
template <class S>
struct Vector3 {
  S x, y, z;

  Vector3& operator+=(const Vector3& b) { return *this = *this + b; }
  Vector3& operator-=(const Vector3& b) { return *this = *this - b; }
  friend Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Vector3 operator-(const Vector3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vector3 operator*(const S& s, const Vector3& a) { return scaled(s, a); }
};

// Inlined always: where a kernel is compiled twice, as for different filters, a call in one of them
// would round otherwise than what is fused in the other, and near a straight hinge that is seen.
template <class S>
[[gnu::always_inline]] inline Vector3<S> scaled(const S& s, const Vector3<S>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class S>
[[gnu::always_inline]] inline S dot(const Vector3<S>& a, const Vector3<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class S>
[[gnu::always_inline]] inline Vector3<S> cross(const Vector3<S>& a, const Vector3<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class S>
S squared_norm(const Vector3<S>& a) {
  return dot(a, a);
}

template <class S>
S norm(const Vector3<S>& a) {
  return sqrt(squared_norm(a));
}

template <class S, class Condition>
Vector3<S> select(const Condition& condition, const Vector3<S>& a, const Vector3<S>& b) {
  return {select(condition, a.x, b.x), select(condition, a.y, b.y), select(condition, a.z, b.z)};
}

/// A unit vector normal to a, which need not have unit length but must not be zero: a crossed with
/// the axis on which it is shortest.
template <class S>
[[gnu::always_inline]] inline Vector3<S> any_normal(const Vector3<S>& a) {
  const S zero = S(0);
  const auto x_least = abs(a.x) <= abs(a.y) && abs(a.x) <= abs(a.z);
  const auto y_least = abs(a.y) <= abs(a.z);
  const Vector3<S> across =
      select(x_least, Vector3<S>{zero, a.z, -a.y},
             select(y_least, Vector3<S>{-a.z, zero, a.x}, Vector3<S>{a.y, -a.x, zero}));
  return S(S(1) / norm(across)) * across;
}

inline Vector3<double> from_eigen(const Eigen::Vector3d& a) { return {a.x(), a.y(), a.z()}; }
inline Eigen::Vector3d to_eigen(const Vector3<double>& a) { return {a.x, a.y, a.z}; }

/// A 3x3 matrix over any scalar of a kernel; entry (row, column) is m[3 * row + column].
template <class S>
struct Matrix3 {
  S m[9];

  static Matrix3 zero() {
    Matrix3 a;
    for (S& entry : a.m) entry = S(0);
    return a;
  }
  S& operator()(int row, int column) { return m[3 * row + column]; }
  const S& operator()(int row, int column) const { return m[3 * row + column]; }
  Matrix3& operator+=(const Matrix3& b) {
    for (int i = 0; i < 9; ++i) m[i] += b.m[i];
    return *this;
  }
  friend Matrix3 operator*(const S& s, Matrix3 a) {
    for (S& entry : a.m) entry = s * entry;
    return a;
  }
};

template <class S>
Vector3<S> operator*(const Matrix3<S>& a, const Vector3<S>& b) {
  return {a.m[0] * b.x + a.m[1] * b.y + a.m[2] * b.z, a.m[3] * b.x + a.m[4] * b.y + a.m[5] * b.z,
          a.m[6] * b.x + a.m[7] * b.y + a.m[8] * b.z};
}

/// a^T b.
template <class S>
Vector3<S> transpose_multiply(const Matrix3<S>& a, const Vector3<S>& b) {
  return {a.m[0] * b.x + a.m[3] * b.y + a.m[6] * b.z, a.m[1] * b.x + a.m[4] * b.y + a.m[7] * b.z,
          a.m[2] * b.x + a.m[5] * b.y + a.m[8] * b.z};
}

/// target += a b^T.
template <class S>
void add_outer_product(Matrix3<S>& target, const Vector3<S>& a, const Vector3<S>& b) {
  target.m[0] += a.x * b.x;
  target.m[1] += a.x * b.y;
  target.m[2] += a.x * b.z;
  target.m[3] += a.y * b.x;
  target.m[4] += a.y * b.y;
  target.m[5] += a.y * b.z;
  target.m[6] += a.z * b.x;
  target.m[7] += a.z * b.y;
  target.m[8] += a.z * b.z;
}

}  // namespace ringlet
