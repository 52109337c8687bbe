// Signed distance of a half-space: n . (x - p).

#include "collision/colliders/pointwise_collider.h"

namespace ringlet {
namespace {

struct Plane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  ColliderPlacement placement;

  static Schema<Plane> schema() {
    return Schema<Plane>()
        .key("point", &Plane::point, "m", any_number(), "any point of the plane")
        .required("normal", &Plane::normal, "", any_number(),
                  "direction, of any length, out of the solid half of space")
        .include(&Plane::placement)
        .check([](Plane& plane, const std::string& pointer, ParseContext& context) {
          const double length = plane.normal.stableNorm();
          if (length > 0 && std::isfinite(length)) {
            plane.normal.stableNormalize();
          } else {
            context.problem(pointer_to(pointer, "normal"), "expected a direction, not length zero");
          }
        });
  }

  Proximity proximity(const Eigen::Vector3d& at) const { return {normal.dot(at - point), normal}; }
};

}  // namespace

void register_plane_collider(Registry& registry);
void register_plane_collider(Registry& registry) {
  add_pointwise_collider<Plane>(registry, "plane", {"a solid half of space", "n . (x - p)", ""});
}

}  // namespace ringlet
