#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/huge_pages.h"

namespace ringlet {

/// Remembers where some points were and tells how far they have moved since, apart from a rigid
/// motion of them all: that changes no distance between them.
class Movement {
 public:
  void start_from(std::span<const Eigen::Vector3d> positions);
  bool has_started() const { return !start_.empty(); }
  /// Where they started. Empty if they have not.
  std::span<const Eigen::Vector3d> start() const { return start_; }

  /// A rigid motion that brings the points from the start close to these positions.
  Eigen::Isometry3d rigid_part(std::span<const Eigen::Vector3d> positions) const;
  /// Whether every point is within a distance, m, of where a rigid motion takes it from the start.
  bool is_within(double distance, std::span<const Eigen::Vector3d> positions,
                 const Eigen::Isometry3d& motion) const;
  /// The points that are not within a distance.
  std::vector<int> beyond(double distance, std::span<const Eigen::Vector3d> positions,
                          const Eigen::Isometry3d& motion) const;
  /// Lets some points start anew, as if the rigid motion had brought them to these positions.
  void restart(std::span<const int> points, std::span<const Eigen::Vector3d> positions,
               const Eigen::Isometry3d& motion);

 private:
  /// body(begin, end) for stretches of the points, in parallel.
  template <class Body>
  void for_each_stretch(const Body& body) const;

  StreamedVector<Eigen::Vector3d> start_;
};

/// Moves all of the start by the rigid motion that brings it close to the end: that brings nothing
/// nearer to anything, and leaves short ways to go.
void bring_to(std::span<const Eigen::Vector3d> end, std::vector<Eigen::Vector3d>& start);

}  // namespace ringlet
