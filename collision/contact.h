#pragma once

#include <array>

#include "collision/segment_gap.h"
#include "core/contact_energy.h"
#include "core/couplings.h"
#include "core/vertex_field.h"

namespace ringlet {

/// A contact of up to four vertices, as it is at some positions. With d, the gap of two segments
/// (SegmentGap) or the distance of a vertex from a collider, and its derivative w_i n,
///
///     dE/dx_i = E'(d) w_i n,    d2E/dx_i dx_j ~ E''(d) w_i w_j n n^T
///
/// The gradient is exact. The Hessian is that of Gauss and Newton. For fixed closest points it is
/// also the exact one with its negative eigenvalues, those of E'(d)/d (I - n n^T), clamped at zero.
struct Contact {
  std::array<int, 4> vertices;
  std::array<double, 4> weights;  ///< 0: the vertex takes no part
  Eigen::Vector3d normal;         ///< n, unit
  double depth;                   ///< thickness minus d, m
  DistanceEnergy energy;

  CouplingTerm term() const {
    return {vertices, weights, energy.slope * normal,
            energy.curvature * normal * normal.transpose()};
  }
};

}  // namespace ringlet
