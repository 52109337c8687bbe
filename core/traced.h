#pragma once

#include <concepts>

#include "core/differentiable.h"
#include "core/trace.h"

namespace ringlet {

/// A number over S (double or Pack) that traces how it was computed from N variables, from which
/// its gradient and Hessian follow: a scalar of kernels. Where a function has no derivative (sqrt
/// and abs at 0, atan2 at the origin), or none that a double can hold (sqrt below 1e-200), the
/// derivative is taken as 0.
template <class S, int N>
struct Traced {
  using Scalar = S;

  S value;
  int node = Trace<S, N>::constant;
  Trace<S, N>* trace = nullptr;  ///< of which all numbers of a computation are part

  Traced() = default;
  /// A constant.
  template <class C>
  requires std::convertible_to<C, S> Traced(const C& constant)  // NOLINT(*-explicit-*)
      : value(constant) {}
  Traced(const S& number, int operation, Trace<S, N>* of)
      : value(number), node(operation), trace(of) {}

  bool is_constant() const { return node == Trace<S, N>::constant; }

  friend Traced operator+(const Traced& a, const Traced& b) {
    if (a.is_constant()) return {a.value + b.value, b.node, b.trace};
    if (b.is_constant()) return {a.value + b.value, a.node, a.trace};
    return {a.value + b.value, a.trace->sum(a.node, b.node), a.trace};
  }
  friend Traced operator-(const Traced& a, const Traced& b) {
    if (b.is_constant()) return {a.value - b.value, a.node, a.trace};
    if (a.is_constant()) return {a.value - b.value, b.trace->scaled(b.node, S(-1)), b.trace};
    return {a.value - b.value, a.trace->difference(a.node, b.node), a.trace};
  }
  friend Traced operator-(const Traced& a) { return Traced(S(0)) - a; }
  friend Traced operator*(const Traced& a, const Traced& b) {
    const S product = a.value * b.value;
    if (a.is_constant() && b.is_constant()) return product;
    if (a.is_constant()) return {product, b.trace->scaled(b.node, a.value), b.trace};
    if (b.is_constant()) return {product, a.trace->scaled(a.node, b.value), a.trace};
    return {product, a.trace->product(a.node, b.node, a.value, b.value), a.trace};
  }
  friend Traced operator/(const Traced& a, const Traced& b) {
    const S inverse = S(1) / b.value, quotient = a.value * inverse, square = inverse * inverse;
    if (b.is_constant()) return a * Traced(inverse);
    return a.map(b, quotient, inverse, -quotient * inverse,
                 {S(0), -square, S(2) * quotient * square});
  }
  Traced& operator+=(const Traced& b) { return *this = *this + b; }
  Traced& operator-=(const Traced& b) { return *this = *this - b; }
  Traced& operator*=(const Traced& b) { return *this = *this * b; }
  Traced& operator/=(const Traced& b) { return *this = *this / b; }

  friend auto operator<(const Traced& a, const Traced& b) { return a.value < b.value; }
  friend auto operator<=(const Traced& a, const Traced& b) { return a.value <= b.value; }
  friend auto operator>(const Traced& a, const Traced& b) { return a.value > b.value; }
  friend auto operator>=(const Traced& a, const Traced& b) { return a.value >= b.value; }
  friend auto operator==(const Traced& a, const Traced& b) { return a.value == b.value; }
  friend auto operator!=(const Traced& a, const Traced& b) { return a.value != b.value; }

  /// f(*this) for a function of one variable, from f and its derivatives at the value.
  Traced map(const S& f, const S& first, const S& second) const {
    if (is_constant()) return f;
    return {f, trace->function(node, first, second), trace};
  }
  /// f(*this, b), one of them at least not constant.
  Traced map(const Traced& b, const S& f, const S& first_a, const S& first_b,
             const Second<S>& second) const {
    Trace<S, N>* const common = trace != nullptr ? trace : b.trace;
    return {f, common->function(node, b.node, first_a, first_b, second), common};
  }
};

template <class Condition, class S, int N>
Traced<S, N> select(const Condition& condition, const Traced<S, N>& a, const Traced<S, N>& b) {
  const S value = select(condition, a.value, b.value);
  if (a.is_constant() && b.is_constant()) return value;
  Trace<S, N>* const common = a.trace != nullptr ? a.trace : b.trace;
  return {value, common->choice(condition, a.node, b.node), common};
}

/// The operations of vectors, each as one step of the trace.
template <class S, int N>
typename Trace<S, N>::Vectors arguments_of(const Vector3<Traced<S, N>>& a,
                                           const Vector3<Traced<S, N>>& b) {
  return {{a.x.node, a.y.node, a.z.node},
          {b.x.node, b.y.node, b.z.node},
          {a.x.value, a.y.value, a.z.value},
          {b.x.value, b.y.value, b.z.value}};
}
template <class S, int N>
Trace<S, N>* trace_of(const Vector3<Traced<S, N>>& a, const Vector3<Traced<S, N>>& b) {
  for (const Traced<S, N>* number : {&a.x, &a.y, &a.z, &b.x, &b.y, &b.z}) {
    if (number->trace != nullptr) return number->trace;
  }
  return nullptr;
}
template <class S, int N>
Traced<S, N> dot(const Vector3<Traced<S, N>>& a, const Vector3<Traced<S, N>>& b) {
  const auto vectors = arguments_of(a, b);
  const S value = dot(vectors.a_value, vectors.b_value);
  Trace<S, N>* const trace = trace_of(a, b);
  if (trace == nullptr) return value;
  return {value, trace->dot(vectors), trace};
}
template <class S, int N>
Vector3<Traced<S, N>> cross(const Vector3<Traced<S, N>>& a, const Vector3<Traced<S, N>>& b) {
  const auto vectors = arguments_of(a, b);
  const Vector3<S> value = cross(vectors.a_value, vectors.b_value);
  Trace<S, N>* const trace = trace_of(a, b);
  if (trace == nullptr) return {value.x, value.y, value.z};
  const int first = trace->cross(vectors);
  return {{value.x, first, trace}, {value.y, first + 1, trace}, {value.z, first + 2, trace}};
}

template <class S, int N>
Vector3<Traced<S, N>> scaled(const Traced<S, N>& s, const Vector3<Traced<S, N>>& a) {
  const Vector3<S> value = scaled(s.value, Vector3<S>{a.x.value, a.y.value, a.z.value});
  const auto vectors = arguments_of(a, a);
  const bool fixed = a.x.is_constant() && a.y.is_constant() && a.z.is_constant();
  if (s.is_constant() || fixed) return {s * a.x, s * a.y, s * a.z};
  const int first = s.trace->scaled_vector(s.node, s.value, vectors);
  return {{value.x, first, s.trace}, {value.y, first + 1, s.trace}, {value.z, first + 2, s.trace}};
}

template <class S, int N>
Traced<S, N> atan2(const Traced<S, N>& y, const Traced<S, N>& x) {
  const S angle = atan2(y.value, x.value);
  if (y.is_constant() && x.is_constant()) return angle;
  const S square = x.value * x.value + y.value * y.value;
  const auto singular = square == S(0);
  const S inverse = select(singular, S(0), S(S(1) / select(singular, S(1), square)));
  const S dy = x.value * inverse, dx = -y.value * inverse;
  return y.map(x, angle, dy, dx, {S(2) * dy * dx, dx * dx - dy * dy, S(-2) * dy * dx});
}

}  // namespace ringlet
