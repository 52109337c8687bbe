#pragma once

#include <optional>
#include <span>
#include <vector>

#include "collision/colliders/triangle_clusters.h"
#include "core/collider.h"

namespace ringlet {

/// The triangle nearest to a point.
struct NearTriangle {
  double squared_distance;  ///< m^2
  int triangle = -1;        ///< -1: none is near enough
  /// Signed distance and normal, if the nearest point lies neither on an edge nor on a vertex.
  std::optional<Proximity> above_face;
};

/// Looks among some clusters of triangles for the nearest one to each of some neighbouring points.
class NearestTriangle {
 public:
  /// rounding: of a distance, m. The clusters outlive this.
  NearestTriangle(const std::vector<TriangleCluster>& all, std::span<const int> near,
                  double rounding);

  /// The triangle nearest to a point and no further away than `reach`, m. Of equally near ones the
  /// first, whatever the order of the clusters.
  NearTriangle find(const Eigen::Vector3d& point, double reach);

 private:
  /// Boxes around clusters, one a lane.
  struct Boxes {
    Vector3<Pack> low, high;
  };
  void look_into(int cluster, const Vector3<Pack>& point, NearTriangle& best);

  const std::vector<TriangleCluster>& all_;
  std::span<const int> near_;
  std::vector<Boxes> boxes_;  // of the near ones
  int likely_ = 0;            // which of the near ones has the triangle nearest to the last point
};

}  // namespace ringlet
