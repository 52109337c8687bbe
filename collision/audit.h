#pragma once

#include <optional>

#include "collision/collider_contacts.h"
#include "collision/continuous_detection.h"

namespace ringlet {

/// Checks steps, whatever led through them: on the straight way from the first to the last
/// positions, as seen from the common motion of all vertices.
class Audit {
 public:
  /// The arguments outlive this. continuous: null: strands do not feel each other.
  Audit(ContinuousDetection* continuous, const ColliderContacts& colliders)
      : continuous_(continuous), colliders_(colliders) {}

  void begin_step(std::span<const Eigen::Vector3d> positions) {
    start_.assign(positions.begin(), positions.end());
  }
  /// Reports the pairs that passed through each other, and how deep a vertex is in a collider.
  void end_step(std::span<const Eigen::Vector3d> positions, ContactReport& report);

 private:
  ContinuousDetection* continuous_;
  const ColliderContacts& colliders_;
  std::vector<Eigen::Vector3d> start_;
};

}  // namespace ringlet
