#pragma once

#include <Eigen/Core>

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

template <int K>
Eigen::Vector<double, 3 * (K - 1)> dense_gradient(const Derivatives<double, K>& derivatives) {
  Eigen::Vector<double, 3 * (K - 1)> result;
  for (int n = 0; n < K - 1; ++n) {
    result.template segment<3>(3 * n) = to_eigen(derivatives.gradient[n]);
  }
  return result;
}

/// One lane of many.
template <int K>
Derivatives<double, K> lane_of(const Derivatives<Pack, K>& packs, int lane) {
  Derivatives<double, K> one;
  for (int n = 0; n < K - 1; ++n) {
    const Vector3<Pack>& g = packs.gradient[n];
    one.gradient[n] = {g.x[lane], g.y[lane], g.z[lane]};
  }
  for (std::size_t b = 0; b < one.blocks.size(); ++b) {
    for (int m = 0; m < 9; ++m) one.blocks[b].m[m] = packs.blocks[b].m[m][lane];
  }
  return one;
}

/// Filter::absolute by the eigenvalues of an exact Hessian over the vertices; any other filter
/// clamps them. It costs a hundred times what a closed form costs. Compiled once for all K there
/// are: it takes longer than the rest of a kernel.
template <int K>
void filter_eigenvalues(Filter filter, Derivatives<double, K>& derivatives);

/// The same lane by lane.
template <int K>
void filter_eigenvalues(Filter filter, Derivatives<Pack, K>& derivatives) {
  for (int lane = 0; lane < lane_count; ++lane) {
    Derivatives<double, K> one = lane_of(derivatives, lane);
    filter_eigenvalues(filter, one);
    for (std::size_t b = 0; b < one.blocks.size(); ++b) {
      for (int m = 0; m < 9; ++m) derivatives.blocks[b].m[m][lane] = one.blocks[b].m[m];
    }
  }
}

}  // namespace ringlet
