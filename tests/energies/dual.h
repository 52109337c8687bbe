#pragma once

#include <array>
#include <concepts>

#include "core/differentiable.h"

namespace ringlet {

/// The slow oracle of Traced: a second-order forward dual number over S (double or Pack): a value
/// with its gradient and Hessian, of which the lower triangle is kept, with respect to N variables.
/// Where a function has no derivative (sqrt and abs at 0, atan2 at the origin), or none that a
/// double can hold (sqrt below 1e-200), the derivative is taken as 0.
template <class S, int N>
struct Dual {
  using Scalar = S;

  S value;
  std::array<S, N> gradient;
  std::array<S, N*(N + 1) / 2> hessian;

  Dual() = default;
  /// A constant.
  template <class C>
  requires std::convertible_to<C, S> Dual(const C& constant)
      : value(constant) {  // NOLINT(*-explicit-*)
    gradient.fill(S(0));
    hessian.fill(S(0));
  }
  /// The variable of this number.
  static Dual variable(const S& value, int number) {
    Dual result(value);
    result.gradient[number] = S(1);
    return result;
  }

  friend Dual operator+(const Dual& a, const Dual& b) {
    return combine(a, b, a.value + b.value, S(1), S(1));
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return combine(a, b, a.value - b.value, S(1), S(-1));
  }
  friend Dual operator-(const Dual& a) { return Dual(S(0)) - a; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual result = combine(a, b, a.value * b.value, b.value, a.value);
    result.add_mixed_product(S(1), a, b);
    return result;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const S inverse = S(1) / b.value, square = inverse * inverse;
    return a * b.map(inverse, -square, S(2) * square * inverse);
  }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend auto operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend auto operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend auto operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend auto operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
  friend auto operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend auto operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }

  /// f(*this) for a function of one variable, from f and its derivatives at the value.
  Dual map(const S& f, const S& first, const S& second) const {
    Dual result;
    result.value = f;
    for (int i = 0; i < N; ++i) result.gradient[i] = first * gradient[i];
    for (int i = 0, k = 0; i < N; ++i) {
      const S scaled = second * gradient[i];
      for (int j = 0; j <= i; ++j, ++k) {
        result.hessian[k] = first * hessian[k] + scaled * gradient[j];
      }
    }
    return result;
  }
  /// `value` with derivatives wa da + wb db, to both orders.
  static Dual combine(const Dual& a, const Dual& b, const S& value, const S& wa, const S& wb) {
    Dual result;
    result.value = value;
    for (int i = 0; i < N; ++i) result.gradient[i] = wa * a.gradient[i] + wb * b.gradient[i];
    for (std::size_t k = 0; k < result.hessian.size(); ++k) {
      result.hessian[k] = wa * a.hessian[k] + wb * b.hessian[k];
    }
    return result;
  }
  /// Hessian += weight (da db^T + db da^T).
  void add_mixed_product(const S& weight, const Dual& a, const Dual& b) {
    for (int i = 0, k = 0; i < N; ++i) {
      const S wa = weight * a.gradient[i], wb = weight * b.gradient[i];
      for (int j = 0; j <= i; ++j, ++k) hessian[k] += wa * b.gradient[j] + wb * a.gradient[j];
    }
  }
};

template <class Condition, class S, int N>
Dual<S, N> select(const Condition& condition, const Dual<S, N>& a, const Dual<S, N>& b) {
  Dual<S, N> result;
  result.value = select(condition, a.value, b.value);
  for (int i = 0; i < N; ++i) result.gradient[i] = select(condition, a.gradient[i], b.gradient[i]);
  for (std::size_t k = 0; k < result.hessian.size(); ++k) {
    result.hessian[k] = select(condition, a.hessian[k], b.hessian[k]);
  }
  return result;
}

template <class S, int N>
Dual<S, N> atan2(const Dual<S, N>& y, const Dual<S, N>& x) {
  const S square = x.value * x.value + y.value * y.value;
  const auto singular = square == S(0);
  const S inverse = select(singular, S(0), S(S(1) / select(singular, S(1), square)));
  const S dy = x.value * inverse, dx = -y.value * inverse;
  Dual<S, N> angle = Dual<S, N>::combine(y, x, atan2(y.value, x.value), dy, dx);
  angle.add_mixed_product(dy * dx, y, y);
  angle.add_mixed_product(-dy * dx, x, x);
  angle.add_mixed_product(dx * dx - dy * dy, y, x);
  return angle;
}

}  // namespace ringlet
