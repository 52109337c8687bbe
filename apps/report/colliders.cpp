#include "apps/report/colliders.h"

#include <spdlog/fmt/fmt.h>

#include <set>

#include "apps/report/packed_text.h"
#include "collision/colliders/obj_mesh.h"
#include "core/motion.h"
#include "core/read_choice.h"

namespace ringlet {
namespace {

/// Shapes that the page draws from their parameters alone.
const std::set<std::string> simple_shapes{"sphere", "capsule", "box", "plane"};
const std::set<std::string> mesh_shapes{"mesh", "sdf"};

Motions make_motions(const Json& scene, const Registry& registry) {
  Motions motions;
  if (!scene.contains("motions")) return motions;
  for (const auto& [name, parts] : scene["motions"].items()) {
    std::vector<std::unique_ptr<Motion>> made;
    for (const Json& part : parts) made.push_back(make_chosen<Motion>(registry, part));
    motions.add(name, std::move(made));
  }
  return motions;
}

Json describe_poses(const Motions& motions, const std::string& name,
                    const std::vector<double>& times) {
  Json poses = Json::array();
  for (const double time : times) {
    const Eigen::Isometry3d placement = motions.at(name, time);
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

Json describe_collider(const Json& collider, const Motions& motions,
                       const std::vector<double>& times) {
  const std::string type = collider.at("type");
  Json shape = collider;
  if (mesh_shapes.contains(type)) {
    add_triangles(collider.at("path"), shape);
  } else if (!simple_shapes.contains(type)) {
    throw Error("the page knows no such shape");
  }
  shape["poses"] = describe_poses(motions, collider.value("motion", ""), times);
  return shape;
}

}  // namespace

Json describe_colliders(const Json& scene, const Registry& registry,
                        const std::vector<double>& times, std::vector<std::string>& notes) {
  Json described = Json::array();
  const Json colliders = scene.value("/collision/colliders"_json_pointer, Json::array());
  if (colliders.empty()) return described;
  try {
    const Motions motions = make_motions(scene, registry);
    for (const Json& collider : colliders) {
      try {
        described.push_back(describe_collider(collider, motions, times));
      } catch (const std::exception& error) {
        notes.push_back(fmt::format("The collider '{}' is not shown: {}.",
                                    collider.value("type", "?"), error.what()));
      }
    }
  } catch (const std::exception& error) {
    notes.push_back(fmt::format(
        "The colliders are not shown, since where they are is not known: {}.", error.what()));
  }
  return described;
}

}  // namespace ringlet
