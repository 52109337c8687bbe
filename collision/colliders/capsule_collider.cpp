// Signed distance of a capsule: that of x from the segment a b, less the radius.

#include <algorithm>

#include "collision/colliders/pointwise_collider.h"
#include "core/vector3.h"

namespace ringlet {
namespace {

struct Capsule {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double radius = 0;
  ColliderPlacement placement;

  static Schema<Capsule> schema() {
    return Schema<Capsule>()
        .required("from", &Capsule::from, "m", any_number(), "one end of the axis")
        .required("to", &Capsule::to, "m", any_number(), "the other end of the axis")
        .required("radius", &Capsule::radius, "m", positive(),
                  "distance of the surface from the axis")
        .include(&Capsule::placement);
  }

  Proximity proximity(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d axis = to - from;
    const double squared_length = axis.squaredNorm();
    const double along = squared_length > 0 ? (point - from).dot(axis) / squared_length : 0;
    const Eigen::Vector3d across = point - (from + std::clamp(along, 0.0, 1.0) * axis);
    const double length = across.norm();
    if (length > 0) return {length - radius, across / length};
    if (squared_length > 0) return {-radius, to_eigen(any_normal(from_eigen(axis)))};
    return {-radius, Eigen::Vector3d::UnitZ()};
  }
};

}  // namespace

void register_capsule_collider(Registry& registry);
void register_capsule_collider(Registry& registry) {
  add_pointwise_collider<Capsule>(
      registry, "capsule",
      {"a cylinder with round ends", "min over s of |x - a - s (b - a)| - r", ""});
}

}  // namespace ringlet
