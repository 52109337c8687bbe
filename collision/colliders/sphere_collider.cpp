// Signed distance of a sphere: |x - c| - r.

#include "collision/colliders/pointwise_collider.h"

namespace ringlet {
namespace {

struct Sphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
  ColliderPlacement placement;

  static Schema<Sphere> schema() {
    return Schema<Sphere>()
        .key("centre", &Sphere::centre, "m", any_number(), "of the sphere")
        .required("radius", &Sphere::radius, "m", positive(), "of the sphere")
        .include(&Sphere::placement);
  }

  Proximity proximity(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from_centre = point - centre;
    const double length = from_centre.norm();
    if (length == 0) return {-radius, Eigen::Vector3d::UnitZ()};
    return {length - radius, from_centre / length};
  }
};

}  // namespace

void register_sphere_collider(Registry& registry);
void register_sphere_collider(Registry& registry) {
  add_pointwise_collider<Sphere>(registry, "sphere", {"a ball", "|x - c| - r", ""});
}

}  // namespace ringlet
