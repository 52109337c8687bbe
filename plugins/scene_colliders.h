#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/registry.h"

namespace ringlet {

/// A collider of a scene, and where it is at some times.
struct PlacedCollider {
  std::string type;
  Json parameters;                            ///< its entry in the scene
  std::vector<Eigen::Isometry3d> placements;  ///< one a time
};

/// The colliders of a resolved scene. Where their motion is not known, a note says so.
std::vector<PlacedCollider> place_colliders(const Json& scene, const Registry& registry,
                                            const std::vector<double>& times,
                                            std::vector<std::string>& notes);

/// The note on a collider that is not shown.
std::string not_shown(const std::string& type, const std::string& reason);

}  // namespace ringlet
