#pragma once

// The eigensystems of the supplement to "Lifted Curls", as corrected in math.md, sections 2 and 5.
// No kernel uses them: they are the reference for deriving filters and the slow oracle of the
// tests.

#include "core/rank_one_update.h"

namespace ringlet {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The unit tangents T = (t0, t1) of two edges, the angle theta between them, and what the
/// supplement derives from them; `normal` is its b/|b|. Throws Error where the edges are parallel,
/// for theta has no second derivative there.
struct AngleFrame {
  Eigen::Vector3d t0, t1, normal, b0, b1;
  double theta;
  double half_tangent;  ///< tan(theta/2)

  AngleFrame(const Eigen::Vector3d& first_edge, const Eigen::Vector3d& second_edge);
};

/// dtheta/dT = (b0, -b1).
Vector6 angle_gradient(const AngleFrame& frame);

/// d2theta/dT2 where theta is extended to tangents of any length by theta(t0/|t0|, t1/|t1|). In the
/// order of the supplement's equations 2 to 7; the values are -tan(theta/2), cot(theta/2), -1, 1,
/// -1, 1.
Eigensystem angle_eigensystem(const AngleFrame& frame);

/// d2Psi/dT2 of an energy Psi(theta) with g = Psi'(theta), h = Psi''(theta). In the order of the
/// supplement's equations 37 to 42; the values are -g tan(theta/2), g cot(theta/2), h + r, h - r,
/// -g, g, with r = sqrt(h^2 + g^2).
Eigensystem energy_eigensystem(const AngleFrame& frame, double g, double h);

}  // namespace ringlet
