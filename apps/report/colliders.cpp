#include "apps/report/colliders.h"

#include <set>

#include "apps/report/packed_text.h"
#include "collision/colliders/obj_mesh.h"
#include "plugins/scene_colliders.h"

namespace ringlet {
namespace {

/// Shapes that the page draws from their parameters alone.
const std::set<std::string> simple_shapes{"sphere", "capsule", "box", "plane"};
const std::set<std::string> mesh_shapes{"mesh", "sdf"};

Json describe_poses(const std::vector<Eigen::Isometry3d>& placements) {
  Json poses = Json::array();
  for (const Eigen::Isometry3d& placement : placements) {
    const Eigen::Vector3d x = placement.translation();
    const Eigen::Quaterniond q(placement.rotation());
    poses.push_back({x.x(), x.y(), x.z(), q.x(), q.y(), q.z(), q.w()});
  }
  return poses;
}

void add_triangles(const std::string& path, Json& shape) {
  const IndexedTriangles mesh = read_obj_mesh(path);
  std::vector<float> vertices;
  std::vector<std::uint32_t> triangles;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    for (const double coordinate : vertex) vertices.push_back(static_cast<float>(coordinate));
  }
  for (const auto& triangle : mesh.triangles) {
    for (const int corner : triangle) triangles.push_back(static_cast<std::uint32_t>(corner));
  }
  shape["vertices"] = pack_numbers(vertices);
  shape["triangles"] = pack_numbers(triangles);
}

Json describe_collider(const PlacedCollider& collider) {
  Json shape = collider.parameters;
  if (mesh_shapes.contains(collider.type)) {
    add_triangles(shape.at("path"), shape);
  } else if (!simple_shapes.contains(collider.type)) {
    throw Error("the page knows no such shape");
  }
  shape["poses"] = describe_poses(collider.placements);
  return shape;
}

}  // namespace

Json describe_colliders(const Json& scene, const Registry& registry,
                        const std::vector<double>& times, std::vector<std::string>& notes) {
  Json described = Json::array();
  for (const PlacedCollider& collider : place_colliders(scene, registry, times, notes)) {
    try {
      described.push_back(describe_collider(collider));
    } catch (const std::exception& error) {
      notes.push_back(not_shown(collider.type, error.what()));
    }
  }
  return described;
}

}  // namespace ringlet
