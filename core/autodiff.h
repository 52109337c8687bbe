#pragma once

#include <cstring>

#include "core/dual.h"
#include "core/element.h"

namespace ringlet {

/// The exact derivatives of a kernel that gives only its value, which is evaluated once with dual
/// numbers over S. Adds them and returns the value.
template <class Kernel, class S>
[[gnu::noinline]] S evaluate_by_autodiff(const Kernel& kernel,
                                         const Stencil<S, Kernel::vertices>& x,
                                         const typename Kernel::template Rest<S>& rest,
                                         ElementOutputs<S, Kernel::vertices> outputs) {
  constexpr int K = Kernel::vertices;
  using Number = Dual<S, 3 * K>;
  using Rest = typename Kernel::template Rest<S>;
  using DualRest = typename Kernel::template Rest<Number>;
  constexpr int rest_size = sizeof(Rest) / sizeof(S);
  static_assert(sizeof(DualRest) == rest_size * sizeof(Number), "Rest<S> must hold only scalars S");

  Stencil<Number, K> variables;
  for (int n = 0; n < K; ++n) {
    variables[n] = {Number::variable(x[n].x, 3 * n), Number::variable(x[n].y, 3 * n + 1),
                    Number::variable(x[n].z, 3 * n + 2)};
  }
  std::array<S, rest_size> rest_scalars;
  std::memcpy(&rest_scalars, &rest, sizeof(Rest));
  const std::array<Number, rest_size> rest_numbers = [&] {
    std::array<Number, rest_size> numbers;
    for (int i = 0; i < rest_size; ++i) numbers[i] = Number(rest_scalars[i]);
    return numbers;
  }();
  DualRest dual_rest;
  std::memcpy(static_cast<void*>(&dual_rest), &rest_numbers, sizeof(DualRest));

  const Number energy = kernel.value(variables, dual_rest);
  const auto hessian = [&](int row, int column) {
    return row >= column ? energy.hessian[row * (row + 1) / 2 + column]
                         : energy.hessian[column * (column + 1) / 2 + row];
  };
  for (int row = 0; row < K; ++row) {
    const S* gradient = &energy.gradient[3 * row];
    outputs.add_gradient(row, {gradient[0], gradient[1], gradient[2]});
    for (int column = 0; column <= row; ++column) {
      for (int m = 0; m < 9; ++m) {
        outputs.block(row, column).m[m] += hessian(3 * row + m / 3, 3 * column + m % 3);
      }
    }
  }
  return energy.value;
}

}  // namespace ringlet
