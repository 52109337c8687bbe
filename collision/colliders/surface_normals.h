#pragma once

#include <array>
#include <span>
#include <vector>

#include "collision/colliders/obj_mesh.h"

namespace ringlet {

/// The surface of a mesh: triangles with area, and the pseudo-normals of their faces, edges and
/// vertices. The sign of the offset from the closest point along the pseudo-normal of the feature
/// on which this point lies says on which side of the surface a point is (Baerentzen and Aanaes,
/// "Signed distance computation using the angle weighted pseudonormal", 2005).
struct SurfaceTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  Eigen::Vector3d face_normal;
  std::array<Eigen::Vector3d, 3> edge_normals;    ///< of the edge opposite to each corner
  std::array<Eigen::Vector3d, 3> vertex_normals;  ///< of each corner

  /// The unit pseudo-normal of the feature that a point in barycentric coordinates lies on.
  const Eigen::Vector3d& normal_at(const std::array<double, 3>& weights) const;
};

/// Vertices at the same place count as one; triangles without area are left out. Outside is where
/// corners turn counter-clockwise.
std::vector<SurfaceTriangle> make_surface(const IndexedTriangles& mesh);

}  // namespace ringlet
