// The exact signed distance of a triangle mesh (mesh_distance.h).

#include "collision/colliders/mesh_distance.h"
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

class MeshCollider final : public Collider {
 public:
  explicit MeshCollider(const MeshParameters& parameters)
      : parameters_(parameters),
        distance_(read_obj_mesh(parameters.path.absolute), parameters.path.absolute) {}

  const ColliderPlacement& placement() const override { return parameters_.placement; }
  void near(std::span<const Eigen::Vector3d> points, double reach,
            std::span<std::optional<Proximity>> found) const override {
    distance_.near(points, reach, parameters_.depth, found);
  }

 private:
  MeshParameters parameters_;
  MeshDistance distance_;
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
