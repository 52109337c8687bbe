#pragma once

#include <Eigen/Eigenvalues>

#include "core/element.h"

namespace ringlet {

inline double lane_value(double value, int) { return value; }
inline double lane_value(const Pack& values, int lane) { return values[lane]; }
inline void set_lane_value(double& target, int, double value) { target = value; }
inline void set_lane_value(Pack& target, int lane, double value) { target[lane] = value; }

/// Filter::absolute by the eigenvalues of an exact Hessian, lane by lane; any other filter clamps
/// them. It costs a hundred times what a closed form costs.
template <class S, int K>
[[gnu::noinline]] void filter_eigenvalues(Filter filter, Derivatives<S, K>& derivatives) {
  using Dense = Eigen::Matrix<double, 3 * K, 3 * K>;
  const auto entry = [&](int row, int column) -> S& {
    return derivatives.block(row / 3, column / 3)(row % 3, column % 3);
  };
  constexpr int lanes = std::is_same_v<S, double> ? 1 : lane_count;
  for (int lane = 0; lane < lanes; ++lane) {
    Dense hessian;
    for (int row = 0; row < 3 * K; ++row) {
      for (int column = 0; column <= row; ++column) {
        hessian(row, column) = lane_value(entry(row, column), lane);
      }
    }
    const Eigen::SelfAdjointEigenSolver<Dense> solver(hessian);
    const Eigen::Vector<double, 3 * K> eigenvalues =
        filter == Filter::absolute ? solver.eigenvalues().cwiseAbs().eval()
                                   : solver.eigenvalues().cwiseMax(0.0).eval();
    const Dense filtered =
        solver.eigenvectors() * eigenvalues.asDiagonal() * solver.eigenvectors().transpose();
    for (int row = 0; row < 3 * K; ++row) {
      for (int column = 0; column < 3 * (row / 3 + 1); ++column) {
        set_lane_value(entry(row, column), lane, filtered(row, column));
      }
    }
  }
}

}  // namespace ringlet
