// Signed distance of a triangle mesh: that of the nearest point of any triangle, with the sign of
// the pseudo-normal there (surface_normals.h). FCL finds the clusters of triangles near some
// points; these are measured eight triangles at a time.

#include <limits>

#include "collision/colliders/surface_normals.h"
#include "collision/colliders/triangle_clusters.h"
#include "collision/colliders/triangle_distance.h"
#include "core/collider.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct MeshParameters {
  ScenePath path;
  double depth = 0.01;
  ColliderPlacement placement;

  static Schema<MeshParameters> schema() {
    using P = MeshParameters;
    return Schema<P>()
        .required("path", &P::path, "", any_number(), "a Wavefront .obj file, coordinates in m")
        .key("depth", &P::depth, "m", positive(),
             "how far below the surface a vertex still counts as inside")
        .include(&P::placement);
  }
};

std::vector<BoundingBox> boxes_of(const std::vector<TriangleCluster>& clusters) {
  std::vector<BoundingBox> boxes;
  for (const TriangleCluster& cluster : clusters) boxes.push_back(cluster.box);
  return boxes;
}

class MeshCollider final : public Collider {
 public:
  explicit MeshCollider(const MeshParameters& parameters)
      : parameters_(parameters),
        surface_(make_surface(read_obj_mesh(parameters.path.absolute))),
        clusters_(cluster_triangles(surface_)),
        tree_(boxes_of(clusters_)) {
    if (surface_.empty()) {
      throw Error("'" + parameters.path.absolute.string() + "' has no triangle with an area");
    }
    BoundingBox box;
    for (const TriangleCluster& cluster : clusters_) box.extend(cluster.box);
    rounding_ = 1e-12 * box.diagonal().norm();
  }

  const ColliderPlacement& placement() const override { return parameters_.placement; }

  void near(std::span<const Eigen::Vector3d> points, double reach,
            std::span<std::optional<Proximity>> found) const override {
    BoundingBox box;
    for (const Eigen::Vector3d& point : points) box.extend(point);
    const double search = std::max(reach, parameters_.depth);
    const Eigen::Vector3d growth = Eigen::Vector3d::Constant(search + rounding_);
    std::vector<int> near_clusters;
    tree_.find_overlapping(BoundingBox(box.min() - growth, box.max() + growth), near_clusters);
    for (std::size_t n = 0; n < points.size(); ++n) {
      const int triangle = nearest_triangle(points[n], near_clusters, search);
      found[n].reset();
      if (triangle < 0) continue;
      const Proximity proximity = measure(points[n], surface_[triangle]);
      if (proximity.distance <= reach && proximity.distance >= -parameters_.depth) {
        found[n] = proximity;
      }
    }
  }

 private:
  // The nearest of the clusters' triangles, or -1 if none is nearer than the search distance.
  int nearest_triangle(const Eigen::Vector3d& point, const std::vector<int>& clusters,
                       double search) const {
    const Vector3<Pack> p{Pack(point.x()), Pack(point.y()), Pack(point.z())};
    double least = search * search * (1 + 1e-12);
    int nearest = -1;
    for (const int c : clusters) {
      const TriangleCluster& cluster = clusters_[c];
      if (cluster.box.squaredExteriorDistance(point) > least) continue;
      const Pack squared_distance =
          closest_point(p, cluster.a, cluster.b, cluster.c).squared_distance;
      if (!any(squared_distance <= least)) continue;
      for (int lane = 0; lane < lane_count; ++lane) {
        const double candidate = squared_distance[lane];
        const int triangle = cluster.triangles[lane];
        // Of equally near ones the first in the file, whatever the order of the clusters.
        if (candidate > least || (candidate == least && nearest >= 0 && triangle > nearest))
          continue;
        least = candidate;
        nearest = triangle;
      }
    }
    return nearest;
  }

  Proximity measure(const Eigen::Vector3d& point, const SurfaceTriangle& triangle) const {
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

  MeshParameters parameters_;
  std::vector<SurfaceTriangle> surface_;
  std::vector<TriangleCluster> clusters_;
  BoxTree tree_;
  double rounding_;  // of a distance to the mesh, m
};

}  // namespace

void register_mesh_collider(Registry& registry);
void register_mesh_collider(Registry& registry) {
  registry.of<Collider>().add<MeshParameters>(
      "mesh",
      {"a surface of triangles", "",
       "sign: Baerentzen and Aanaes, Signed distance computation using the angle weighted "
       "pseudonormal, 2005"},
      [](const MeshParameters& parameters) { return std::make_unique<MeshCollider>(parameters); });
}

}  // namespace ringlet
