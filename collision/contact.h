#pragma once

#include <array>

#include "core/contact_energy.h"
#include "core/couplings.h"
#include "core/vertex_field.h"

namespace ringlet {

/// A contact of up to four vertices, as it is at some positions. For a distance d between closest
/// points, d = n . sum_i w_i x_i + what does not depend on the vertices, so that
///
///     dE/dx_i = E'(d) w_i n,    d2E/dx_i dx_j ~ E''(d) w_i w_j n n^T
///
/// The gradient is exact, since the closest points move tangentially. The Hessian is that of
/// Gauss and Newton. For fixed closest points it is also the exact one with its negative
/// eigenvalues, those of E'(d)/d (I - n n^T), clamped at zero.
struct Contact {
  std::array<int, 4> vertices;
  std::array<double, 4> weights;  ///< 0: the vertex takes no part
  Eigen::Vector3d normal;         ///< n, unit
  double depth;                   ///< thickness minus distance, m
  DistanceEnergy energy;

  CouplingTerm term() const {
    return {vertices, weights, energy.slope * normal,
            energy.curvature * normal * normal.transpose()};
  }
};

/// The distance of two segments p0 p1 and q0 q1, its derivative with respect to their vertices, in
/// this order, being weights[i] normal.
struct SegmentGap {
  double distance;
  std::array<double, 4> weights;
  Eigen::Vector3d normal;  ///< from q to p
};

/// Where the segments cross, their distance has no derivative: the normal is then that of the plane
/// in which they lie, or if they are parallel any normal of theirs.
SegmentGap segment_gap(const std::array<Eigen::Vector3d, 4>& vertices);

}  // namespace ringlet
