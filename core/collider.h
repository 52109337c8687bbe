#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>

#include "core/named.h"
#include "core/parameters.h"

namespace ringlet {

/// How near a point is to a collider.
struct Proximity {
  double distance;         ///< signed, m; negative inside
  Eigen::Vector3d normal;  ///< unit; the direction of growing distance
};

/// What every collider has in common: how it moves and whether it holds strands.
struct ColliderPlacement {
  MotionName motion;
  bool pins = false;

  static Schema<ColliderPlacement> schema() {
    return Schema<ColliderPlacement>()
        .key("motion", &ColliderPlacement::motion, "", any_number(),
             "name of the motion that the collider follows; empty: it rests")
        .key("pins", &ColliderPlacement::pins, "", any_number(),
             "whether vertices that start inside are pinned to it and follow its motion");
  }
};

/// A rigid body that strands may touch, described in its own frame, which its motion places.
class Collider : public Named {
 public:
  virtual ~Collider() = default;
  virtual const ColliderPlacement& placement() const = 0;
  /// Proximity of each of some neighbouring points, or nothing for one that is further outside than
  /// `reach`. A body that is only a surface gives nothing for a point deeper inside than a depth of
  /// its own either. Called from several threads at once; found has the size of points.
  virtual void near(std::span<const Eigen::Vector3d> points, double reach,
                    std::span<std::optional<Proximity>> found) const = 0;
};

}  // namespace ringlet
