#pragma once

namespace ringlet {

/// A contact energy E(d) of a distance, J, and its first two derivatives.
struct DistanceEnergy {
  double value = 0;
  double slope = 0;      ///< dE/dd, N; minus the magnitude of the force that pushes apart
  double curvature = 0;  ///< d2E/dd2, N/m
};

/// The quadratic penalty of what comes nearer than a thickness h:
///
///     E(d) = k/2 (h - d)^2  for d < h, else 0
///
/// as in "Lifted Curls" (Shi et al., SCA 2023), where contacts are implicit springs.
struct Penalty {
  double thickness;  ///< h, m
  double stiffness;  ///< k, N/m

  DistanceEnergy at(double distance) const {
    const double depth = thickness - distance;
    if (!(depth > 0)) return {};
    return {0.5 * stiffness * depth * depth, -stiffness * depth, stiffness};
  }
};

}  // namespace ringlet
