#pragma once

#include <memory>

#include "core/collider.h"
#include "core/registry.h"

namespace ringlet {

/// Makes a Collider of a shape whose signed distance has a closed form. A Shape is a parameter
/// struct with a member `placement` and a function `Proximity proximity(point) const`.
template <class Shape>
class PointwiseCollider final : public Collider {
 public:
  explicit PointwiseCollider(const Shape& shape) : shape_(shape) {}

  const ColliderPlacement& placement() const override { return shape_.placement; }
  void near(std::span<const Eigen::Vector3d> points, double reach,
            std::span<std::optional<Proximity>> found) const override {
    for (std::size_t n = 0; n < points.size(); ++n) {
      const Proximity proximity = shape_.proximity(points[n]);
      if (proximity.distance <= reach) {
        found[n] = proximity;
      } else {
        found[n].reset();
      }
    }
  }

 private:
  Shape shape_;
};

template <class Shape>
void add_pointwise_collider(Registry& registry, const std::string& name, Description description) {
  registry.of<Collider>().add<Shape>(name, std::move(description), [](const Shape& shape) {
    return std::make_unique<PointwiseCollider<Shape>>(shape);
  });
}

}  // namespace ringlet
