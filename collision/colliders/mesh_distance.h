#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "collision/box_tree.h"
#include "collision/colliders/surface_normals.h"
#include "collision/colliders/triangle_clusters.h"
#include "core/collider.h"

namespace ringlet {

/// The exact signed distance of a triangle mesh: that of the nearest point of any triangle, with
/// the sign of the pseudo-normal there (surface_normals.h). FCL finds the clusters of triangles
/// near some points; these are measured a cluster at a time (nearest_triangle.h).
class MeshDistance {
 public:
  /// Throws Error, which names the file, if no triangle has an area.
  MeshDistance(const IndexedTriangles& mesh, const std::filesystem::path& file);

  /// The box around the mesh.
  const BoundingBox& box() const { return box_; }
  /// Proximity of each of some neighbouring points, or nothing for one that is further outside than
  /// `reach` or deeper inside than `depth`, m.
  void near(std::span<const Eigen::Vector3d> points, double reach, double depth,
            std::span<std::optional<Proximity>> found) const;

 private:
  Proximity measure(const Eigen::Vector3d& point, const SurfaceTriangle& triangle) const;

  std::vector<SurfaceTriangle> surface_;
  std::vector<TriangleCluster> clusters_;
  BoxTree tree_;
  BoundingBox box_;
  double rounding_;  // of a distance to the mesh, m
};

}  // namespace ringlet
