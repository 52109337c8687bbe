#include "core/numeric_filter.h"

#include <Eigen/Eigenvalues>

namespace ringlet {

template <int K>
void filter_eigenvalues(Filter filter, Derivatives<double, K>& derivatives) {
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

template void filter_eigenvalues<2>(Filter filter, Derivatives<double, 2>& derivatives);
template void filter_eigenvalues<3>(Filter filter, Derivatives<double, 3>& derivatives);
template void filter_eigenvalues<4>(Filter filter, Derivatives<double, 4>& derivatives);
static_assert(band_blocks == 4);

}  // namespace ringlet
