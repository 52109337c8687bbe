// Signed distance of a box: outside, that of the nearest point of the box; inside, minus that of
// the nearest face.

#include "collision/colliders/pointwise_collider.h"

namespace ringlet {
namespace {

struct Box {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  ColliderPlacement placement;

  static Schema<Box> schema() {
    return Schema<Box>()
        .key("centre", &Box::centre, "m", any_number(), "of the box")
        .required("size", &Box::size, "m", positive(), "lengths of its edges along x, y and z")
        .include(&Box::placement);
  }

  Proximity proximity(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from_centre = point - centre;
    const Eigen::Vector3d beyond = from_centre.cwiseAbs() - 0.5 * size;
    const Eigen::Vector3d side = from_centre.unaryExpr([](double c) { return c < 0 ? -1.0 : 1.0; });
    const Eigen::Vector3d outside = beyond.cwiseMax(0);
    const double length = outside.norm();
    if (length > 0) return {length, outside.cwiseProduct(side) / length};
    int face = 0;
    const double distance = beyond.maxCoeff(&face);
    return {distance, side[face] * Eigen::Vector3d::Unit(face)};
  }
};

}  // namespace

void register_box_collider(Registry& registry);
void register_box_collider(Registry& registry) {
  add_pointwise_collider<Box>(registry, "box", {"a box along the axes of its own frame", "", ""});
}

}  // namespace ringlet
