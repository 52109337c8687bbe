// Signed distance of a torus: with h the part of x - c along the axis and q the rest,
//
//     sqrt((|q| - R)^2 + h^2) - r

#include "collision/colliders/pointwise_collider.h"
#include "core/direction.h"
#include "core/plugin.h"
#include "core/vector3.h"

namespace {

using namespace ringlet;

struct Ring {
  double radius = 0;
  double tube_radius = 0;
  Direction axis;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  ColliderPlacement placement;

  static Schema<Ring> schema() {
    return Schema<Ring>()
        .required("radius", &Ring::radius, "m", positive(), "R, of the circle inside the tube")
        .required("tube_radius", &Ring::tube_radius, "m", positive(), "r, of the tube itself")
        .key("axis", &Ring::axis, "", any_number(), "normal to the plane of the circle")
        .key("centre", &Ring::centre, "m", any_number(), "c, of the circle")
        .include(&Ring::placement)
        .check(check_hole);
  }

  static void check_hole(Ring& ring, const std::string& pointer, ParseContext& context) {
    if (ring.tube_radius < ring.radius) return;
    context.problem(pointer_to(pointer, "tube_radius"),
                    "expected a tube that leaves a hole, thinner than the radius " +
                        std::to_string(ring.radius) + " m, found " +
                        std::to_string(ring.tube_radius));
  }

  Proximity proximity(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from_centre = point - centre;
    const double height = axis.unit.dot(from_centre);
    const Eigen::Vector3d across = from_centre - height * axis.unit;
    // On the axis the whole circle is equally near.
    const Eigen::Vector3d outward = across.norm() > 0 ? Eigen::Vector3d(across.normalized())
                                                      : to_eigen(any_normal(from_eigen(axis.unit)));
    const Eigen::Vector3d from_circle = (across.norm() - radius) * outward + height * axis.unit;
    const double distance = from_circle.norm();
    return {distance - tube_radius,
            distance > 0 ? Eigen::Vector3d(from_circle / distance) : axis.unit};
  }
};

void register_ring(Registry& registry) {
  add_pointwise_collider<Ring>(registry, "ring",
                               {"a torus, such as a hair tie", "sqrt((|q| - R)^2 + h^2) - r", ""});
}

}  // namespace

RINGLET_PLUGIN(register_ring);
