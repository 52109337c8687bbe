#include "energies/angle_eigensystem.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/error.h"

namespace ringlet {

AngleFrame::AngleFrame(const Eigen::Vector3d& first_edge, const Eigen::Vector3d& second_edge)
    : t0(first_edge.normalized()), t1(second_edge.normalized()), normal(t0.cross(t1)) {
  const double sine = normal.norm();
  constexpr double rounding = 1e-15;
  if (!(sine > rounding))
    throw Error("the angle between parallel vectors has no second derivative");
  normal /= sine;
  b0 = t0.cross(normal);
  b1 = t1.cross(normal);
  theta = std::atan2(sine, t0.dot(t1));
  half_tangent = (t0 - t1).norm() / (t0 + t1).norm();
}

Vector6 angle_gradient(const AngleFrame& frame) {
  Vector6 gradient;
  gradient << frame.b0, -frame.b1;
  return gradient;
}

Eigensystem angle_eigensystem(const AngleFrame& frame) {
  const auto& [t0, t1, n, b0, b1, theta, half_tangent] = frame;
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  Eigensystem system{Vector6(), Eigen::MatrixXd(6, 6)};
  system.values << -half_tangent, 1 / half_tangent, -1, 1, -1, 1;
  system.vectors << n, n, t0 + b0, t0 - b0, zero, zero,  //
      n, -n, zero, zero, t1 - b1, t1 + b1;
  system.vectors.colwise().normalize();
  return system;
}

Eigensystem energy_eigensystem(const AngleFrame& frame, double g, double h) {
  const auto& [t0, t1, n, b0, b1, theta, half_tangent] = frame;
  // (c, s) is the unit vector along the supplement's (g, h + r), also where g or both vanish.
  const double r = std::hypot(h, g), phi = 0.5 * std::atan2(g, -h);
  const double c = std::cos(phi), s = std::sin(phi);
  Eigensystem system{Vector6(), Eigen::MatrixXd(6, 6)};
  system.values << -g * half_tangent, g / half_tangent, h + r, h - r, -g, g;
  system.vectors << n, n, c * t0 - s * b0, -s * t0 - c * b0, t0 + b0, t0 - b0,  //
      n, -n, c * t1 + s * b1, -s * t1 + c * b1, -t1 + b1, -t1 - b1;
  system.vectors.colwise().normalize();
  return system;
}

}  // namespace ringlet
