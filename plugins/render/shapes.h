#pragma once

#include <Eigen/Geometry>
#include <array>
#include <variant>
#include <vector>

#include "plugins/scene_colliders.h"

namespace ringlet {

// What is drawn of colliders; lengths in m.

struct Ball {
  Eigen::Vector3d centre;
  double radius;
};
struct Capsule {
  Eigen::Vector3d from, to;
  double radius;
};
/// A half-space, seen from the side that the normal, of length 1, points to.
struct Plane {
  Eigen::Vector3d point, normal;
};
struct Triangles {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> corners;
};
using DrawnShape = std::variant<Ball, Capsule, Plane, Triangles>;

/// The shape of a collider where no motion has moved it. Throws Error for a kind that cannot be
/// drawn, or a mesh that cannot be read.
DrawnShape shape_of(const PlacedCollider& collider);
DrawnShape moved(const DrawnShape& shape, const Eigen::Isometry3d& placement);

}  // namespace ringlet
