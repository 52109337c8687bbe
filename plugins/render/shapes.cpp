#include "plugins/render/shapes.h"

#include "collision/colliders/obj_mesh.h"

namespace ringlet {
namespace {

Eigen::Vector3d vector_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Triangles box(const Eigen::Vector3d& centre, const Eigen::Vector3d& size) {
  Triangles box;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign{corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5,
                               corner & 4 ? 0.5 : -0.5};
    box.vertices.push_back(centre + sign.cwiseProduct(size));
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int a = 1 << axis, b = 1 << (axis + 1) % 3, c = 1 << (axis + 2) % 3;
    box.corners.push_back({0, c, b + c});
    box.corners.push_back({0, b + c, b});
    box.corners.push_back({a, a + b, a + b + c});
    box.corners.push_back({a, a + b + c, a + c});
  }
  return box;
}

Triangles mesh(const std::string& path) {
  IndexedTriangles read = read_obj_mesh(path);
  return {std::move(read.vertices), std::move(read.triangles)};
}

struct Mover {
  const Eigen::Isometry3d& placement;

  DrawnShape operator()(const Ball& ball) const {
    return Ball{placement * ball.centre, ball.radius};
  }
  DrawnShape operator()(const Capsule& capsule) const {
    return Capsule{placement * capsule.from, placement * capsule.to, capsule.radius};
  }
  DrawnShape operator()(const Plane& plane) const {
    return Plane{placement * plane.point, placement.linear() * plane.normal};
  }
  DrawnShape operator()(const Triangles& triangles) const {
    Triangles moved_triangles = triangles;
    for (Eigen::Vector3d& vertex : moved_triangles.vertices) vertex = placement * vertex;
    return moved_triangles;
  }
};

}  // namespace

DrawnShape shape_of(const PlacedCollider& collider) {
  const Json& entry = collider.parameters;
  if (collider.type == "sphere") return Ball{vector_of(entry.at("centre")), entry.at("radius")};
  if (collider.type == "capsule") {
    return Capsule{vector_of(entry.at("from")), vector_of(entry.at("to")), entry.at("radius")};
  }
  if (collider.type == "box")
    return box(vector_of(entry.at("centre")), vector_of(entry.at("size")));
  if (collider.type == "plane") {
    return Plane{vector_of(entry.at("point")), vector_of(entry.at("normal")).normalized()};
  }
  if (collider.type == "mesh" || collider.type == "sdf") return mesh(entry.at("path"));
  throw Error("there is no picture of such a shape");
}

DrawnShape moved(const DrawnShape& shape, const Eigen::Isometry3d& placement) {
  return std::visit(Mover{placement}, shape);
}

}  // namespace ringlet
