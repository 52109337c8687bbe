#include "collision/colliders/mesh_distance.h"

#include "collision/colliders/nearest_triangle.h"
#include "collision/colliders/triangle_distance.h"

namespace ringlet {
namespace {

std::vector<BoundingBox> boxes_of(const std::vector<TriangleCluster>& clusters) {
  std::vector<BoundingBox> boxes;
  for (const TriangleCluster& cluster : clusters) boxes.push_back(cluster.box);
  return boxes;
}

}  // namespace

MeshDistance::MeshDistance(const IndexedTriangles& mesh, const std::filesystem::path& file)
    : surface_(make_surface(mesh)),
      clusters_(cluster_triangles(surface_)),
      tree_(boxes_of(clusters_)) {
  if (surface_.empty()) throw Error("'" + file.string() + "' has no triangle with an area");
  for (const TriangleCluster& cluster : clusters_) box_.extend(cluster.box);
  rounding_ = 1e-12 * box_.diagonal().norm();
}

void MeshDistance::near(std::span<const Eigen::Vector3d> points, double reach, double depth,
                        std::span<std::optional<Proximity>> found) const {
  BoundingBox box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  const double search = std::max(reach, depth);
  const Eigen::Vector3d growth = Eigen::Vector3d::Constant(search + rounding_);
  std::vector<int> near_clusters;
  tree_.find_overlapping(BoundingBox(box.min() - growth, box.max() + growth), near_clusters);
  NearestTriangle nearest(clusters_, near_clusters, rounding_);
  for (std::size_t n = 0; n < points.size(); ++n) {
    const NearTriangle hit = nearest.find(points[n], search);
    found[n].reset();
    if (hit.triangle < 0) continue;
    const Proximity proximity =
        hit.above_face ? *hit.above_face : measure(points[n], surface_[hit.triangle]);
    if (proximity.distance <= reach && proximity.distance >= -depth) found[n] = proximity;
  }
}

Proximity MeshDistance::measure(const Eigen::Vector3d& point,
                                const SurfaceTriangle& triangle) const {
  const auto& [a, b, c] = triangle.corners;
  const auto weights =
      closest_point(from_eigen(point), from_eigen(a), from_eigen(b), from_eigen(c)).weights;
  const Eigen::Vector3d offset = point - (weights[0] * a + weights[1] * b + weights[2] * c);
  const Eigen::Vector3d& normal = triangle.normal_at(weights);
  const double side = offset.dot(normal) < 0 ? -1 : 1;
  const double distance = offset.norm();
  if (distance <= rounding_) return {side * distance, normal};
  return {side * distance, side / distance * offset};
}

}  // namespace ringlet
