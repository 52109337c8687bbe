#pragma once

#include "core/named.h"

namespace ringlet {

/// A contact energy E(d) of a distance, J, and its first two derivatives.
struct DistanceEnergy {
  double value = 0;
  double slope = 0;      ///< dE/dd, N; minus the magnitude of the force that pushes apart
  double curvature = 0;  ///< d2E/dd2, N/m
};

/// How hard what is in contact is pushed apart: a function of the distance d of two edges, or of a
/// vertex and a collider.
class ContactEnergy : public Named {
 public:
  virtual ~ContactEnergy() = default;
  /// Zero, with its slope, from the thickness h, m, on; below it falls with growing distance and is
  /// convex. Proportional to the stiffness, N/m. The distance is negative inside of a collider.
  virtual DistanceEnergy at(double distance, double thickness, double stiffness) const = 0;
  /// Whether the energy is infinite where the distance is not positive: a step must then stop
  /// before.
  virtual bool is_barrier() const = 0;
};

}  // namespace ringlet
