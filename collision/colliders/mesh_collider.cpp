// Signed distance of a triangle mesh: that of the nearest point of any triangle, with the sign of
// the pseudo-normal there (surface_normals.h). FCL finds the clusters of triangles near some
// points; these are measured a cluster at a time (nearest_triangle.h).

#include "collision/colliders/nearest_triangle.h"
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
    NearestTriangle nearest(clusters_, near_clusters, rounding_);
    for (std::size_t n = 0; n < points.size(); ++n) {
      const NearTriangle hit = nearest.find(points[n], search);
      found[n].reset();
      if (hit.triangle < 0) continue;
      const Proximity proximity =
          hit.above_face ? *hit.above_face : measure(points[n], surface_[hit.triangle]);
      if (proximity.distance <= reach && proximity.distance >= -parameters_.depth) {
        found[n] = proximity;
      }
    }
  }

 private:
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
