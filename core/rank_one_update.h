#pragma once

#include <Eigen/Core>

namespace ringlet {

/// A symmetric matrix Q diag(values) Q^T: column i of `vectors` is the unit eigenvector of
/// values[i]. Whoever returns one says in which order.
struct Eigensystem {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// The eigensystem, values ascending, of Q diag(d) Q^T + rho v v^T. The values d of `system` may
/// stand in any order and repeat; its vectors Q must be orthonormal.
///
/// It is the tool to find a filter for an energy Psi(m) of your own measure m(x): its Hessian
/// h grad grad^T + g Hess, with g = Psi'(m) and h = Psi''(m), is g times the eigensystem of m's
/// Hessian, updated with rho = h and v = m's gradient.
///
/// Bunch, Nielsen & Sorensen 1978: the new eigenvalues are the roots of the secular equation
///
///     1 + rho sum_i z_i^2 / (d_i - lambda) = 0,  z = Q^T v
///
/// once the i with z_i = 0 and all but one of each set of equal d_i are set aside. The eigenvectors
/// are those of z recomputed from the roots (Gu & Eisenstat 1994): orthogonal to rounding however
/// close the eigenvalues are. Values and residuals are exact to rounding of the larger of |d| and
/// |rho| |v|^2. O(n^3). Throws Error where sizes do not match or a number is not finite.
Eigensystem rank_one_update(const Eigensystem& system, double rho, const Eigen::VectorXd& vector);

}  // namespace ringlet
