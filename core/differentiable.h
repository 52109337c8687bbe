#pragma once

#include "core/angles.h"
#include "core/elementary.h"

namespace ringlet {

/// A number that knows its derivatives: map(f, f', f'') is a function of it, given its value and
/// derivatives there.
template <class D>
concept Differentiable = requires(const D& number, const typename D::Scalar& scalar) {
  { number.map(scalar, scalar, scalar) } -> std::same_as<D>;
};

template <Differentiable D>
D abs(const D& a) {
  using S = typename D::Scalar;
  const S sign = select(a.value < S(0), S(-1), select(a.value > S(0), S(1), S(0)));
  return a.map(abs(a.value), sign, S(0));
}
template <Differentiable D>
D min(const D& a, const D& b) {
  return select(b.value < a.value, b, a);
}
template <Differentiable D>
D max(const D& a, const D& b) {
  return select(a.value < b.value, b, a);
}
template <Differentiable D>
D sqrt(const D& a) {
  using S = typename D::Scalar;
  const auto singular = a.value < S(1e-200);
  const S inverse = select(singular, S(0), S(inverse_sqrt(select(singular, S(1), a.value))));
  const S root = sqrt(a.value);
  return a.map(root, S(0.5) * inverse, S(-0.25) * inverse * inverse * inverse);
}
template <Differentiable D>
D inverse_sqrt(const D& a) {
  using S = typename D::Scalar;
  const S root = inverse_sqrt(a.value), square = root * root;
  return a.map(root, S(-0.5) * root * square, S(0.75) * root * square * square);
}
template <Differentiable D>
D exp(const D& a) {
  const auto f = exp(a.value);
  return a.map(f, f, f);
}
template <Differentiable D>
D log(const D& a) {
  using S = typename D::Scalar;
  const S inverse = S(1) / a.value;
  return a.map(log(a.value), inverse, -inverse * inverse);
}
template <Differentiable D>
D sin(const D& a) {
  using S = typename D::Scalar;
  const S f = sin(a.value);
  return a.map(f, cos(a.value), -f);
}
template <Differentiable D>
D cos(const D& a) {
  using S = typename D::Scalar;
  const S f = cos(a.value);
  return a.map(f, -sin(a.value), -f);
}
template <Differentiable D>
D tan(const D& a) {
  using S = typename D::Scalar;
  const S f = tan(a.value), first = S(1) + f * f;
  return a.map(f, first, S(2) * f * first);
}
template <Differentiable D>
D pow(const D& a, double exponent) {
  return a.map(pow(a.value, exponent), exponent * pow(a.value, exponent - 1),
               exponent * (exponent - 1) * pow(a.value, exponent - 2));
}

}  // namespace ringlet
