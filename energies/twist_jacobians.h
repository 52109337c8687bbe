#pragma once

// How u and v, the end edges of four vertices projected off the middle one, follow the vertices
// (math.md, section 3). No kernel uses this: it is the reference for deriving filters and the slow
// oracle of the tests.

#include <Eigen/Core>

namespace ringlet {

using FourVertices = Eigen::Matrix<double, 3, 4>;    ///< a column a vertex
using TwistJacobian = Eigen::Matrix<double, 6, 12>;  ///< of (u, v) by (x0, x1, x2, x3)

/// W = [u v e1], the supplement's equation 45: e0 = x0 - x1, e1 = x2 - x1, e2 = x3 - x2, and u, v
/// the parts of e0, e2 normal to e1, which must not vanish.
Eigen::Matrix3d twist_matrix(const FourVertices& x);

/// The derivative of w = (u, v), math.md's Jhat.
TwistJacobian exact_twist_jacobian(const FourVertices& x);

/// Math.md's J, the supplement's equation 46: as if the coefficients of the vertices in u and v
/// were constant. Not the derivative of w, but it takes dPsi/dw to the same gradient; its Hessian
/// is H_x = J^T H_w J - D^T H_w D, D = J - Jhat.
TwistJacobian simplified_twist_jacobian(const FourVertices& x);

}  // namespace ringlet
