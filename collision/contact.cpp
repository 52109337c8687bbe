#include "collision/contact.h"

#include "collision/segment_distance.h"

namespace ringlet {
namespace {

// A unit vector normal to two edges that meet; of either edge alone, if the other has no length or
// the same direction; of nothing, if both have no length.
Vector3<double> crossing_normal(const Vector3<double>& d, const Vector3<double>& e) {
  const Vector3<double> across = cross(d, e);
  const double length = norm(across), scale = norm(d) * norm(e);
  if (length > 1e-12 * scale) return 1 / length * across;
  if (squared_norm(d) > 0) return any_normal(d);
  if (squared_norm(e) > 0) return any_normal(e);
  return {1, 0, 0};
}

}  // namespace

SegmentGap segment_gap(const std::array<Eigen::Vector3d, 4>& vertices) {
  const Vector3<double> p0 = from_eigen(vertices[0]), p1 = from_eigen(vertices[1]);
  const Vector3<double> q0 = from_eigen(vertices[2]), q1 = from_eigen(vertices[3]);
  const auto [s, t, squared_distance] = closest_points(p0, p1, q0, q1);
  const double distance = sqrt(squared_distance);
  SegmentGap gap{distance, {1 - s, s, t - 1, -t}, {}};
  if (distance > 0) {
    const Vector3<double> apart = (p0 - q0) + s * (p1 - p0) - t * (q1 - q0);
    gap.normal = to_eigen(apart) / distance;
  } else {
    gap.normal = to_eigen(crossing_normal(p1 - p0, q1 - q0));
  }
  return gap;
}

}  // namespace ringlet
