#include "energies/twist_jacobians.h"

namespace ringlet {
namespace {

/// The edges, n = |e1|^2, and the coefficients of u = e0 - a e1, v = e2 - c e1.
struct Edges {
  Eigen::Vector3d e0, e1, e2;
  double n, a, c;

  explicit Edges(const FourVertices& x)
      : e0(x.col(0) - x.col(1)),
        e1(x.col(2) - x.col(1)),
        e2(x.col(3) - x.col(2)),
        n(e1.squaredNorm()),
        a(e0.dot(e1) / n),
        c(e2.dot(e1) / n) {}
};

}  // namespace

Eigen::Matrix3d twist_matrix(const FourVertices& x) {
  const auto& [e0, e1, e2, n, a, c] = Edges(x);
  Eigen::Matrix3d matrix;
  matrix << e0 - a * e1, e2 - c * e1, e1;
  return matrix;
}

TwistJacobian exact_twist_jacobian(const FourVertices& x) {
  const Edges edges(x);
  const auto& [e0, e1, e2, n, a, c] = edges;
  const auto along = [&](const Eigen::Vector3d& vector) -> Eigen::Matrix3d {
    return edges.e1 * vector.transpose() / edges.n;
  };
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity(), zero = Eigen::Matrix3d::Zero();
  TwistJacobian jacobian;
  jacobian << identity - along(e1),                        // du/dx0
      (a - 1) * identity - along((2 * a - 1) * e1 - e0),   // du/dx1
      -a * identity - along(e0 - 2 * a * e1),              // du/dx2
      zero, zero,                                          // du/dx3, dv/dx0
      c * identity - along(2 * c * e1 - e2),               // dv/dx1
      -(c + 1) * identity + along((2 * c + 1) * e1 - e2),  // dv/dx2
      identity - along(e1);                                // dv/dx3
  return jacobian;
}

TwistJacobian simplified_twist_jacobian(const FourVertices& x) {
  const Edges edges(x);
  const double a = edges.a, c = edges.c;
  Eigen::Matrix<double, 2, 4> coefficients;
  coefficients << 1, a - 1, -a, 0,  //
      0, c, -(c + 1), 1;
  TwistJacobian jacobian;
  for (Eigen::Index i = 0; i < 2; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      jacobian.block<3, 3>(3 * i, 3 * j) = coefficients(i, j) * Eigen::Matrix3d::Identity();
    }
  }
  return jacobian;
}

}  // namespace ringlet
