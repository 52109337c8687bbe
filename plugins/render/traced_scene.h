#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "plugins/render/bundle_geometry.h"
#include "plugins/render/curves.h"
#include "plugins/render/shapes.h"

namespace ringlet {

/// A way of light, m. The direction has length 1.
struct Ray {
  Eigen::Vector3f origin, direction;
  float from = 0, to = std::numeric_limits<float>::infinity();
};

/// What a ray meets first.
struct Hit {
  enum class Kind { hair, collider, plane } kind;
  float distance;          ///< m
  Eigen::Vector3f across;  ///< normal of a surface, tangent of a hair; length 1
  float radius = 0;        ///< of a hair, m
  std::uint64_t hair = 0;  ///< its number
};

/// Hairs and colliders as Embree traces them, relative to an origin near them. Not copyable: Embree
/// refers to the members.
class TracedScene {
 public:
  /// `transmitted` is the part of light that goes straight through a hair of a bundle. Throws
  /// std::bad_alloc if the memory does not suffice.
  TracedScene(Curves curves, Bundles bundles, float transmitted,
              const std::vector<DrawnShape>& shapes, const Eigen::Vector3d& origin);
  ~TracedScene();
  TracedScene(const TracedScene&) = delete;
  TracedScene& operator=(const TracedScene&) = delete;

  std::optional<Hit> nearest(const Ray& ray) const;
  /// Whether light along a ray is stopped. At each hair of a bundle chance decides whether it goes
  /// through, the same way for the same hair and number.
  bool is_shadowed(const Ray& ray, unsigned number) const;

 private:
  struct Surface {
    std::vector<Eigen::Vector3f> normals;  // of the vertices of a mesh; else none
    std::vector<std::array<int, 3>> corners;
  };
  void add_curves();
  void add(const Ball& ball);
  void add(const Capsule& capsule);
  void add(const Plane& plane);
  void add(const Triangles& triangles);
  unsigned attach(RTCGeometry geometry);
  Eigen::Vector3f relative(const Eigen::Vector3d& point) const;
  Hit hit_of(const RTCRayHit& found) const;
  Hit hit_of_curve(const RTCRayHit& found) const;
  Hit hit_of_surface(const RTCRayHit& found) const;

  Eigen::Vector3d origin_;
  Curves curves_;
  BundleGeometry bundles_;
  RTCDevice device_;
  RTCScene scene_;
  unsigned curves_id_ = RTC_INVALID_GEOMETRY_ID, bundles_id_ = RTC_INVALID_GEOMETRY_ID;
  std::vector<Surface> surfaces_;  // by Embree's number
  struct FlatPlane {
    Eigen::Vector3f normal;
    float offset;
  };
  std::vector<FlatPlane> planes_;
};

}  // namespace ringlet
