#pragma once

#include <cstring>

#include "core/element.h"
#include "core/traced.h"

namespace ringlet {

/// The derivatives of a kernel that gives only its value, which is evaluated once with traced
/// numbers over S whose variables are the edges: the exact gradient, and the Hessian or its
/// positive part as Trace computes it. Adds them and returns the value.
template <Curvature curvature, class Kernel, class S>
[[gnu::noinline]] S evaluate_by_autodiff(const Kernel& kernel,
                                         const Stencil<S, Kernel::vertices>& x,
                                         const typename Kernel::template Rest<S>& rest,
                                         ElementOutputs<S, Kernel::vertices> outputs) {
  constexpr int K = Kernel::vertices, variables = 3 * (K - 1);
  using Number = Traced<S, variables>;
  using Rest = typename Kernel::template Rest<S>;
  using TracedRest = typename Kernel::template Rest<Number>;
  constexpr int rest_size = sizeof(Rest) / sizeof(S);
  static_assert(sizeof(TracedRest) == rest_size * sizeof(Number),
                "Rest<S> must hold only scalars S");

  // x_n = x_0 + e_0 + ... + e_{n-1}. Seen from x_0, which has no derivatives.
  Trace<S, variables> trace;
  Stencil<Number, K> positions;
  positions[0] = {Number(x[0].x), Number(x[0].y), Number(x[0].z)};
  for (int n = 1; n < K; ++n) {
    const auto coordinate = [&](const S& value, int c) {
      return Number(value, trace.coordinate_of_sum(n, c), &trace);
    };
    positions[n] = {coordinate(x[n].x, 0), coordinate(x[n].y, 1), coordinate(x[n].z, 2)};
  }
  std::array<S, rest_size> rest_scalars;
  std::memcpy(&rest_scalars, &rest, sizeof(Rest));
  std::array<Number, rest_size> rest_numbers;
  for (int i = 0; i < rest_size; ++i) rest_numbers[i] = Number(rest_scalars[i]);
  TracedRest traced_rest;
  std::memcpy(static_cast<void*>(&traced_rest), &rest_numbers, sizeof(TracedRest));

  const Number energy = kernel.value(positions, traced_rest);
  if (energy.is_constant()) return energy.value;
  const auto& gradient = trace.gradient(energy.node);
  for (int row = 0; row < K - 1; ++row) {
    outputs.add_gradient(row, {gradient[3 * row], gradient[3 * row + 1], gradient[3 * row + 2]});
  }
  trace.template hessian<curvature>(energy.node)
      .for_each_block([&](int row, int column, const Matrix3<S>& block) {
        outputs.block(row, column) += block;
      });
  return energy.value;
}

}  // namespace ringlet
