#pragma once

#include <Eigen/Eigenvalues>

#include "core/element.h"

namespace ringlet {

/// e = D x: the edges of an element of K vertices.
template <int K>
Eigen::Matrix<double, 3 * (K - 1), 3 * K> edge_differences() {
  Eigen::Matrix<double, 3 * (K - 1), 3 * K> result =
      Eigen::Matrix<double, 3 * (K - 1), 3 * K>::Zero();
  for (int edge = 0; edge < K - 1; ++edge) {
    result.template block<3, 3>(3 * edge, 3 * edge) = -Eigen::Matrix3d::Identity();
    result.template block<3, 3>(3 * edge, 3 * edge + 3) = Eigen::Matrix3d::Identity();
  }
  return result;
}

/// The symmetric Hessian of an element over its edges, of plain doubles.
template <int K>
Eigen::Matrix<double, 3 * (K - 1), 3 * (K - 1)> dense_hessian(
    const Derivatives<double, K>& derivatives) {
  Eigen::Matrix<double, 3 * (K - 1), 3 * (K - 1)> result;
  for (int row = 0; row < 3 * (K - 1); ++row) {
    for (int column = 0; column <= row; ++column) {
      result(row, column) = result(column, row) =
          derivatives.block(row / 3, column / 3)(row % 3, column % 3);
    }
  }
  return result;
}

/// Filter::absolute by the eigenvalues of an exact Hessian over the vertices; any other filter
/// clamps them. It costs a hundred times what a closed form costs.
template <int K>
[[gnu::noinline]] void filter_eigenvalues(Filter filter, Derivatives<double, K>& derivatives) {
  using Dense = Eigen::Matrix<double, 3 * K, 3 * K>;
  const auto differences = edge_differences<K>();
  const Dense hessian = differences.transpose() * dense_hessian(derivatives) * differences;
  const Eigen::SelfAdjointEigenSolver<Dense> solver(hessian);
  const Eigen::Vector<double, 3 * K> eigenvalues = filter == Filter::absolute
                                                       ? solver.eigenvalues().cwiseAbs().eval()
                                                       : solver.eigenvalues().cwiseMax(0.0).eval();
  const Dense filtered =
      solver.eigenvectors() * eigenvalues.asDiagonal() * solver.eigenvectors().transpose();
  // It is as invariant under translations as the exact Hessian: seen from the first vertex,
  // x_n = e_0 + ... + e_{n-1}.
  for (int row = 0; row < K - 1; ++row) {
    for (int column = 0; column <= row; ++column) {
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (int n = row + 1; n < K; ++n) {
        for (int m = column + 1; m < K; ++m) sum += filtered.template block<3, 3>(3 * n, 3 * m);
      }
      for (int m = 0; m < 9; ++m) derivatives.block(row, column).m[m] = sum(m / 3, m % 3);
    }
  }
}

/// The same lane by lane.
template <int K>
void filter_eigenvalues(Filter filter, Derivatives<Pack, K>& derivatives) {
  for (int lane = 0; lane < lane_count; ++lane) {
    Derivatives<double, K> one;
    for (std::size_t b = 0; b < one.blocks.size(); ++b) {
      for (int m = 0; m < 9; ++m) one.blocks[b].m[m] = derivatives.blocks[b].m[m][lane];
    }
    filter_eigenvalues(filter, one);
    for (std::size_t b = 0; b < one.blocks.size(); ++b) {
      for (int m = 0; m < 9; ++m) derivatives.blocks[b].m[m][lane] = one.blocks[b].m[m];
    }
  }
}

}  // namespace ringlet
