#pragma once

#include <vector>

#include "collision/box_tree.h"
#include "collision/colliders/surface_normals.h"
#include "core/vector3.h"

namespace ringlet {

/// Up to eight neighbouring triangles side by side in lanes. Lanes without one repeat the last.
struct TriangleCluster {
  BoundingBox box;
  Vector3<Pack> a, b, c;
  std::array<int, lane_count> triangles;
};

/// Splits the triangles at medians of their centres until no part has more than eight.
std::vector<TriangleCluster> cluster_triangles(const std::vector<SurfaceTriangle>& surface);

}  // namespace ringlet
