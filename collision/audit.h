#pragma once

#include "collision/collider_contacts.h"
#include "collision/continuous_detection.h"

namespace ringlet {

/// Checks steps, whatever the response to contacts, along the way that they took: from the first
/// positions over every Newton iterate to the last, all vertices moving along straight lines from
/// one to the next; as seen from their common motion up to the first iterate, which carries all.
///
/// The straight way from the first positions to the last would not do: tips slide around each other
/// in more than one iteration, and edges that touch turn about each other, where it cuts through.
class Audit {
 public:
  /// The arguments outlive this. continuous: null: strands do not feel each other.
  Audit(ContinuousDetection* continuous, const ColliderContacts& colliders)
      : continuous_(continuous), colliders_(colliders) {}

  void begin_step(std::span<const Eigen::Vector3d> positions);
  /// The step goes on to these positions.
  void follow(std::span<const Eigen::Vector3d> positions);
  /// The step has ended where it was followed to. Reports how many pairs are through each other,
  /// not counting those that went back, and how deep a vertex is in a collider.
  void end_step(ContactReport& report) const;

 private:
  ContinuousDetection* continuous_;
  const ColliderContacts& colliders_;
  bool is_first_way_ = true;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<EdgePair> crossings_;  // pairs that passed each other an odd number of times; sorted
};

}  // namespace ringlet
