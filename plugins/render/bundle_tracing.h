#pragma once

#include <array>

#include "plugins/render/bundles.h"

namespace ringlet {

/// A ray, and two directions across it: where they are both 0, a point is on the ray.
struct RayFrame {
  RayFrame(const Eigen::Vector3f& start, const Eigen::Vector3f& direction);

  Eigen::Vector3f origin, along, first, second;
};

/// A tube of two straight pieces around all hairs of a segment of a bundle.
struct Tube {
  Eigen::Vector3f start, middle, end;
  float radius;  ///< m
};

/// Around the straight pieces that trace() meets. `points` are the four of the segment, `radius` is
/// that of the thickest hair.
Tube tube_around(const LanePoints* points, float radius);

/// Whether a ray may meet what is in a tube between two distances.
bool may_meet(const Tube& tube, const RayFrame& ray, float from, float to);

/// Where a ray meets the hairs of a segment of a bundle, one in each lane.
struct LaneHits {
  alignas(64) float distance[hair_lanes];  ///< m; that of the ray's end where it meets none
  alignas(64) float u[hair_lanes];         ///< of the curve, in [0, 1]
};

/// Meets hairs as ribbons that face the ray, between two distances. `radii` are those at both ends
/// of the segment, whose four points follow each other.
LaneHits trace(const LanePoints* points, const float* radii, const RayFrame& ray, float from,
               float to);

/// The box around all that trace() meets of a segment: low and high corner.
std::array<Eigen::Vector3f, 2> bounds(const LanePoints* points, float radius);

}  // namespace ringlet
