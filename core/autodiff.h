#pragma once

#include <cstring>

#include "core/dual.h"
#include "core/element.h"

namespace ringlet {

/// The exact derivatives of a kernel that gives only its value, which is evaluated once with dual
/// numbers over S whose variables are the edges. Adds them and returns the value.
template <class Kernel, class S>
[[gnu::noinline]] S evaluate_by_autodiff(const Kernel& kernel,
                                         const Stencil<S, Kernel::vertices>& x,
                                         const typename Kernel::template Rest<S>& rest,
                                         ElementOutputs<S, Kernel::vertices> outputs) {
  constexpr int K = Kernel::vertices;
  using Number = Dual<S, 3 * (K - 1)>;
  using Rest = typename Kernel::template Rest<S>;
  using DualRest = typename Kernel::template Rest<Number>;
  constexpr int rest_size = sizeof(Rest) / sizeof(S);
  static_assert(sizeof(DualRest) == rest_size * sizeof(Number), "Rest<S> must hold only scalars S");

  // x_n = x_0 + e_0 + ... + e_{n-1}.
  Stencil<Number, K> positions;
  for (int n = 0; n < K; ++n) {
    positions[n] = {Number(x[n].x), Number(x[n].y), Number(x[n].z)};
    for (int edge = 0; edge < n; ++edge) {
      positions[n].x.gradient[3 * edge] = S(1);
      positions[n].y.gradient[3 * edge + 1] = S(1);
      positions[n].z.gradient[3 * edge + 2] = S(1);
    }
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

  const Number energy = kernel.value(positions, dual_rest);
  const auto hessian = [&](int row, int column) {
    return row >= column ? energy.hessian[row * (row + 1) / 2 + column]
                         : energy.hessian[column * (column + 1) / 2 + row];
  };
  for (int row = 0; row < K - 1; ++row) {
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
