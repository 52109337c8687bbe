#pragma once

#include <array>
#include <span>

#include "core/contact_detector.h"
#include "core/lanes.h"
#include "core/vertex_field.h"

namespace ringlet {

/// The gap between two segments p0 p1 and q0 q1 as contacts feel it, and its derivative with
/// respect to their vertices, in this order: weights[i] normal.
///
/// The distance of two segments has no derivative where they are parallel: the closest points jump
/// from one end of them to the other. So the gap is
///
///     D^2 = min over s, t in [0, 1] of |p(s) - q(t)|^2 (1 + e ((s - 1/2)^2 + (t - 1/2)^2))
///
/// with e = 0.01. The minimum is at one place only, which moves continuously with the vertices, and
/// so does the derivative. D is zero where the segments cross, and exceeds their distance by no
/// more than a quarter of a percent.
struct SegmentGap {
  double distance;  ///< D, m
  std::array<double, 4> weights;
  Eigen::Vector3d normal;  ///< from q to p, unit
};

/// Where the segments cross, D has no derivative: the normal is then that of the plane in which
/// they lie, or if they are parallel any normal of theirs.
SegmentGap segment_gap(const std::array<Eigen::Vector3d, 4>& vertices);

/// The gaps of up to lane_count pairs of edges, measured side by side.
class SegmentGaps {
 public:
  /// Where no pair is nearer than reach, m, only that is found out.
  SegmentGaps(std::span<const EdgePair> pairs, const VertexField& x, double reach);

  /// No less than reach where a pair is not nearer.
  const Pack& distances() const { return distance_; }
  /// The gap of a pair that is nearer than reach, but does not cross.
  SegmentGap of(int pair) const;

 private:
  Pack distance_;
  std::array<Pack, 4> weights_;
  Vector3<Pack> normal_;
};

}  // namespace ringlet
